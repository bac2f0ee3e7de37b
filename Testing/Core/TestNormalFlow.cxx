// Mesh/NormalFlow: the heat equation's own solutions, whatever the triangles, scale and threads.

#include "Mesh/FacetGeometry.h"
#include "Mesh/NormalFlow.h"
#include "Mesh/Normals.h"
#include "TestSupport.h"

#include <algorithm>
#include <chrono>
#include <limits>

using namespace remesh;

namespace
{
/** Normals of the unit square that lean by `lean` cos(k x) along x: a mode of its heat equation. */
std::vector<Point3> waveNormals(const SurfaceMesh& square, double k, double lean)
{
  std::vector<Point3> normals;
  for (const Point3& point : square.points)
  {
    normals.push_back(Point3(lean * std::cos(k * point[0]), 0.0, 1.0).normalized());
  }
  return normals;
}

/** A mode fades by 1 / (1 + k^2 t) in each of three implicit steps of t = radius^2 / 12. */
void testDecay()
{
  constexpr double lean = 1e-3; // so small that normalising does not matter
  for (const auto& [nx, ny] : { std::pair(40, 40), std::pair(90, 7), std::pair(60, 300) })
  {
    const SurfaceMesh square = test::meshOf(test::gridPatch(nx, ny));
    for (const int waves : { 1, 3, 6 })
    {
      for (const double radius : { 0.05, 0.2 })
      {
        const double k = waves * test::pi;
        std::vector<Point3> normals = waveNormals(square, k, lean);
        smoothNormalsOver(square, radius, RunControl(), normals);
        const double kept = std::pow(1.0 + k * k * radius * radius / 12.0, -3.0);
        for (std::size_t i = 0; i < normals.size(); ++i)
        {
          const double expected = kept * lean * std::cos(k * square.points[i][0]);
          CHECK_NEAR(normals[i][0], expected, 0.02 * lean);
          CHECK_NEAR(normals[i].norm(), 1.0, 1e-14);
        }
      }
    }
  }
}

/** A part that is far smaller than the radius keeps its normals. */
void testSmallPart()
{
  TriangleSoup soup = test::icosphere(4);
  TriangleSoup small = test::icosphere(3);
  for (std::size_t k = 0; k < small.points.size(); ++k)
  {
    small.points[k] *= 1e-3;
    small.points[k][0] *= 1.2; // so that there is no symmetry to lean on
  }
  test::append(soup, small, Point3(3.0, 0.0, 0.0));
  const SurfaceMesh mesh = test::meshOf(soup);
  std::vector<Point3> normals = estimateCornerNormals(mesh, 0);
  const std::vector<Point3> before = normals;
  smoothNormalsOver(mesh, 0.3, RunControl(), normals);
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    CHECK(normals[i].dot(before[i]) > 0.98);
  }
}

/** The sphere's normals are a mode that all steps keep: only the length changes. */
void testSphere()
{
  const SurfaceMesh sphere = test::meshOf(test::icosphere(4));
  std::vector<Point3> normals = sphere.points;
  smoothNormalsOver(sphere, 0.4, RunControl(), normals);
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    CHECK_NEAR((normals[i] - sphere.points[i]).norm(), 0.0, 2e-3);
  }
}

/** Where places flow to; the normals do as without them. */
std::vector<Point3> smoothedPlaces(const SurfaceMesh& mesh, double radius)
{
  std::vector<Point3> normals = estimateCornerNormals(mesh, 0);
  std::vector<Point3> alone = normals;
  const std::vector<Point3> places =
    smoothNormalsAndPlacesOver(mesh, radius, RunControl(), normals);
  smoothNormalsOver(mesh, radius, RunControl(), alone);
  CHECK(normals == alone);
  return places;
}

/** Its places are one, too: each step of t = radius^2 / 12 divides its radius by 1 + 2 t. */
void testShrinkingSphere()
{
  const SurfaceMesh sphere = test::meshOf(test::icosphere(4));
  for (const double radius : { 0.05, 0.4, 1.0 })
  {
    const std::vector<Point3> places = smoothedPlaces(sphere, radius);
    CHECK_EQUAL(places.size(), sphere.cornerPoints.size());
    const double left = std::pow(1.0 + radius * radius / 6.0, -3.0);
    double sum = 0.0;
    for (std::size_t c = 0; c < places.size(); ++c)
    {
      const Point3& before = sphere.points[sphere.cornerPoints[c]];
      CHECK_NEAR((places[c] - left * before).norm(), 0.0, 0.15 * (1.0 - left));
      sum += places[c].norm();
    }
    CHECK_NEAR(sum / static_cast<double>(places.size()), left, 0.02 * (1.0 - left));
  }
  for (const double radius : { 0.0, -1.0, std::numeric_limits<double>::infinity() })
  {
    CHECK(smoothedPlaces(sphere, radius).front() == sphere.points[0]);
  }
}

/** What does not change keeps all its digits, though the steps have fewer. */
void testEqualNormals()
{
  const SurfaceMesh patch = test::meshOf(test::gridPatch(30, 20));
  const Point3 normal = Point3(1.0, 2.0, 3.0).normalized();
  std::vector<Point3> normals(patch.cornerPoints.size(), normal);
  const std::vector<Point3> before = normals;
  smoothNormalsOver(patch, 0.3, RunControl(), normals);
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    CHECK_NEAR((normals[i] - before[i]).norm(), 0.0, 1e-15);
  }
}

/** Facets much larger than the radius keep their normals; nothing crosses a crease. */
void testLocality()
{
  const SurfaceMesh cube = test::meshOf(test::cube());
  std::vector<Point3> normals = estimateCornerNormals(cube, 0);
  const std::vector<Point3> before = normals;
  smoothNormalsOver(cube, 1e-3, RunControl(), normals);
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    CHECK_NEAR((normals[i] - before[i]).norm(), 0.0, 1e-4);
  }
  SurfaceMesh split = cube; // each triangle on its own
  split.cornerPoints.clear();
  std::vector<Point3> own;
  std::vector<Triple> corners = cube.facetPoints;
  for (std::size_t f = 0; f < split.facetPoints.size(); ++f)
  {
    const auto& [a, b, c] = split.facetPoints[f];
    for (int k = 0; k < 3; ++k)
    {
      corners[f][k] = static_cast<Index>(split.cornerPoints.size());
      split.cornerPoints.push_back(split.facetPoints[f][k]);
      own.push_back(facetNormal(split.points[a], split.points[b], split.points[c]));
    }
  }
  split.facetCorners = corners;
  std::vector<Point3> flowed = own;
  smoothNormalsOver(split, 0.7, RunControl(), flowed);
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    CHECK_NEAR((flowed[i] - own[i]).norm(), 0.0, 1e-14);
  }
}

SurfaceMesh bumpySphere(double scale)
{
  SurfaceMesh sphere = test::meshOf(test::icosphere(4));
  for (Point3& point : sphere.points)
  {
    point *= scale * (1.0 + 0.05 * std::sin(31.0 * point[0]) * std::cos(23.0 * point[1]));
  }
  return sphere;
}

/** Equal bytes for any order of the blocks; cancelled: nothing done. No unit matters. */
void testControlAndScale()
{
  const SurfaceMesh mesh = bumpySphere(1.0);
  const std::vector<Point3> before = estimateCornerNormals(mesh, 0);
  std::vector<Point3> expected = before;
  smoothNormalsOver(mesh, 0.15, RunControl(), expected);
  CHECK(expected != before);
  for (const Schedule schedule : { Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    RunControl control;
    control.schedule = schedule;
    std::vector<Point3> normals = before;
    smoothNormalsOver(mesh, 0.15, control, normals);
    CHECK(normals == expected);
  }
  std::vector<Point3> stopped = before;
  smoothNormalsOver(mesh, 0.15, RunControl({}, []() { return true; }), stopped);
  CHECK(stopped == before);
  for (const double scale : { 0x1p-400, 0x1p-30, 0x1p60, 0x1p400 })
  {
    std::vector<Point3> normals = before;
    smoothNormalsOver(bumpySphere(scale), 0.15 * scale, RunControl(), normals);
    double largest = 0.0;
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      largest = std::max(largest, (normals[i] - expected[i]).norm());
    }
    CHECK_NEAR(largest, 0.0, 1e-9);
  }
}

/** Radii that say nothing, and facets without area or next to none. */
void testOddInput()
{
  const SurfaceMesh mesh = bumpySphere(1.0);
  const std::vector<Point3> before = estimateCornerNormals(mesh, 0);
  for (const double radius : { 0.0, -1.0, std::numeric_limits<double>::infinity(),
         std::numeric_limits<double>::quiet_NaN() })
  {
    std::vector<Point3> normals = before;
    smoothNormalsOver(mesh, radius, RunControl(), normals);
    CHECK(normals == before);
  }
  SurfaceMesh slivers = test::meshOf(test::gridPatch(20, 20));
  for (Point3& point : slivers.points)
  {
    point[1] *= 1e-14;
  }
  slivers.points[5] = slivers.points[6]; // no area at all
  std::vector<Point3> normals = waveNormals(slivers, 9.0, 0.5);
  smoothNormalsOver(slivers, 0.2, RunControl(), normals);
  for (const Point3& normal : normals)
  {
    CHECK_NEAR(normal.norm(), 1.0, 1e-14);
  }
  CHECK_NEAR(smoothingRadius(test::meshOf(test::cube()), 600), 0.15, 1e-15);
  CHECK_EQUAL(smoothingRadius(test::meshOf(test::cube()), 0), 0.0);
}

/** A cone of so many facets, in the order of their places in the fan or against it. */
SurfaceMesh coneOf(Index facets, bool reversed)
{
  SurfaceMesh cone;
  cone.points.emplace_back(0.0, 0.0, 1.0);
  std::vector<Triple> triangles;
  for (Index k = 0; k < facets; ++k)
  {
    const double angle = 2.0 * test::pi * k / facets;
    cone.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    const Index place = reversed ? facets - 1 - k : k;
    triangles.push_back({ 0, 1 + place, 1 + (place + 1) % facets });
  }
  for (Index point = 0; point < cone.numberOfPoints(); ++point)
  {
    cone.cornerPoints.push_back(point);
  }
  cone.facetPoints = triangles;
  cone.facetCorners = cone.facetPoints;
  return cone;
}

/**
 * A tip of 100 000 facets: whatever their order, they are put in order in about the same time, and
 * give the same normals but for rounding.
 */
void testFan()
{
  using Clock = std::chrono::steady_clock;
  constexpr Index facets = 100000;
  std::vector<Point3> before{ Point3(0.6, 0.0, 0.8) };
  for (Index k = 0; k < facets; ++k)
  {
    const double angle = 2.0 * test::pi * k / facets;
    before.push_back(Point3(std::cos(angle), std::sin(angle), 1.0).normalized());
  }
  std::vector<Point3> normals[2] = { before, before };
  Clock::duration spent[2];
  for (const int reversed : { 0, 1 })
  {
    const SurfaceMesh cone = coneOf(facets, reversed == 1);
    const Clock::time_point start = Clock::now();
    smoothNormalsOver(cone, 0.5, RunControl(), normals[reversed]);
    spent[reversed] = Clock::now() - start;
  }
  CHECK((normals[0][0] - before[0]).norm() > 0.01);
  CHECK(spent[1] < 10 * spent[0] + std::chrono::seconds(1));
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    CHECK_NEAR((normals[0][i] - normals[1][i]).norm(), 0.0, 1e-9);
  }
}
}

int TestNormalFlow(int, char*[])
{
  testDecay();
  testSmallPart();
  testSphere();
  testEqualNormals();
  testShrinkingSphere();
  testLocality();
  testControlAndScale();
  testOddInput();
  testFan();
  return test::result();
}
