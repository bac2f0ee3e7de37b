// Mesh/CapSplit: triangles without area leave no slit where they were, and nothing else changes.

#include "Mesh/FacetGeometry.h"
#include "Support/Random.h"
#include "TestSupport.h"

#include <algorithm>
#include <cmath>
#include <map>

using namespace remesh;

namespace
{
/** Halfway along an edge of each `step`th triangle a point, and a triangle without area beside it.
 */
TriangleSoup withCaps(const TriangleSoup& soup, std::size_t step, std::uint64_t seed)
{
  TriangleSoup capped;
  capped.points = soup.points;
  std::vector<std::array<Offset, 3>> triangles;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    const auto& triangle = soup.triangles[t];
    if ((t + seed) % step != 0)
    {
      triangles.push_back(triangle);
      continue;
    }
    const auto k = static_cast<std::size_t>(3.0 * uniform01(seed, t, 0));
    const Offset a = triangle[k];
    const Offset b = triangle[(k + 1) % 3];
    const Offset c = triangle[(k + 2) % 3];
    const auto middle = static_cast<Offset>(capped.points.size());
    capped.points.push_back(0.5 * (soup.points[a] + soup.points[b])); // exact here
    triangles.push_back({ a, middle, c });
    triangles.push_back({ middle, b, c });
    triangles.push_back({ a, b, middle });
  }
  return test::makeSoup(capped.points, triangles);
}

double areaOf(const SurfaceMesh& mesh)
{
  double area = 0.0;
  for (Index f = 0; f < mesh.numberOfFacets(); ++f)
  {
    const auto& [a, b, c] = mesh.facetPoints[f];
    area += facetArea(mesh.points[a], mesh.points[b], mesh.points[c]);
  }
  return area;
}

/** Each facet is a part of its cell, and tells which of the caller's points its corners are. */
void checkCells(const TriangleSoup& soup, const SurfaceMesh& mesh)
{
  std::map<std::int64_t, double> areas;
  for (Index f = 0; f < mesh.numberOfFacets(); ++f)
  {
    const auto& [a, b, c] = mesh.facetPoints[f];
    areas[mesh.facetInputCells[f]] += facetArea(mesh.points[a], mesh.points[b], mesh.points[c]);
    for (int k = 0; k < 3; ++k)
    {
      CHECK(mesh.points[mesh.facetPoints[f][k]] == soup.points[mesh.facetInputPoints[f][k]]);
    }
    CHECK(hasArea(mesh.points[a], mesh.points[b], mesh.points[c]));
  }
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    const auto& [a, b, c] = soup.triangles[t];
    CHECK_NEAR(
      areas[soup.inputCells[t]], facetArea(soup.points[a], soup.points[b], soup.points[c]), 1e-15);
  }
}

/** Caps on caps, on both sides of edges and along the sides of others: closed as before. */
void testClosed()
{
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    TriangleSoup soup = test::cube();
    for (int round = 0; round < 5; ++round)
    {
      soup = withCaps(soup, 1 + (seed + static_cast<std::uint64_t>(round)) % 3, seed);
    }
    SurfaceMesh mesh;
    IntakeReport report;
    CHECK(test::takeIn(soup, mesh, report).ok());
    CHECK(report.droppedDegenerate > 0);
    CHECK_EQUAL(report.boundaryEdges, 0);
    CHECK_EQUAL(report.nonManifoldEdges, 0);
    CHECK_EQUAL(report.components, 1);
    CHECK_EQUAL(report.flippedFacets, 0);
    CHECK_EQUAL(mesh.numberOfFacets(), 2 * mesh.numberOfPoints() - 4); // as a sphere
    CHECK_NEAR(areaOf(mesh), 6.0, 1e-13);
    checkCells(soup, mesh);
  }
}

/** On a border nothing is across: the corner lies on the border then. */
void testBorder()
{
  const std::vector<Point3> points = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 1, 0, 0 } };
  const TriangleSoup soup = test::makeSoup(points, { { 0, 3, 2 }, { 3, 1, 2 }, { 0, 1, 3 } });
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(test::takeIn(soup, mesh, report).ok());
  CHECK_EQUAL(report.droppedDegenerate, 1);
  CHECK_EQUAL(mesh.numberOfFacets(), 2);
  CHECK_EQUAL(report.boundaryEdges, 4);
  checkCells(soup, mesh);
}

/** Three sheets on one edge, and a cap there: each of them is split. */
void testManySheets()
{
  const std::vector<Point3> points = { { 0, 0, 0 }, { 2, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
    { 1, 0, 1 }, { 1, -1, 0 } };
  const TriangleSoup soup =
    test::makeSoup(points, { { 0, 1, 3 }, { 0, 1, 4 }, { 0, 2, 5 }, { 2, 1, 5 }, { 1, 0, 2 } });
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(test::takeIn(soup, mesh, report).ok());
  CHECK_EQUAL(mesh.numberOfFacets(), 6);
  CHECK_EQUAL(report.nonManifoldEdges, 2);
  CHECK_EQUAL(report.boundaryEdges, 6);
  checkCells(soup, mesh);
}

/** The same three points on a line, twice: what is on their sides stays joined. */
void testTwins()
{
  const std::vector<Point3> points = { { 0, 0, 0 }, { 2, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
    { 1, -1, 0 } };
  const TriangleSoup soup = test::makeSoup(
    points, { { 0, 2, 3 }, { 2, 1, 3 }, { 0, 1, 2 }, { 1, 0, 2 }, { 2, 0, 4 }, { 1, 2, 4 } });
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(test::takeIn(soup, mesh, report).ok());
  CHECK_EQUAL(report.droppedDegenerate, 2);
  CHECK_EQUAL(mesh.numberOfFacets(), 4);
  CHECK_EQUAL(report.boundaryEdges, 4);
  CHECK_EQUAL(report.nonManifoldEdges, 0);
}

/** A whole sphere pressed onto a line, beside a triangle: it ends, and that one is left. */
void testCollapsed()
{
  TriangleSoup sphere = test::icosphere(4);
  for (Point3& point : sphere.points)
  {
    point = { point.x(), 0.0, 0.0 };
  }
  TriangleSoup soup = sphere;
  test::append(soup, test::makeSoup({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }),
    { 5.0, 0.0, 0.0 });
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(test::takeIn(soup, mesh, report).ok());
  CHECK_EQUAL(mesh.numberOfFacets(), 1);
  CHECK(test::takeIn(sphere, mesh, report).code == StatusCode::EmptyInput);
}
}

int TestCapSplit(int, char*[])
{
  testClosed();
  testBorder();
  testManySheets();
  testTwins();
  testCollapsed();
  return test::result();
}
