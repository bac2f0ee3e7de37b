// SetSeamArray: jumps of a point array stay edges of the mesh, with a point for each side; what the
// field data and sums tell then; which jumps are none, and which are not kept.

#include "TestHelpers.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkCellArrayIterator.h"
#include "vtkIdTypeArray.h"
#include "vtkTable.h"

#include <cmath>
#include <functional>
#include <set>

using namespace remesh;
using namespace remesh::test;

namespace
{
using Place = std::function<Point3(double, double)>;

/** A grid over [0, 1]^2 with texture coordinates (u, v), put in place; its borders may coincide. */
vtkSmartPointer<vtkPolyData> mapped(int columns, int rows, const Place& place)
{
  TriangleSoup soup = gridPatch(columns, rows);
  const auto data = polyDataOf(soup);
  const auto map = addPointArray<vtkDoubleArray>(
    data, "Map", 2, [](const Point3& p, int component) { return p[component]; });
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const Point3 flat = pointOf(data, i);
    data->GetPoints()->SetPoint(i, place(flat[0], flat[1]).data());
  }
  data->GetPointData()->SetTCoords(map);
  return data;
}

/** Cosine and sine of so many turns, the same at 0 and 1. */
Point3 turned(double turns)
{
  const double angle = 2.0 * pi * (turns == 1.0 ? 0.0 : turns);
  return { std::cos(angle), std::sin(angle), 0.0 };
}

/** Open above and below, one seam. */
Point3 barrel(double u, double v)
{
  return (1.0 + 0.3 * std::sin(pi * v)) * turned(u) + Point3(0.0, 0.0, 2.0 * v);
}

/** Closed, two seams that cross. */
Point3 ring(double u, double v)
{
  const Point3 tube = turned(v);
  return (1.0 + 0.4 * tube[0]) * turned(u) + Point3(0.0, 0.0, 0.4 * tube[1]);
}

/** Closed, one seam from pole to pole, where it ends. */
Point3 ball(double u, double v)
{
  const bool isPole = v == 0.0 || v == 1.0;
  return (isPole ? 0.0 : std::sin(pi * v)) * turned(u) + Point3(0.0, 0.0, std::cos(pi * v));
}

/** The largest extent of a triangle in a component of the map. */
double largestSpan(vtkPolyData* mesh, vtkDataArray* map, int component)
{
  double largest = 0.0;
  auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    double low = 2.0;
    double high = -1.0;
    for (int k = 0; k < 3; ++k)
    {
      low = std::min(low, map->GetComponent(ids[k], component));
      high = std::max(high, map->GetComponent(ids[k], component));
    }
    largest = std::max(largest, high - low);
  }
  return largest;
}

/** Points of the mesh with different SiteIds: its vertices, of cells in one part. */
std::size_t numberOfVertices(vtkPolyData* mesh)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(mesh->GetPointData()->GetArray("SiteId"));
  return std::set<vtkIdType>(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues())
    .size();
}

double fact(vtkPolyData* mesh, const char* name)
{
  return vtkDataArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(name))
    ->GetComponent(0, 0);
}

double sumOf(vtkPolyData* data, const char* name)
{
  double sum = 0.0;
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    sum += array->GetComponent(i, 0);
  }
  return sum;
}

vtkSmartPointer<vtkAnisotropicRemesher> remesherOf(vtkPolyData* input, vtkIdType points)
{
  auto filter = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  filter->SetInputData(input);
  filter->SetNumberOfPoints(points);
  return filter;
}

struct Case
{
  const char* name;
  Place place;
  int euler;
  double span; ///< the most that a triangle may extend in u; at a pole it is wide there
};

/** Each side of a seam has the values of its side, near what the place has by the formula. */
void testSides(const Case& shape, double anisotropy)
{
  const auto input = mapped(48, 24, shape.place);
  const auto filter = remesherOf(input, 1000);
  filter->SetAnisotropy(anisotropy);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty());
  CHECK(messages.warnings().empty());
  vtkPolyData* mesh = filter->GetOutput();
  vtkDataArray* map = mesh->GetPointData()->GetTCoords();
  check(map != nullptr && std::string(map->GetName()) == "Map", __FILE__, __LINE__, shape.name);
  CHECK(largestSpan(mesh, map, 0) < shape.span);
  CHECK(largestSpan(mesh, map, 1) < 0.2);
  CHECK(numberOfVertices(mesh) == 1000);
  CHECK(mesh->GetNumberOfPoints() > 1010);
  CHECK(mesh->GetNumberOfPoints() < 1250);
  CHECK(fact(mesh, "EulerCharacteristic") == shape.euler);
  CHECK(fact(mesh, "TopologyPreserved") == 1);
  CHECK(fact(mesh, "NumberOfExtraPoints") == 0);
  for (const char* sum : { "CellArea", "CellMass", "CellEnergy" })
  {
    CHECK_NEAR(sumOf(mesh, sum) / sumOf(filter->GetSitesOutput(), sum), 1.0, 1e-12);
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Point3 place = shape.place(map->GetComponent(i, 0), map->GetComponent(i, 1));
    CHECK((place - pointOf(mesh, i)).norm() < 0.03);
  }
}

/** Arrays that are chosen, and those that are not; points without jumps are not doubled. */
void testChoice()
{
  const auto input = mapped(48, 24, barrel);
  const auto doubled = [&](const char* name)
  {
    const auto filter = remesherOf(input, 500);
    filter->SetSeamArray(name);
    Messages messages(filter);
    filter->Update();
    CHECK(messages.errors().empty());
    CHECK(messages.warnings().empty());
    return filter->GetOutput()->GetNumberOfPoints() > 500;
  };
  CHECK(doubled(nullptr));
  CHECK(doubled("Automatic"));
  CHECK(doubled("Map"));
  CHECK(!doubled("None"));
  input->GetPointData()->SetActiveTCoords(nullptr);
  CHECK(!doubled("None"));
  CHECK(doubled("Map"));
  // What was rounded on the way is no jump.
  const auto heights =
    addPointArray<vtkDoubleArray>(input, "Height", 1, [](const Point3& p, int) { return p[2]; });
  for (vtkIdType i = 0; i < heights->GetNumberOfTuples(); i += 2)
  {
    heights->SetValue(i, heights->GetValue(i) + 1e-5);
  }
  input->GetPointData()->RemoveArray("Map");
  CHECK(!doubled("Height"));
  const auto filter = remesherOf(input, 500);
  filter->SetSeamArray("Absent");
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().size() == 1);
  CHECK(messages.errors()[0].find("Absent") != std::string::npos);
  CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
}

void checkWarning(vtkAnisotropicRemesher* filter, const std::string& part, int line)
{
  Messages messages(filter);
  filter->Update();
  const auto& warnings = messages.warnings();
  check(warnings.size() == 1 && warnings[0].find(part) != std::string::npos, __FILE__, line,
    part + ": " + (warnings.empty() ? "none" : warnings[0]));
}

/** Seams that are not kept are told. */
void testWarnings()
{
  const auto input = mapped(48, 24, barrel);
  const auto smooth = remesherOf(input, 500);
  smooth->PreserveFeaturesOff();
  smooth->MeasureDistanceOff();
  checkWarning(smooth, "interpolated across: \"Map\"", __LINE__);

  input->GetPointData()->SetActiveTCoords(nullptr);
  checkWarning(remesherOf(input, 500), "interpolated across: \"Map\"", __LINE__);

  // Each facet on a chart of its own.
  TriangleSoup loose;
  const TriangleSoup sphere = icosphere(3);
  for (const auto& triangle : sphere.triangles)
  {
    const auto first = static_cast<Offset>(loose.points.size());
    for (const Offset point : triangle)
    {
      loose.points.push_back(sphere.points[point]);
    }
    loose.triangles.push_back({ first, first + 1, first + 2 });
  }
  const auto light = polyDataOf(loose);
  vtkNew<vtkDoubleArray> map;
  map->SetName("Light");
  map->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < light->GetNumberOfPoints(); ++i)
  {
    map->InsertNextTuple2(static_cast<double>(i), static_cast<double>(i % 3));
  }
  light->GetPointData()->SetTCoords(map);
  const auto filter = remesherOf(light, 500);
  checkWarning(filter, "The seams of \"Light\" are not kept", __LINE__);
  CHECK(filter->GetOutput()->GetNumberOfPoints() == 500);
}
}

int TestSeams(int, char*[])
{
  for (const double anisotropy : { 0.0, 0.04 })
  {
    testSides({ "barrel", barrel, 0, 0.2 }, anisotropy);
    testSides({ "ring", ring, 0, 0.2 }, anisotropy);
    testSides({ "ball", ball, 2, 0.5 }, anisotropy);
  }
  testChoice();
  testWarnings();
  return result();
}
