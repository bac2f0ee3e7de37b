// vtkAnisotropicRemesher: the contract of its outputs, and the mesh on port 0. (The diagram's
// numbers: TestRemesherDiagram; what the properties change: TestRemesherOptions.)

#include "TestBytes.h"
#include "TestMeasures.h"

#include "vtkAnisotropicRemesher.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkStaticCellLocator.h"

using namespace remesh;
using namespace remesh::test;

namespace
{
constexpr int dimension = 6;
constexpr vtkIdType numberOfSites = 300;
constexpr int lloydIterations = 6;
constexpr int newtonIterations = 4;

double linear(const Point3& p)
{
  return 2.0 * p[0] - 3.0 * p[1] + 0.5 * p[2] + 1.0;
}

vtkSmartPointer<vtkPolyData> makeInput()
{
  auto input = polyDataOf(ellipsoid(4));
  addPointArray<vtkDoubleArray>(input, "Linear", 1, [](const Point3& p, int) { return linear(p); });
  addPointArray<vtkFloatArray>(
    input, "LinearFloat", 2, [](const Point3& p, int c) { return (c + 1) * linear(p); });
  addPointArray<vtkIntArray>(
    input, "Thousandths", 1, [](const Point3& p, int) { return std::round(1000.0 * p[0]); });
  addPointArray<vtkDoubleArray>(input, "Place", 3, [](const Point3& p, int c) { return p[c]; });
  vtkNew<vtkStringArray> names;
  names->SetName("Half");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    names->InsertNextValue(pointOf(input, i)[0] < ellipsoidCenter()[0] ? "low" : "high");
  }
  input->GetPointData()->AddArray(names);
  vtkNew<vtkIntArray> region;
  region->SetName("Region");
  region->SetNumberOfValues(input->GetNumberOfCells());
  region->Fill(3);
  input->GetCellData()->AddArray(region);
  vtkNew<vtkIntArray> year;
  year->SetName("Year");
  year->InsertNextValue(2012);
  input->GetFieldData()->AddArray(year);
  return input;
}

struct Expected
{
  const char* name;
  const char* type;
  int components;
  bool required;
};

/** Every array is one of these, and all the required ones are there. */
void checkArrays(const std::string& where, vtkFieldData* data, vtkIdType tuples,
  const std::vector<Expected>& expected)
{
  std::map<std::string, Expected> byName;
  for (const Expected& each : expected)
  {
    byName[each.name] = each;
    check(!each.required || data->GetAbstractArray(each.name), __FILE__, __LINE__,
      where + " lacks " + each.name);
  }
  std::set<std::string> seen;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = data->GetAbstractArray(k);
    const std::string name = array->GetName() ? array->GetName() : "";
    const auto found = byName.find(name);
    check(found != byName.end(), __FILE__, __LINE__, where + " has an unknown array " + name);
    check(seen.insert(name).second, __FILE__, __LINE__, where + " has two arrays " + name);
    if (found != byName.end())
    {
      const std::string type = array->GetClassName();
      check(type == found->second.type, __FILE__, __LINE__, where + ": " + name + " is a " + type);
      check(array->GetNumberOfComponents() == found->second.components, __FILE__, __LINE__,
        where + ": " + name + " has " + std::to_string(array->GetNumberOfComponents()) +
          " components");
      check(array->GetNumberOfTuples() == tuples, __FILE__, __LINE__,
        where + ": " + name + " has " + std::to_string(array->GetNumberOfTuples()) + " tuples");
    }
  }
}

const char* const idType = "vtkIdTypeArray";
const char* const intType = "vtkIntArray";
const char* const doubleType = "vtkDoubleArray";

void testArrays(vtkAnisotropicRemesher* filter)
{
  vtkPolyData* surface = filter->GetOutput();
  CHECK_EQUAL(surface->GetNumberOfVerts() + surface->GetNumberOfLines(), 0);
  CHECK_EQUAL(surface->GetNumberOfStrips(), 0);
  checkArrays("Surface points", surface->GetPointData(), surface->GetNumberOfPoints(),
    { { "SiteId", idType, 1, true }, { "ComponentId", idType, 1, true },
      { "CellColor", intType, 1, true }, { "CellArea", doubleType, 1, true },
      { "CellMass", doubleType, 1, true }, { "CellEnergy", doubleType, 1, true },
      { "Embedding", doubleType, dimension, true }, { "Normals", doubleType, 3, true },
      { "Linear", doubleType, 1, true }, { "LinearFloat", "vtkFloatArray", 2, true },
      { "Thousandths", "vtkIntArray", 1, true }, { "Place", doubleType, 3, true },
      { "Half", "vtkStringArray", 1, true } });
  CHECK_EQUAL(surface->GetPointData()->GetNormals(), surface->GetPointData()->GetArray("Normals"));
  checkArrays("Surface cells", surface->GetCellData(), surface->GetNumberOfCells(),
    { { "Region", "vtkIntArray", 1, false } });
  checkArrays("Surface field data", surface->GetFieldData(), 1,
    { { "NumberOfNonManifoldEdges", idType, 1, true }, { "EulerCharacteristic", idType, 1, true },
      { "NumberOfExtraPoints", idType, 1, true }, { "Seed", idType, 1, true },
      { "Year", "vtkIntArray", 1, true }, { "NumberOfFlippedTriangles", idType, 1, true },
      { "NumberOfStrayTriangles", idType, 1, true },
      { "NumberOfSelfIntersections", idType, 1, true }, { "TopologyPreserved", idType, 1, true },
      { "MaximumDistance", doubleType, 1, true }, { "RMSDistance", doubleType, 1, true },
      { "NormalSmoothingRadius", doubleType, 1, true } });

  vtkPolyData* cells = filter->GetVoronoiCellsOutput();
  CHECK_EQUAL(cells->GetNumberOfCells(), cells->GetNumberOfPolys());
  checkArrays("VoronoiCells points", cells->GetPointData(), cells->GetNumberOfPoints(),
    { { "Embedding", doubleType, dimension, true } });
  checkArrays("VoronoiCells cells", cells->GetCellData(), cells->GetNumberOfCells(),
    { { "SiteId", idType, 1, true }, { "MergedSiteId", idType, 1, true },
      { "ComponentId", idType, 1, true }, { "PatchId", idType, 1, true },
      { "InputCellId", idType, 1, true }, { "CellColor", intType, 1, true },
      { "CellArea", doubleType, 1, true }, { "CellMass", doubleType, 1, true },
      { "CellEnergy", doubleType, 1, true } });

  vtkPolyData* sites = filter->GetSitesOutput();
  CHECK_EQUAL(sites->GetNumberOfPoints(), numberOfSites);
  CHECK_EQUAL(sites->GetNumberOfCells(), numberOfSites);
  CHECK_EQUAL(sites->GetNumberOfVerts(), numberOfSites);
  checkArrays("Sites points", sites->GetPointData(), numberOfSites,
    { { "SiteId", idType, 1, true }, { "MergedSiteId", idType, 1, true },
      { "PatchId", idType, 1, true }, { "CellColor", intType, 1, true },
      { "Weight", doubleType, 1, true }, { "Embedding", doubleType, dimension, true },
      { "CellArea", doubleType, 1, true }, { "CellMass", doubleType, 1, true },
      { "CellEnergy", doubleType, 1, true }, { "Centroid", doubleType, dimension, true },
      { "NumberOfNeighbors", idType, 1, true } });

  vtkTable* table = filter->GetConvergenceOutput();
  checkArrays("Convergence", table->GetRowData(), table->GetNumberOfRows(),
    { { "Iteration", idType, 1, true }, { "Energy", doubleType, 1, true },
      { "GradientNorm", doubleType, 1, true }, { "StepLength", doubleType, 1, true },
      { "Seconds", doubleType, 1, true } });

  vtkPolyData* edges = filter->GetEdgesOutput();
  CHECK_EQUAL(edges->GetNumberOfCells(), edges->GetNumberOfLines());
  checkArrays("Edges points", edges->GetPointData(), edges->GetNumberOfPoints(), {});
  checkArrays("Edges cells", edges->GetCellData(), edges->GetNumberOfCells(),
    { { "EdgeType", idType, 1, true }, { "SiteId", idType, 2, true } });

  for (vtkPolyData* output : { surface, cells, sites, edges })
  {
    CHECK_EQUAL(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  }
}

void testSums(vtkAnisotropicRemesher* filter, vtkPolyData* input)
{
  const double area = areaOf(input);
  vtkPolyData* surface = filter->GetOutput();
  vtkPolyData* sites = filter->GetSitesOutput();
  for (vtkPolyData* output : { surface, sites })
  {
    CHECK_NEAR(sumOf(arrayOf(output->GetPointData(), "CellArea")), area, 1e-12 * area);
  }
  CHECK_NEAR(areaOf(filter->GetVoronoiCellsOutput()), area, 1e-12 * area);
  for (const char* name : { "CellMass", "CellEnergy" })
  {
    const double expected = sumOf(arrayOf(sites->GetPointData(), name));
    CHECK_NEAR(sumOf(arrayOf(surface->GetPointData(), name)), expected, 1e-12 * expected);
  }
  CHECK(sumOf(arrayOf(sites->GetPointData(), "CellMass")) > area);
  CHECK_NEAR(sumOf(arrayOf(sites->GetPointData(), "CellEnergy")), filter->GetEnergy(),
    1e-12 * filter->GetEnergy());
}

/** The dual: one point per cell, triangles between neighbours, facts as counted here. */
void testSurface(vtkAnisotropicRemesher* filter, vtkPolyData* input)
{
  vtkPolyData* surface = filter->GetOutput();
  vtkPointData* data = surface->GetPointData();
  CHECK_EQUAL(surface->GetNumberOfPoints(), numberOfSites);
  CHECK(isClosedManifold(surface));
  CHECK_EQUAL(eulerCharacteristicOf(surface), 2);
  CHECK(volumeOf(surface) > 0.9 * volumeOf(input) && volumeOf(surface) < volumeOf(input) * 1.01);
  const auto fact = [&](const char* name)
  { return arrayOf(surface->GetFieldData(), name)->GetComponent(0, 0); };
  CHECK_EQUAL(fact("EulerCharacteristic"), 2.0);
  CHECK_EQUAL(fact("NumberOfNonManifoldEdges"), 0.0);
  CHECK_EQUAL(fact("NumberOfExtraPoints"), 0.0);
  CHECK_EQUAL(fact("Seed"), 5.0);
  CHECK_EQUAL(fact("Year"), 2012.0);

  // Each cell of the diagram is one disk here, so ports 0 and 2 tell the same of each site.
  vtkPolyData* sites = filter->GetSitesOutput();
  const auto siteIds = arrayOf(data, "SiteId");
  std::set<double> seen;
  for (vtkIdType k = 0; k < surface->GetNumberOfPoints(); ++k)
  {
    const auto site = static_cast<vtkIdType>(siteIds->GetComponent(k, 0));
    CHECK(seen.insert(static_cast<double>(site)).second);
    CHECK_EQUAL(arrayOf(data, "ComponentId")->GetComponent(k, 0), 0.0);
    for (const char* name : { "CellArea", "CellMass", "CellEnergy" })
    {
      const double expected = arrayOf(sites->GetPointData(), name)->GetComponent(site, 0);
      CHECK_NEAR(arrayOf(data, name)->GetComponent(k, 0), expected, 1e-12 * expected);
    }
    CHECK(tupleOf(arrayOf(data, "Embedding"), k) ==
      tupleOf(arrayOf(sites->GetPointData(), "Embedding"), site));
  }
}

void testInterpolation(vtkAnisotropicRemesher* filter, vtkPolyData* input)
{
  vtkPolyData* surface = filter->GetOutput();
  vtkPointData* data = surface->GetPointData();
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(input);
  locator->BuildLocator();
  for (vtkIdType k = 0; k < surface->GetNumberOfPoints(); ++k)
  {
    // `Place` tells where on the input the vertex belongs: on the surface, close to the vertex.
    const Point3 place = tupleOf(arrayOf(data, "Place"), k);
    double closest[3], squared = 0.0;
    vtkIdType cell = 0;
    int subId = 0;
    locator->FindClosestPoint(place.data(), closest, cell, subId, squared);
    CHECK(squared < 1e-28);
    const double cellSize = std::sqrt(arrayOf(data, "CellArea")->GetComponent(k, 0));
    CHECK((place - pointOf(surface, k)).norm() < 0.5 * cellSize);

    const double expected = linear(place);
    CHECK_NEAR(arrayOf(data, "Linear")->GetComponent(k, 0), expected, 1e-13);
    const auto floats = arrayOf(data, "LinearFloat");
    CHECK_NEAR(floats->GetComponent(k, 0), expected, 5e-6);
    CHECK_NEAR(floats->GetComponent(k, 1), 2.0 * expected, 1e-5);
    // An integer may be a label: it is that of one of the triangle's corners.
    vtkNew<vtkIdList> corners;
    input->GetCellPoints(cell, corners);
    const auto integers = arrayOf(input->GetPointData(), "Thousandths");
    CHECK(std::any_of(corners->begin(), corners->end(),
      [&](vtkIdType corner) {
        return integers->GetComponent(corner, 0) ==
          arrayOf(data, "Thousandths")->GetComponent(k, 0);
      }));
    auto* half = vtkStringArray::SafeDownCast(data->GetAbstractArray("Half"));
    const double beyond = place[0] - ellipsoidCenter()[0];
    if (std::abs(beyond) > 0.1) // longer than the input's edges
    {
      CHECK_EQUAL(half->GetValue(k), beyond < 0.0 ? "low" : "high");
    }

    const Point3 normal = tupleOf(arrayOf(data, "Normals"), k);
    CHECK_NEAR(normal.norm(), 1.0, 1e-14);
    const Point3 axes = ellipsoidAxes();
    const Point3 gradient =
      (place - ellipsoidCenter()).cwiseQuotient(axes.cwiseProduct(axes)).normalized();
    CHECK(normal.dot(gradient) > 0.99);
  }
}

void testConvergence(vtkAnisotropicRemesher* filter)
{
  vtkTable* table = filter->GetConvergenceOutput();
  const auto column = [&](const char* name) { return arrayOf(table->GetRowData(), name); };
  const vtkIdType rows = table->GetNumberOfRows();
  CHECK_EQUAL(rows, filter->GetNumberOfIterations() + 1);
  CHECK_EQUAL(rows, lloydIterations + newtonIterations + 1);
  for (vtkIdType k = 0; k < rows; ++k)
  {
    CHECK_EQUAL(column("Iteration")->GetComponent(k, 0), static_cast<double>(k));
    CHECK(
      column("Seconds")->GetComponent(k, 0) >= (k ? column("Seconds")->GetComponent(k - 1, 0) : 0));
    const double energy = column("Energy")->GetComponent(k, 0);
    CHECK(k == 0 || energy <= column("Energy")->GetComponent(k - 1, 0));
    const double step = column("StepLength")->GetComponent(k, 0);
    CHECK(k <= lloydIterations ? step == (k == 0 ? 0.0 : 1.0) : step > 0.0);
  }
  vtkPointData* sites = filter->GetSitesOutput()->GetPointData();
  double squared = 0.0;
  for (vtkIdType i = 0; i < numberOfSites; ++i)
  {
    const Eigen::VectorXd shift =
      tupleOf(arrayOf(sites, "Embedding"), i) - tupleOf(arrayOf(sites, "Centroid"), i);
    const double m = arrayOf(sites, "CellMass")->GetComponent(i, 0);
    squared += (2.0 * m * shift).squaredNorm();
  }
  const double gradient = column("GradientNorm")->GetComponent(rows - 1, 0);
  CHECK_NEAR(std::sqrt(squared), gradient, 1e-9 * gradient);
  const double energy = column("Energy")->GetComponent(rows - 1, 0);
  CHECK_NEAR(filter->GetEnergy(), energy, 1e-12 * energy);
  CHECK(filter->GetNumberOfEvaluations() >= filter->GetNumberOfIterations());
}

}

int TestAnisotropicRemesher(int, char*[])
{
  const auto input = makeInput();
  const auto before = contentOf(input);
  vtkNew<vtkAnisotropicRemesher> filter;
  filter->SetInputData(input);
  filter->SetNumberOfPoints(numberOfSites);
  filter->SetNumberOfLloydIterations(lloydIterations);
  filter->SetNumberOfNewtonIterations(newtonIterations);
  filter->SetSeed(5);
  filter->SetAnisotropy(0.1);
  filter->Update();
  CHECK_EQUAL(filter->GetNumberOfOutputPorts(), 5);
  CHECK_EQUAL(filter->GetNumberOfInputPorts(), 2);
  CHECK_EQUAL(filter->GetDimension(), dimension);
  CHECK_EQUAL(filter->GetNumberOfInputComponents(), 1);
  CHECK_EQUAL(filter->GetNumberOfDroppedTriangles(), 0);
  CHECK_EQUAL(filter->GetNumberOfMergedPoints(), 0);
  for (const char* phase : { "intake", "sampling", "lloyd", "newton", "diagram", "distance" })
  {
    CHECK(filter->GetPhaseSeconds(phase) > 0.0);
  }
  CHECK_EQUAL(filter->GetPhaseSeconds("no such phase"), 0.0);
  CHECK_EQUAL(filter->GetPhaseSeconds(nullptr), 0.0);
  testArrays(filter);
  testSums(filter, input);
  testSurface(filter, input);
  testInterpolation(filter, input);
  testConvergence(filter);
  checkSame(contentOf(input), before, "the input");
  return result();
}
