// Mesh/Intake, Mesh/Weld: which points become one, by equality, by distance and by sides that are
// nothing but rounding.

#include "Mesh/Weld.h"
#include "Support/Random.h"
#include "TestSupport.h"

#include <limits>

using namespace remesh;

namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/** Each triangle with points of its own, some of them -0. */
TriangleSoup exploded(const TriangleSoup& soup)
{
  std::vector<Point3> points;
  std::vector<std::array<Offset, 3>> triangles;
  for (const auto& triangle : soup.triangles)
  {
    const auto first = static_cast<Offset>(points.size());
    for (const Offset point : triangle)
    {
      const bool negate = points.size() % 2 == 0;
      points.push_back(
        soup.points[point].unaryExpr([negate](double x) { return x == 0.0 && negate ? -0.0 : x; }));
    }
    triangles.push_back({ first, first + 1, first + 2 });
  }
  return test::makeSoup(std::move(points), std::move(triangles));
}

void testMerging()
{
  for (const TriangleSoup& soup : { test::cube(), test::icosphere(2), test::gridPatch(9, 9) })
  {
    SurfaceMesh mesh;
    IntakeReport report;
    CHECK(test::takeIn(exploded(soup), mesh, report).ok());
    CHECK_EQUAL(mesh.numberOfPoints(), static_cast<Index>(soup.points.size()));
    CHECK_EQUAL(
      report.mergedPoints, static_cast<Offset>(3 * soup.triangles.size() - soup.points.size()));
    CHECK_EQUAL(report.components, 1);
    CHECK(mesh.facetPoints == test::meshOf(soup).facetPoints);
    const TriangleSoup apart = exploded(soup); // where facets have their own points at one place
    for (Index f = 0; f < mesh.numberOfFacets(); ++f)
    {
      CHECK(mesh.facetInputPoints[f] == apart.triangles[mesh.facetInputCells[f]]);
    }
  }
  // The next double is another point.
  TriangleSoup crack = exploded(test::gridPatch(1, 1));
  crack.points[3][0] = std::nextafter(0.0, 1.0);
  IntakeReport report;
  SurfaceMesh mesh;
  CHECK(test::takeIn(crack, mesh, report).ok());
  CHECK_EQUAL(report.mergedPoints, 1);
  CHECK_EQUAL(report.boundaryEdges, 6);
  CHECK_EQUAL(report.gaps.points, 1);
  crack.points[3][0] = 1e-6;
  CHECK(test::takeIn(crack, mesh, report).ok());
  CHECK_EQUAL(report.gaps.points, 1);
  crack.points[3][0] = 0.1; // nothing is near
  CHECK(test::takeIn(crack, mesh, report).ok());
  CHECK_EQUAL(report.gaps.points, 0);
}

/** A grid bent to a tube whose last column of points is the first one again, but for rounding. */
void testShortSides()
{
  constexpr int n = 24;
  const auto tube = [](double rounding)
  {
    TriangleSoup soup = test::gridPatch(n, 4); // n + 1 columns; then the seam
    for (std::size_t i = 0; i < soup.points.size(); ++i)
    {
      Point3& p = soup.points[i];
      const double angle = 2.0 * test::pi * p[0];
      const bool isLast = p[0] == 1.0;
      p = Point3(isLast ? 1.0 : std::cos(angle), isLast ? rounding : std::sin(angle), p[1]);
    }
    std::vector<Offset> first;
    std::vector<Offset> last;
    for (std::size_t i = 0; i < soup.points.size(); ++i)
    {
      const Point3& p = soup.points[i];
      if (p[0] == 1.0)
      {
        (p[1] == 0.0 ? first : last).push_back(static_cast<Offset>(i));
      }
    }
    for (std::size_t k = 0; k + 1 < last.size(); ++k)
    {
      soup.triangles.push_back({ last[k], first[k], last[k + 1] });
      soup.triangles.push_back({ first[k], first[k + 1], last[k + 1] });
    }
    soup.inputCells.resize(soup.triangles.size(), 0);
    return soup;
  };
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(test::takeIn(tube(-2e-16), mesh, report).ok());
  CHECK_EQUAL(report.mergedPoints, 5);
  CHECK_EQUAL(report.droppedDegenerate, 8);
  CHECK_EQUAL(report.boundaryEdges, 2 * n);
  CHECK_EQUAL(mesh.numberOfPoints(), 5 * n);
  CHECK_EQUAL(report.gaps.points, 0);
  // Nor does a small part vanish beside one far away.
  TriangleSoup far = test::icosphere(1);
  const auto alone = static_cast<Index>(far.triangles.size());
  test::append(far, test::gridPatch(1, 1), Point3(1e14, 0.0, 0.0));
  CHECK(test::takeIn(far, mesh, report).ok());
  CHECK(mesh.numberOfFacets() >= alone);
  // What is small but no rounding stays.
  CHECK(test::takeIn(tube(-1e-9), mesh, report).ok());
  CHECK_EQUAL(report.mergedPoints, 0);
  CHECK_EQUAL(mesh.numberOfFacets(), 2 * n * 4 + 8);
}

/** The clusters by definition: all pairs, until nothing changes. */
std::vector<Index> weldByDefinition(const std::vector<Point3>& points, double distance)
{
  std::vector<Index> lowest(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    lowest[i] = static_cast<Index>(i);
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      for (std::size_t j = 0; j < points.size(); ++j)
      {
        if (lowest[j] < lowest[i] && (points[i] - points[j]).squaredNorm() < distance * distance)
        {
          lowest[i] = lowest[j];
          changed = true;
        }
      }
    }
  }
  return lowest;
}

void testMergeDistance()
{
  std::vector<Point3> points;
  for (int i = 0; i < 300; ++i)
  {
    // Fractions of 1/16 give many pairs exactly as far apart as some distances below.
    const auto coordinate = [i](int k) { return std::floor(16.0 * uniform01(1, i, k)) / 16.0; };
    points.emplace_back(coordinate(0), coordinate(1), i % 3 == 0 ? coordinate(2) : 1e-9 * i);
  }
  for (const double distance : { 1e-12, 2e-9, 1e-3, 1.0 / 16.0, 0.07, 0.1, 0.2, 0.5, 10.0, 1e300 })
  {
    CHECK(weldNearPoints(points, distance, RunControl()) == weldByDefinition(points, distance));
  }
  // Below the finest grid: an outlier makes the cells wider than the distance.
  points.emplace_back(1e9, 0.0, 0.0);
  CHECK(weldNearPoints(points, 1e-8, RunControl()) == weldByDefinition(points, 1e-8));
  CHECK(weldNearPoints(points, 1e-15, RunControl()) == weldByDefinition(points, 1e-15));

  TriangleSoup soup = exploded(test::icosphere(2));
  for (std::size_t i = 0; i < soup.points.size(); ++i)
  {
    soup.points[i] += 1e-6 * Point3(uniform01(2, i, 0), uniform01(2, i, 1), uniform01(2, i, 2));
  }
  IntakeOptions options;
  options.mergeDistance = 1e-5;
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(buildSurfaceMesh(soup, options, RunControl(), mesh, report).ok());
  CHECK_EQUAL(mesh.numberOfPoints(), 162);
  CHECK_EQUAL(report.boundaryEdges, 0);
  for (const double bad : { -1.0, infinity, notANumber })
  {
    options.mergeDistance = bad;
    CHECK(
      buildSurfaceMesh(soup, options, RunControl(), mesh, report).code == StatusCode::InvalidInput);
  }
}
}

int TestMerging(int, char*[])
{
  testMerging();
  testShortSides();
  testMergeDistance();
  return test::result();
}
