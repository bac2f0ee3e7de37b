// Mesh/Normals: estimated, smoothed and given ones, in corner space.

#include "Mesh/FacetGeometry.h"
#include "Mesh/Normals.h"
#include "TestSupport.h"

#include <algorithm>
#include <limits>
#include <set>

using namespace remesh;

namespace
{
double largestDifference(const std::vector<Point3>& a, const std::vector<Point3>& b)
{
  double largest = a.size() == b.size() ? 0.0 : 1.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    largest = std::max(largest, (a[i] - b[i]).norm());
  }
  return largest;
}

void testFacetNormals()
{
  // Unit normals at any scale, for slivers too.
  for (const double scale : { 1e-48, 1.0, 1e48 })
  {
    const auto at = [scale](double x, double y) { return Point3(scale * x, scale * y, 0.0); };
    const Point3 up = Point3::UnitZ();
    CHECK_NEAR((facetNormal(at(0, 0), at(1, 0), at(0, 1)) - up).norm(), 0.0, 1e-15);
    CHECK_NEAR((facetNormal(at(0, 0), at(1, 0), at(0, 1e-28)) - up).norm(), 0.0, 1e-15);
    CHECK_NEAR((facetNormal(at(0, 0), at(0.5, -1e-12), at(1, 0)) - up).norm(), 0.0, 1e-15);
    CHECK_NEAR(facetArea(at(0, 0), at(2, 0), at(7, 3)) / scale / scale, 3.0, 1e-14);
  }
}

/** On the plane all passes change nothing. On the cube the angle weights give the diagonals. */
void testExactCases()
{
  for (const int passes : { 0, 1, 20 })
  {
    for (const Point3& normal :
      estimateCornerNormals(test::meshOf(test::gridPatch(5, 9, { 1e5, 0, 0 })), passes))
    {
      CHECK_NEAR((normal - Point3::UnitZ()).norm(), 0.0, 1e-15);
    }
  }
  // However the faces are cut: each face contributes a right angle.
  const SurfaceMesh cube = test::meshOf(test::cube());
  const std::vector<Point3> normals = estimateCornerNormals(cube, 0);
  for (Index corner = 0; corner < cube.numberOfCorners(); ++corner)
  {
    const Point3 expected = (cube.points[corner] - Point3(0.5, 0.5, 0.5)).normalized();
    CHECK_NEAR((normals[corner] - expected).norm(), 0.0, 1e-15);
  }
}

/** On the sphere the position is the normal: exact by symmetry, then of first order. */
void testConvergence()
{
  const auto errorAt = [](int level)
  {
    const SurfaceMesh sphere = test::meshOf(test::icosphere(level));
    return largestDifference(estimateCornerNormals(sphere, 0), sphere.points);
  };
  CHECK_NEAR(errorAt(0), 0.0, 1e-15);
  CHECK_NEAR(errorAt(1), 0.0, 1e-15);
  for (int level = 2; level <= 5; ++level)
  {
    CHECK_NEAR(errorAt(level) * (1 << level), 0.0417, 1e-3);
  }
}

/** The smoothing by definition, with sets of neighbours. */
void testSmoothing()
{
  const SurfaceMesh mesh = test::meshOf(test::gridPatch(6, 6));
  SurfaceMesh bumpy = mesh;
  for (Point3& point : bumpy.points)
  {
    point[2] = 0.3 * std::sin(7.0 * point[0]) * std::cos(5.0 * point[1]);
  }
  std::vector<std::set<Index>> rings(bumpy.points.size());
  for (const Triple& corners : bumpy.facetCorners)
  {
    for (int k = 0; k < 3; ++k)
    {
      rings[corners[k]].insert({ corners[(k + 1) % 3], corners[(k + 2) % 3] });
    }
  }
  std::vector<Point3> expected = estimateCornerNormals(bumpy, 0);
  for (int passes = 1; passes <= 4; ++passes)
  {
    const std::vector<Point3> before = expected;
    for (std::size_t corner = 0; corner < expected.size(); ++corner)
    {
      for (const Index neighbour : rings[corner])
      {
        expected[corner] += before[neighbour];
      }
      expected[corner].normalize();
    }
    CHECK(largestDifference(estimateCornerNormals(bumpy, passes), expected) < 1e-14);
  }
}

/** Equal bytes for any order of the blocks, and cancelling ends the passes. */
void testControl()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(4));
  const std::vector<Point3> expected = estimateCornerNormals(mesh, 7);
  for (const Schedule schedule : { Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    RunControl control;
    control.schedule = schedule;
    CHECK(estimateCornerNormals(mesh, 7, control) == expected);
  }
  const RunControl stop({}, []() { return true; });
  CHECK(estimateCornerNormals(mesh, 10000, stop) == estimateCornerNormals(mesh, 0));
}

/** A cube split along its edges has one normal per face, and nothing flows across. */
void testCornerSpace()
{
  SurfaceMesh cube = test::meshOf(test::cube());
  cube.cornerPoints.clear();
  std::map<std::pair<Index, Index>, Index> cornerOf; // (point, face) to corner
  std::vector<Triple> corners = cube.facetPoints;
  for (Index f = 0; f < cube.numberOfFacets(); ++f)
  {
    const auto face = static_cast<Index>(cube.facetInputCells[f] / 2);
    for (int k = 0; k < 3; ++k)
    {
      const Index point = cube.facetPoints[f][k];
      const auto [entry, isNew] = cornerOf.try_emplace({ point, face }, cube.numberOfCorners());
      if (isNew)
      {
        cube.cornerPoints.push_back(point);
      }
      corners[f][k] = entry->second;
    }
  }
  cube.facetCorners = corners;
  CHECK_EQUAL(cube.numberOfCorners(), 24);
  const std::vector<Point3> normals = estimateCornerNormals(cube, 5);
  for (Index f = 0; f < cube.numberOfFacets(); ++f)
  {
    const auto& [a, b, c] = cube.facetPoints[f];
    const Point3 expected = facetNormal(cube.points[a], cube.points[b], cube.points[c]);
    for (const Index corner : cube.facetCorners[f])
    {
      CHECK_NEAR((normals[corner] - expected).norm(), 0.0, 1e-15);
    }
  }
}

/** Two facets that meet back to back: no direction, so that of the first facet. */
void testNoDirection()
{
  const SurfaceMesh fold = test::meshOf(test::makeSoup(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0.5, 0 } }, { { 0, 1, 2 }, { 1, 0, 3 } }));
  SurfaceMesh closed = fold; // a pillow without filling: four facets that cancel in pairs
  closed.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  closed.facetPoints = std::vector<Triple>{ { 0, 1, 2 }, { 0, 2, 1 } };
  closed.facetCorners = closed.facetPoints;
  closed.cornerPoints = { 0, 1, 2 };
  for (const int passes : { 0, 3 })
  {
    for (const Point3& normal : estimateCornerNormals(closed, passes))
    {
      CHECK_NEAR((normal - Point3::UnitZ()).norm(), 0.0, 1e-15);
    }
    for (const Point3& normal : estimateCornerNormals(fold, passes))
    {
      CHECK_NEAR(normal.norm(), 1.0, 1e-15);
    }
  }
}

void testGiven()
{
  // Two patches that share the line x = 1, with points of their own: the means count each
  // input point once, whatever its number of facets and the length of its normal.
  TriangleSoup soup = test::gridPatch(1, 3);
  test::append(soup, test::gridPatch(2, 3), { 1.0, 0.0, 0.0 });
  const SurfaceMesh mesh = test::meshOf(soup);
  CHECK_EQUAL(mesh.numberOfPoints(), 16);
  std::vector<Point3> given(soup.points.size(), Point3(2.0, 0.0, 0.0));
  std::fill(given.begin() + 8, given.end(), Point3(0.0, 0.0, 5e-300));
  std::vector<Point3> normals;
  CHECK(givenCornerNormals(mesh, given, normals).ok());
  for (Index corner = 0; corner < mesh.numberOfCorners(); ++corner)
  {
    const double x = mesh.points[corner][0];
    const Point3 expected = x < 1.0 ? Point3(1, 0, 0)
      : x > 1.0                     ? Point3(0, 0, 1)
                                    : Point3(std::sqrt(0.5), 0, std::sqrt(0.5));
    CHECK_NEAR((normals[corner] - expected).norm(), 0.0, 1e-15);
  }
  // Opposite or missing directions: estimated ones.
  std::fill(given.begin(), given.begin() + 8, Point3(0.0, 0.0, -1.0));
  std::fill(given.begin() + 8, given.end(), Point3(0.0, 0.0, 1.0));
  given[0].setZero();
  CHECK(givenCornerNormals(mesh, given, normals).ok());
  for (Index corner = 0; corner < mesh.numberOfCorners(); ++corner)
  {
    const bool isMissing = mesh.points[corner].isZero(0.0);
    const double expected = mesh.points[corner][0] < 1.0 && !isMissing ? -1.0 : 1.0;
    CHECK_NEAR(normals[corner][2], expected, 1e-15);
  }
}

void testGivenRefusals()
{
  TriangleSoup soup = test::cube();
  soup.points.emplace_back(9, 9, 9); // not used
  const SurfaceMesh mesh = test::meshOf(soup);
  std::vector<Point3> given(9, Point3::UnitX());
  given[8][0] = std::numeric_limits<double>::quiet_NaN();
  std::vector<Point3> normals;
  CHECK(givenCornerNormals(mesh, given, normals).ok());
  given[4][1] = std::numeric_limits<double>::infinity();
  const Status status = givenCornerNormals(mesh, given, normals);
  CHECK(status.code == StatusCode::InvalidInput);
  CHECK(status.message.find("point 4 ") != std::string::npos);
  given.resize(3);
  CHECK(givenCornerNormals(mesh, given, normals).code == StatusCode::InvalidInput);
}
}

int TestNormals(int, char*[])
{
  testFacetNormals();
  testExactCases();
  testConvergence();
  testSmoothing();
  testControl();
  testCornerSpace();
  testNoDirection();
  testGiven();
  testGivenRefusals();
  return test::result();
}
