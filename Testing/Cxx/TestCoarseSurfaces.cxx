// Surfaces whose facets are larger than the cells: cones as fans of long triangles, and the like.

#include "TestMeasures.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"

#include <algorithm>
#include <cmath>

using namespace remesh;
using namespace remesh::test;

namespace
{
using Profile = std::vector<std::pair<double, double>>; // radius and height

/** A profile turned around the z axis; ends of radius 0 are points. */
TriangleSoup lathe(const Profile& profile, int sides)
{
  TriangleSoup soup;
  std::vector<std::vector<Offset>> rows;
  for (const auto& [radius, height] : profile)
  {
    rows.emplace_back();
    for (int k = 0; k < (radius > 0.0 ? sides : 1); ++k)
    {
      const double angle = 2.0 * pi * k / sides;
      rows.back().push_back(static_cast<Offset>(soup.points.size()));
      soup.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  }
  for (std::size_t r = 0; r + 1 < rows.size(); ++r)
  {
    const auto at = [&](std::size_t row, int k) { return rows[row][k % rows[row].size()]; };
    for (int k = 0; k < sides; ++k)
    {
      if (rows[r].size() > 1)
      {
        soup.triangles.push_back({ at(r, k), at(r, k + 1), at(r + 1, k + 1) });
      }
      if (rows[r + 1].size() > 1)
      {
        soup.triangles.push_back({ at(r, k), at(r + 1, k + 1), at(r + 1, k) });
      }
    }
  }
  return soup;
}

TriangleSoup bicone()
{
  return lathe({ { 0, -10 }, { 1, 0 }, { 0, 10 } }, 72);
}
TriangleSoup cone(int sides, double height)
{
  return lathe({ { 0, 0 }, { 1, 0 }, { 0, height } }, sides);
}

double factOf(vtkPolyData* mesh, const char* name)
{
  return arrayOf(mesh->GetFieldData(), name)->GetComponent(0, 0);
}

double diagonalOf(vtkPolyData* data)
{
  return data->GetLength();
}

/** The largest angle between neighbours, degrees. */
double sharpestFold(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, Point3> normals;
  forEachPolygon(mesh,
    [&](vtkIdType, const std::vector<vtkIdType>& ids)
    {
      const Point3 a = pointOf(mesh, ids[0]);
      const Point3 normal =
        (pointOf(mesh, ids[1]) - a).cross(pointOf(mesh, ids[2]) - a).normalized();
      for (int k = 0; k < 3; ++k)
      {
        normals[{ ids[k], ids[(k + 1) % 3] }] = normal;
      }
    });
  double least = 1.0;
  for (const auto& [ends, normal] : normals)
  {
    const auto other = normals.find({ ends.second, ends.first });
    least = other == normals.end() ? least : std::min(least, normal.dot(other->second));
  }
  return std::acos(std::clamp(least, -1.0, 1.0)) * 180.0 / pi;
}

double nearestVertex(vtkPolyData* mesh, const Point3& place)
{
  double least = VTK_DOUBLE_MAX;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    least = std::min(least, (pointOf(mesh, i) - place).norm());
  }
  return least;
}

vtkSmartPointer<vtkAnisotropicRemesher> remesherOf(vtkPolyData* input, vtkIdType points, double s)
{
  auto filter = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  filter->SetInputData(input);
  filter->SetNumberOfPoints(points);
  filter->SetAnisotropy(s);
  filter->SetMeasureDistance(true);
  return filter;
}

/** A closed mesh with exactly so many points, proven, and no farther than that. */
vtkSmartPointer<vtkPolyData> checkCone(
  vtkPolyData* input, vtkIdType points, double s, double maxOfDiagonal)
{
  const auto filter = remesherOf(input, points, s);
  Messages messages(filter);
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  CHECK(messages.warnings().empty());
  CHECK_EQUAL(mesh->GetNumberOfPoints(), points);
  CHECK_EQUAL(factOf(mesh, "TopologyPreserved"), 1.0);
  CHECK_EQUAL(factOf(mesh, "NumberOfNonManifoldEdges"), 0.0);
  CHECK_EQUAL(eulerCharacteristicOf(mesh), 2);
  CHECK(factOf(mesh, "MaximumDistance") <= maxOfDiagonal * diagonalOf(input));
  return mesh;
}

/** Fans lose no topology, and no tip. */
void testCones()
{
  const auto bicones = polyDataOf(bicone());
  checkCone(bicones, 1000, 0.02, 2e-3);
  checkCone(bicones, 3000, 0.02, 6e-4);
  const auto needle = polyDataOf(cone(48, 50.0));
  const auto mesh = checkCone(needle, 3000, 0.02, 6e-4);
  CHECK(nearestVertex(mesh, { 0, 0, 50 }) <= 6e-4 * diagonalOf(needle));
  CHECK(sharpestFold(mesh) < 150.0);
  for (const int sides : { 12, 24 })
  {
    for (const double height : { 2.0, 10.0, 40.0 })
    {
      const auto input = polyDataOf(cone(sides, height));
      checkCone(input, 1000, 0.1, 4e-3);
    }
  }
}

/** At anisotropy 0, too, though at every scale fewer cells than three fit around a tip. */
void testIsotropicCones()
{
  for (const TriangleSoup& soup : { bicone(), cone(12, 40.0), cone(24, 10.0), cone(48, 50.0) })
  {
    const auto input = polyDataOf(soup);
    const auto mesh = checkCone(input, 1000, 0.0, 2e-2);
    CHECK_EQUAL(nearestVertex(mesh, soup.points.back()), 0.0);
  }
}

/** Normals that turn all the way from the base to the tip say nothing about the sides. */
void testGivenNormals()
{
  const auto input = polyDataOf(cone(24, 10.0));
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const Point3 p = pointOf(input, i);
    const bool isOnAxis = p.head<2>().norm() < 0.5;
    const Point3 normal = isOnAxis ? Point3(0, 0, p[2] > 0.0 ? 1.0 : -1.0) : p;
    normals->InsertNextTuple(normal.data());
  }
  input->GetPointData()->SetNormals(normals);
  checkCone(input, 1000, 0.02, 1e-2);
}

/** The tolerance takes no more points than for a surface of small triangles. */
void testTolerance()
{
  const auto input = polyDataOf(cone(48, 10.0));
  const auto filter = remesherOf(input, 0, 0.02);
  filter->SetDistanceTolerance(1e-3);
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  CHECK(factOf(mesh, "MaximumDistance") <= 1e-3 * diagonalOf(input));
  CHECK_EQUAL(factOf(mesh, "TopologyPreserved"), 1.0);
  CHECK(mesh->GetNumberOfPoints() <= 836 * 11 / 10); // of chance, a tenth
}

/** Cells, arrays and areas are those of the input. */
void testOutputs()
{
  const auto input = polyDataOf(cone(24, 10.0));
  const vtkIdType cells = input->GetNumberOfCells();
  addPointArray<vtkDoubleArray>(
    input, "Linear", 2, [](const Point3& p, int c) { return c == 0 ? 1.0 + p[2] : p[0] - p[1]; });
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Cell");
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    ids->InsertNextValue(cell);
  }
  input->GetCellData()->AddArray(ids);
  const auto filter = remesherOf(input, 1000, 0.05);
  filter->SetVertexPlacement(vtkAnisotropicRemesher::SURFACE_POINT);
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  const double area = areaOf(input);
  CHECK_NEAR(sumOf(arrayOf(mesh->GetPointData(), "CellArea")), area, 1e-12 * area);
  vtkDataArray* linear = arrayOf(mesh->GetPointData(), "Linear");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Point3 p = pointOf(mesh, i);
    CHECK_NEAR(linear->GetComponent(i, 0), 1.0 + p[2], 1e-10);
    CHECK_NEAR(linear->GetComponent(i, 1), p[0] - p[1], 1e-10);
  }
  vtkPolyData* pieces = filter->GetVoronoiCellsOutput();
  vtkDataArray* inputCells = arrayOf(pieces->GetCellData(), "InputCellId");
  std::vector<double> areas(static_cast<std::size_t>(cells), 0.0);
  forEachPolygon(pieces,
    [&](vtkIdType polygon, const std::vector<vtkIdType>& corners)
    {
      const auto cell = static_cast<vtkIdType>(inputCells->GetComponent(polygon, 0));
      CHECK(cell >= 0 && cell < cells);
      areas[cell] += polygonArea(pieces, corners);
    });
  forEachPolygon(input,
    [&](vtkIdType cell, const std::vector<vtkIdType>& corners)
    {
      const double whole = polygonArea(input, corners);
      CHECK_NEAR(areas[cell], whole, 1e-12 * area);
    });
}

/** Loose slivers have three points each, not in line, though one of their corners hardly bends. */
void testSlivers()
{
  TriangleSoup soup;
  for (int k = 0; k < 40; ++k)
  {
    TriangleSoup sliver;
    sliver.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.3 + 0.01 * k, 0.02, 0 } };
    sliver.triangles = { { 0, 1, 2 } };
    append(soup, sliver, Point3(0, 0, k));
  }
  const auto input = polyDataOf(soup);
  const auto filter = remesherOf(input, 120, 0.02);
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  CHECK_EQUAL(mesh->GetNumberOfPoints(), 120);
  CHECK_EQUAL(mesh->GetNumberOfCells(), 40);
  CHECK_EQUAL(factOf(mesh, "NumberOfFlippedTriangles"), 0.0);
  CHECK_NEAR(areaOf(mesh), areaOf(input), 0.03 * areaOf(input));
}
}

int TestCoarseSurfaces(int, char*[])
{
  testCones();
  testIsotropicCones();
  testGivenNormals();
  testTolerance();
  testOutputs();
  testSlivers();
  return test::result();
}
