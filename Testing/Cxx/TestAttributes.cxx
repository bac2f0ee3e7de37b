// What becomes of the input's point arrays and field data on the mesh, and of their roles.

#include "TestCarriedArrays.h"

#include "Adaptors/ReservedNames.h"

#include "vtkBitArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

using namespace remesh;
using namespace remesh::test;

namespace
{
vtkSmartPointer<vtkPolyData> plane()
{
  return polyDataOf(gridPatch(12, 12));
}

/** The input's points around a vertex of the mesh of `plane()`, nearest first. */
std::vector<vtkIdType> pointsAround(const Point3& place)
{
  std::vector<std::pair<double, vtkIdType>> found;
  for (int j = 0; j <= 12; ++j)
  {
    for (int i = 0; i <= 12; ++i)
    {
      const double distance = (Point3(i / 12.0, j / 12.0, 0.0) - place).norm();
      if (distance < 1.5 / 12.0)
      {
        found.emplace_back(distance, j * 13 + i);
      }
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<vtkIdType> ids;
  std::transform(found.begin(), found.end(), std::back_inserter(ids),
    [](const auto& pair) { return pair.second; });
  return ids;
}

/** Ids, bits and strings are those of a corner around; measures and colours are interpolated. */
void testPointArrays()
{
  const auto input = plane();
  const vtkIdType count = input->GetNumberOfPoints();
  addPointArray<vtkDoubleArray>(input, "Place", 3, [](const Point3& p, int c) { return p[c]; });
  addPointArray<vtkFloatArray>(input, "Constant", 1, [](const Point3&, int) { return 0.1f; });
  addPointArray<vtkUnsignedCharArray>(
    input, "Color", 4, [](const Point3& p, int c) { return c == 3 ? 255 : 240.0 * p[c]; });
  addPointArray<vtkUnsignedCharArray>(
    input, "Mask", 1, [](const Point3& p, int) { return p[0] > 0.5 ? 200 : 7; });
  auto pedigree = addPointArray<vtkIdTypeArray>(input, "Origin", 1,
    [](const Point3& p, int)
    { return 1000 + std::round(12.0 * p[0]) + 13.0 * std::round(12.0 * p[1]); });
  addPointArray<vtkIdTypeArray>(input, "Global", 1, [](const Point3&, int) { return 0; });
  addPointArray<vtkBitArray>(input, "Bit", 1, [](const Point3& p, int) { return p[0] > 0.5; });
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  for (vtkIdType i = 0; i < count; ++i)
  {
    names->InsertNextValue(std::to_string(1000 + i));
  }
  input->GetPointData()->AddArray(names);
  input->GetPointData()->SetActivePedigreeIds("Origin");
  input->GetPointData()->SetActiveGlobalIds("Global");
  const Filter filter = makeFilter(input, 150);
  CHECK(run(filter).empty());
  vtkPolyData* mesh = filter->GetOutput();
  vtkPointData* data = mesh->GetPointData();
  CHECK(!data->HasArray("Global") && !data->GetGlobalIds());
  CHECK(data->GetPedigreeIds() != nullptr && data->GetPedigreeIds() == data->GetArray("Origin"));
  auto* outNames = vtkStringArray::SafeDownCast(data->GetAbstractArray("Name"));
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
  {
    const Point3 place = tupleOf(arrayOf(data, "Place"), k);
    const std::vector<vtkIdType> around = pointsAround(place);
    const auto origin = static_cast<vtkIdType>(arrayOf(data, "Origin")->GetComponent(k, 0)) - 1000;
    // The corner of the largest weight: one of the three around, and mostly the nearest.
    CHECK(std::find(around.begin(), around.begin() + 3, origin) != around.begin() + 3);
    CHECK_EQUAL(outNames->GetValue(k), std::to_string(1000 + origin));
    const double x = pointOf(input, origin)[0];
    CHECK_EQUAL(arrayOf(data, "Bit")->GetComponent(k, 0), x > 0.5 ? 1.0 : 0.0);
    CHECK_EQUAL(arrayOf(data, "Mask")->GetComponent(k, 0), x > 0.5 ? 200.0 : 7.0);
    CHECK_EQUAL(arrayOf(data, "Constant")->GetComponent(k, 0), double(0.1f));
    for (int c = 0; c < 3; ++c)
    {
      CHECK_NEAR(arrayOf(data, "Color")->GetComponent(k, c), 240.0 * place[c], 0.5 + 1e-9);
    }
    CHECK_EQUAL(arrayOf(data, "Color")->GetComponent(k, 3), 255.0);
  }
}

/** A value that is no number spreads to the vertices of its own triangles, and no further. */
void testNotANumber()
{
  const auto input = plane();
  auto values =
    addPointArray<vtkDoubleArray>(input, "Values", 1, [](const Point3& p, int) { return p[0]; });
  values->SetComponent(6 * 13 + 6, 0, std::numeric_limits<double>::quiet_NaN());
  const Filter filter = makeFilter(input, 150);
  CHECK(run(filter).empty());
  vtkPolyData* mesh = filter->GetOutput();
  const auto found = arrayOf(mesh->GetPointData(), "Values");
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
  {
    const bool near = (pointOf(mesh, k) - Point3(0.5, 0.5, 0.0)).norm() < 1.5 / 12.0;
    CHECK(near || std::isfinite(found->GetComponent(k, 0)));
  }
}

/** The number 5 on all cells, as their active scalars. */
void labelCells(vtkPolyData* surface)
{
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  label->SetNumberOfValues(surface->GetNumberOfCells());
  label->Fill(5);
  surface->GetCellData()->AddArray(label);
  surface->GetCellData()->SetActiveScalars("Label");
}

/** Names of components, lookup tables and active attributes stay; normals stay unit vectors. */
void testRoles()
{
  const auto input = polyDataOf(icosphere(2));
  auto tcoords = addPointArray<vtkFloatArray>(
    input, "UV", 2, [](const Point3& p, int c) { return static_cast<float>(p[c]); });
  tcoords->SetComponentName(0, "east");
  tcoords->SetComponentName(1, "north");
  addPointArray<vtkDoubleArray>(input, "T", 1, [](const Point3& p, int) { return p[2]; });
  addPointArray<vtkDoubleArray>(input, "Wind", 3, [](const Point3& p, int c) { return p[c] * 2; });
  addPointArray<vtkFloatArray>(
    input, "N", 3, [](const Point3& p, int c) { return static_cast<float>(p[c]); });
  vtkPointData* from = input->GetPointData();
  from->SetActiveTCoords("UV");
  from->SetActiveScalars("T");
  from->SetActiveVectors("Wind");
  from->SetActiveNormals("N");
  labelCells(input);
  vtkNew<vtkIntArray> year;
  year->SetName("Year");
  year->InsertNextValue(2012);
  input->GetFieldData()->AddArray(year);
  const Filter filter = makeFilter(input, 100);
  CHECK(run(filter).empty());
  CHECK_EQUAL(arrayOf(filter->GetOutput()->GetFieldData(), "Year")->GetComponent(0, 0), 2012.0);
  vtkPointData* data = filter->GetOutput()->GetPointData();
  CHECK(data->GetTCoords() == data->GetArray("UV"));
  CHECK(data->GetScalars() == data->GetArray("T"));
  CHECK(data->GetVectors() == data->GetArray("Wind"));
  CHECK(data->GetNormals() == data->GetArray("Normals"));
  CHECK_EQUAL(std::string(data->GetArray("UV")->GetComponentName(1)), "north");
  CHECK(filter->GetOutput()->GetCellData()->GetScalars() != nullptr);
  const auto normals = arrayOf(data, "N");
  CHECK_EQUAL(normals->GetDataType(), VTK_FLOAT);
  for (vtkIdType k = 0; k < normals->GetNumberOfTuples(); ++k)
  {
    CHECK_NEAR(tupleOf(normals, k).norm(), 1.0, 1e-6);
    CHECK(tupleOf(arrayOf(data, "Wind"), k).norm() < 2.0);
  }
}

/** An array may be active as several things at once, and none gets lost. */
void testSeveralRoles()
{
  const auto input = plane();
  addPointArray<vtkDoubleArray>(input, "Flow", 3, [](const Point3& p, int c) { return p[c]; });
  addPointArray<vtkIdTypeArray>(input, "Ids", 1, [](const Point3& p, int) { return 100 * p[0]; });
  vtkPointData* from = input->GetPointData();
  from->SetActiveScalars("Flow");
  from->SetActiveVectors("Flow");
  from->SetActiveTCoords("Flow");
  from->SetActivePedigreeIds("Ids");
  from->SetActiveGlobalIds("Ids");
  labelCells(input);
  input->GetCellData()->SetActiveGlobalIds("Label");
  const Filter filter = makeFilter(input, 100);
  CHECK(run(filter).empty());
  vtkPointData* data = filter->GetOutput()->GetPointData();
  vtkDataArray* flow = data->GetArray("Flow");
  CHECK(flow && data->GetScalars() == flow && data->GetVectors() == flow);
  CHECK(data->GetTCoords() == flow);
  // Ids that would repeat are no ids, whatever else they are.
  CHECK(!data->HasArray("Ids") && !data->GetGlobalIds() && !data->GetPedigreeIds());
  CHECK(!filter->GetOutput()->GetCellData()->HasArray("Label"));
}

/** Facts and sums of an earlier run, which this one does not write, are not taken for its own. */
void testEarlierFacts()
{
  const auto input = plane();
  vtkNew<vtkDoubleArray> year;
  year->SetName("Year");
  year->InsertNextValue(2012.0);
  input->GetFieldData()->AddArray(year);
  addPointArray<vtkDoubleArray>(input, "D", 1, [](const Point3& p, int) { return 1.0 + p[0]; });
  const auto first = makeFilter(input, 120);
  first->SetDensityArray("D");
  first->SetNormalSmoothingRadius(0.3);
  CHECK(run(first).empty());
  vtkPolyData* mesh = first->GetOutput();
  CHECK(mesh->GetPointData()->HasArray("CellWeightedMass"));
  for (int k = 0; k < mesh->GetFieldData()->GetNumberOfArrays(); ++k)
  {
    const std::string name = mesh->GetFieldData()->GetArrayName(k);
    check(name == "Year" || isReserved(meshFactNames, name), __FILE__, __LINE__,
      name + " is not reserved");
  }
  vtkNew<vtkPolyData> again;
  again->ShallowCopy(mesh);
  again->GetPointData()->SetActiveAttribute(-1, vtkDataSetAttributes::NORMALS);
  const auto second = makeFilter(again, 60);
  second->MeasureDistanceOff();
  CHECK(run(second).empty()); // they are the filter's own
  CHECK(!second->GetOutput()->GetPointData()->HasArray("CellWeightedMass"));
  for (const char* name : { "MaximumDistance", "RMSDistance", "CellWeightedMass" })
  {
    CHECK(!second->GetOutput()->GetFieldData()->HasArray(name));
  }
  // Its own, not the one that the first mesh was given.
  CHECK(arrayOf(second->GetOutput()->GetFieldData(), "NormalSmoothingRadius")->GetTuple1(0) != 0.3);
  for (int port = 0; port < second->GetNumberOfOutputPorts(); ++port)
  {
    vtkFieldData* facts = second->GetOutputDataObject(port)->GetFieldData();
    CHECK(facts->HasArray("Year"));
    CHECK_EQUAL(facts->HasArray("Seed") != 0, port == 0);
    CHECK(!facts->HasArray("MaximumDistance"));
  }
  CHECK(mesh->GetFieldData()->HasArray("MaximumDistance"));
}

/** Of a mesh that is no mesh of this filter's: what is named like its own is told. */
void testTakenNames()
{
  const auto input = plane();
  addPointArray<vtkDoubleArray>(input, "CellArea", 1, [](const Point3&, int) { return 1.0; });
  addPointArray<vtkDoubleArray>(input, "SiteId", 1, [](const Point3&, int) { return 1.0; });
  vtkNew<vtkDoubleArray> seed;
  seed->SetName("Seed");
  seed->InsertNextValue(2012.0);
  input->GetFieldData()->AddArray(seed);
  const std::vector<std::string> warnings = run(makeFilter(input, 60));
  CHECK_EQUAL(warnings.size(), std::size_t(1));
  const std::string text = warnings.empty() ? std::string() : warnings.front();
  CHECK(text.find("named like arrays of the mesh's own") != std::string::npos);
  for (const char* name : { "SiteId", "CellArea", "Seed" })
  {
    check(text.find(std::string("\"") + name + "\"") != std::string::npos, __FILE__, __LINE__,
      std::string("no word of ") + name + " in: " + text);
  }
}

/** The mesh's own arrays are not carried from mesh to mesh; a warning names what does not fit. */
void testNamesAndLengths()
{
  auto input = plane();
  const auto first = makeFilter(input, 120);
  CHECK(run(first).empty());
  vtkNew<vtkPolyData> again;
  again->ShallowCopy(first->GetOutput());
  vtkNew<vtkIntArray> none;
  none->SetName("Empty");
  again->GetCellData()->AddArray(none);
  again->GetPointData()->AddArray(none);
  const auto second = makeFilter(again, 60);
  const std::vector<std::string> warnings = run(second);
  CHECK_EQUAL(warnings.size(), std::size_t(1));
  const std::string& text = warnings.empty() ? std::string() : warnings.front();
  CHECK(text.find("\"Empty\"") != std::string::npos);
  for (const char* name : { "SiteId", "ComponentId", "CellArea", "Embedding", "Seed", "Normals" })
  {
    check(text.find(std::string("\"") + name + "\"") == std::string::npos, __FILE__, __LINE__,
      std::string(name) + " is told in: " + text);
  }
  vtkPolyData* mesh = second->GetOutput();
  CHECK(!mesh->GetPointData()->HasArray("Empty") && !mesh->GetCellData()->HasArray("Empty"));
  CHECK_EQUAL(mesh->GetPointData()->GetNumberOfArrays(),
    first->GetOutput()->GetPointData()->GetNumberOfArrays());
  const auto sites = arrayOf(mesh->GetPointData(), "SiteId");
  CHECK_EQUAL(sites->GetRange()[1], 59.0);
  // But for the radius over which normals that are not estimated any more were smoothed.
  CHECK(!mesh->GetFieldData()->HasArray("NormalSmoothingRadius"));
  CHECK_EQUAL(mesh->GetFieldData()->GetNumberOfArrays(),
    first->GetOutput()->GetFieldData()->GetNumberOfArrays() - 1);
}

}

int TestAttributes(int, char*[])
{
  testPointArrays();
  testNotANumber();
  testRoles();
  testSeveralRoles();
  testEarlierFacts();
  testTakenNames();
  testNamesAndLengths();
  return result();
}
