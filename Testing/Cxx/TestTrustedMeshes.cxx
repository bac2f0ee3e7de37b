// Meshes of surfaces with creases, borders and junctions: topology kept, nothing flipped, and
// features where they were.

#include "TestTrials.h"
#include "TestWalls.h"

#include <cmath>
#include <functional>

using namespace remesh;
using namespace remesh::test;

namespace
{
/** Three fine sheets on one line: it is kept, and made coarser with the rest. */
void testJunction()
{
  constexpr int n = 40;
  TriangleSoup soup;
  for (int sheet = 0; sheet < 3; ++sheet)
  {
    TriangleSoup own = gridPatch(n, n);
    const double angle = 2.0 * pi * sheet / 3.0;
    for (Point3& p : own.points)
    {
      p = Point3(p[0] * std::cos(angle), p[1], p[0] * std::sin(angle));
      p = p[0] == 0.0 ? Point3(0.0, p[1], 0.0) : p;
    }
    append(soup, own, Point3::Zero());
  }
  const auto surface = polyDataOf(soup);
  const auto onLine = [](const Point3& p)
  { return std::abs(p[0]) < 1e-12 && std::abs(p[2]) < 1e-12; };
  for (const double anisotropy : { 0.0, 0.05 })
  {
    const Trial trial = checkedMesh(surface, 500, anisotropy);
    int edges = 0;
    CHECK_NEAR(lengthAlong(trial.mesh, 3, onLine, edges), 1.0, 1e-12);
    CHECK(edges < n / 2);
    CHECK_EQUAL(trial.value("NumberOfComponents"), 1.0);
    CHECK_NEAR(areaOf(trial.mesh), 3.0, 1e-9);
  }
}

/** How long the border is against the surface's. */
double borderRatio(const Trial& trial, vtkPolyData* surface)
{
  const auto everywhere = [](const Point3&) { return true; };
  int edges = 0;
  const double length = lengthAlong(trial.mesh, 1, everywhere, edges);
  return length / lengthAlong(surface, 1, everywhere, edges);
}

void testTube()
{
  TriangleSoup soup;
  addWall(profileOf(96, [](int) { return 0.5; }), 2.0, 40, true, soup);
  const auto surface = polyDataOf(soup);
  for (const double anisotropy : { 0.0, 0.1 })
  {
    const Trial trial = checkedMesh(surface, 400, anisotropy);
    CHECK_NEAR(borderRatio(trial, surface), 1.0, 1e-2);
    CHECK(trial.value("RelativeRMSDistance") < 2e-3);
    CHECK_NEAR(borderRatio(keepingMesh(surface, 2000, anisotropy), surface), 1.0, 1e-3);
  }
}

void testSaddle()
{
  TriangleSoup soup = gridPatch(60, 60);
  for (Point3& p : soup.points)
  {
    const double x = 2.0 * p[0] - 1.0;
    const double y = 2.0 * p[1] - 1.0;
    p = Point3(x, y, x * y);
  }
  const auto surface = polyDataOf(soup);
  for (const double anisotropy : { 0.0, 0.1 })
  {
    const Trial trial = checkedMesh(surface, 400, anisotropy);
    CHECK_NEAR(borderRatio(trial, surface), 1.0, 1e-3);
    CHECK(trial.value("RelativeRMSDistance") < 1e-3);
  }
}

/** A rough closed surface, and a mesh of it that cuts itself for comparison. */
void testRoughSphere()
{
  TriangleSoup soup = icosphere(4);
  for (Point3& p : soup.points)
  {
    p *= 1.0 + 0.15 * std::sin(7.0 * p[0]) * std::sin(8.0 * p[1] + 1.0) * std::sin(9.0 * p[2]);
  }
  const auto surface = polyDataOf(soup);
  for (const double anisotropy : { 0.0, 0.05, 0.1 })
  {
    const Trial trial = checkedMesh(surface, 700, anisotropy);
    CHECK(trial.value("RelativeRMSDistance") < 2e-3);
  }
  const auto folded = polyDataOf(soup);
  folded->GetPoints()->SetPoint(10, 0.0, 0.0, 0.0);
  folded->GetPoints()->SetPoint(11, 2.0, 0.1, 0.0);
  folded->GetPoints()->SetPoint(12, -2.0, -0.1, 0.1);
  CHECK(numberOfSelfIntersections(folded) > 0);
}

/**
 * Bumps that are wide enough to survive the smoothing of the normals, and at high anisotropy far
 * more than there are cells: these fall into parts, and the mesh apart, unless the normals get
 * smoother still.
 */
void testBumps()
{
  const auto surface = bumpyPlate(100, 0.03, 30.0);
  const Trial trial = checkedMesh(surface, 1000, 0.5);
  CHECK(trial.value("RelativeRMSDistance") < 1e-3);
}

/** A closed wavy sheet of this thickness: 120 x 40 squares on each side, and a rim. */
vtkSmartPointer<vtkPolyData> wavySheet(double thickness)
{
  constexpr int nx = 120;
  constexpr int ny = 40;
  const double pi = std::acos(-1.0);
  const TriangleSoup grid = gridPatch(nx, ny);
  const auto count = static_cast<Offset>(grid.points.size());
  TriangleSoup soup;
  for (const double side : { 0.5, -0.5 })
  {
    for (const Point3& p : grid.points)
    {
      const double slope = 0.48 * pi * std::cos(6.0 * pi * p[0]);
      soup.points.push_back(Point3(p[0], 0.33 * p[1], 0.08 * std::sin(6.0 * pi * p[0])) +
        side * thickness * Point3(-slope, 0.0, 1.0).normalized());
    }
  }
  for (const auto& [a, b, c] : grid.triangles)
  {
    soup.triangles.push_back({ a, b, c });
    soup.triangles.push_back({ a + count, c + count, b + count });
  }
  const auto edges = directedEdgesOf(polyDataOf(grid));
  for (const auto& [edge, uses] : edges)
  {
    const auto& [a, b] = edge;
    if (edges.count({ b, a }) == 0)
    {
      soup.triangles.push_back({ b, a, a + count });
      soup.triangles.push_back({ b, a + count, b + count });
    }
  }
  return polyDataOf(soup);
}

/**
 * Where chords leave a sheet by more than its thickness, its sides go through each other, but
 * each triangle faces the side it lies nearest to. That is told where they do.
 */
void testThinSheet()
{
  for (const double thickness : { 0.003, 0.01 })
  {
    const auto surface = wavySheet(thickness);
    CHECK(isClosedManifold(surface));
    for (const vtkIdType points : { 300, 400, 600 })
    {
      const bool crosses = thickness < 0.01 && points == 300;
      keepingMesh(surface, points, 0.1, crosses ? "pairs of triangles go through" : nullptr);
    }
  }
}

/** Two sides over a triangle with this angle between two long ones: sharp creases, three tips. */
vtkSmartPointer<vtkPolyData> pillow(double degrees, double height)
{
  constexpr int n = 40; // rows from the middle to each side of the triangle
  const double half = std::tan(0.5 * degrees * std::acos(-1.0) / 180.0);
  const Point3 middle(2.0 / 3.0, 0.0, 0.0);
  const Point3 tips[] = { { 0.0, 0.0, 0.0 }, { 1.0, -half, 0.0 }, { 1.0, half, 0.0 } };
  TriangleSoup soup;
  for (const double side : { 1.0, -1.0 })
  {
    for (int k = 0; k < 3; ++k)
    {
      const Point3 first = tips[k] - middle;
      const Point3 second = tips[(k + 1) % 3] - middle;
      const auto addPoint = [&](int row, int at)
      {
        const double share = static_cast<double>(row) / n;
        const Point3 up(0.0, 0.0, side * height * (1.0 - share * share));
        soup.points.push_back(middle + ((row - at) * first + at * second) / n + up);
        return static_cast<Offset>(soup.points.size()) - 1;
      };
      const auto addTriangle = [&](Offset a, Offset b, Offset c) {
        soup.triangles.push_back({ a, side > 0.0 ? b : c, side > 0.0 ? c : b });
      };
      for (int row = 0; row < n; ++row)
      {
        for (int at = 0; at <= row; ++at)
        {
          addTriangle(addPoint(row, at), addPoint(row + 1, at), addPoint(row + 1, at + 1));
          if (at < row)
          {
            addTriangle(addPoint(row, at), addPoint(row + 1, at + 1), addPoint(row, at + 1));
          }
        }
      }
    }
  }
  return polyDataOf(soup);
}

/** Where two creases meet at a narrow tip, both sides first have the same triangle there. */
void testThinTips()
{
  for (const auto& [degrees, height] : { std::pair(25.0, 0.02), std::pair(30.0, 0.01) })
  {
    const auto surface = pillow(degrees, height);
    for (const vtkIdType points : { 100, 200 })
    {
      keepingMesh(surface, points, 0.0);
      keepingMesh(surface, points, 0.1);
    }
  }
}

/** A torus whose hole is far smaller than the cells: they are closed in on it until it is kept. */
void testNarrowHole()
{
  for (const double anisotropy : { 0.0, 0.04 })
  {
    keepingMesh(polyDataOf(torus(1.0, 0.98, 200, 100)), 600, anisotropy);
  }
}

/** Several of them: what fails is no small part, but becomes smaller all the time. */
void testNarrowHoles()
{
  for (const auto& [count, minor, points] : { std::tuple(5, 0.98, 750), std::tuple(8, 0.95, 800) })
  {
    TriangleSoup soup;
    for (int k = 0; k < count; ++k)
    {
      append(soup, torus(1.0, minor, 120, 60), Point3(4.0 * k, 0.0, 0.0));
    }
    keepingMesh(polyDataOf(soup), points, 0.0);
  }
}

/** A wavy plate with square holes close to each other: 17 loops, concave corners, narrow bars. */
void testHoles()
{
  constexpr int n = 36;
  const TriangleSoup grid = gridPatch(n, n);
  TriangleSoup soup;
  soup.points = grid.points;
  for (std::size_t t = 0; t < grid.triangles.size(); ++t)
  {
    const auto& [a, b, c] = grid.triangles[t];
    const Point3 center = n * (grid.points[a] + grid.points[b] + grid.points[c]) / 3.0;
    const auto inHole = [](double x) { return std::fmod(x, 9.0) > 3.0 && std::fmod(x, 9.0) < 8.0; };
    if (!inHole(center[0]) || !inHole(center[1]))
    {
      soup.triangles.push_back(grid.triangles[t]);
    }
  }
  for (Point3& p : soup.points)
  {
    p[2] = 0.03 * std::sin(9.0 * p[0]) * std::sin(7.0 * p[1]);
  }
  const auto surface = polyDataOf(soup);
  for (const double anisotropy : { 0.0, 0.05, 0.3 })
  {
    const Trial trial = checkedMesh(surface, 400, anisotropy);
    CHECK_EQUAL(trial.value("NumberOfBoundaryLoops"), 17.0);
    CHECK_NEAR(borderRatio(trial, surface), 1.0, 1e-3);
  }
}

/** A ball of voxels, with fewer points than its steps have: a ball, of as many points as asked. */
void testVoxels()
{
  const auto isInside = [](int i, int j, int k)
  { return Point3(i - 14.5, j - 14.5, k - 14.5).norm() < 14.2; };
  const auto surface = polyDataOf(voxelSurface(30, isInside));
  for (const double anisotropy : { 0.0, 0.04 })
  {
    const Trial trial = checkedMesh(surface, 600, anisotropy);
    CHECK(trial.value("RelativeRMSDistance") < 0.012); // a little more than half a voxel
  }
}
}

int TestTrustedMeshes(int, char*[])
{
  testJunction();
  testTube();
  testSaddle();
  testRoughSphere();
  testBumps();
  testThinSheet();
  testThinTips();
  testNarrowHole();
  testNarrowHoles();
  testHoles();
  testVoxels();
  return result();
}
