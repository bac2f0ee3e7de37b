// Mesh/Orientation: consistent where possible, and decided by nothing but the input's own sense.

#include "Mesh/Intake.h"
#include "TestSupport.h"

#include <algorithm>
#include <string>

using namespace remesh;

namespace
{
/** By definition: no two facets run along an edge in the same direction. */
bool isConsistent(const SurfaceMesh& mesh)
{
  const auto directed = test::directedEdges(mesh);
  return std::all_of(
    directed.begin(), directed.end(), [](const auto& entry) { return entry.second == 1; });
}

/** Sum of the facets' normals times twice their areas. */
Point3 vectorArea(const SurfaceMesh& mesh)
{
  Point3 sum = Point3::Zero();
  for (const auto& [a, b, c] : mesh.facetPoints)
  {
    sum += (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
  }
  return sum;
}

/** Facets whose corners are not those of their input triangle in the same order. */
Index turnedFacets(const SurfaceMesh& mesh, const TriangleSoup& soup)
{
  Index count = 0;
  for (Index f = 0; f < mesh.numberOfFacets(); ++f)
  {
    count += mesh.facetInputPoints[f] != soup.triangles[mesh.facetInputCells[f]];
  }
  return count;
}

void testConsistentInputIsUntouched()
{
  const Point3 far(1e6, 1e6, -1e6);
  std::vector<TriangleSoup> soups = { test::gridPatch(20, 10, far), test::icosphere(2),
    test::torus(1.0, 0.4, 20, 10), test::cube() };
  const std::size_t count = soups.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    soups.push_back(soups[i]);
    for (std::size_t t = 0; t < soups[i].triangles.size(); ++t)
    {
      test::flip(soups.back(), t);
    }
  }
  for (const TriangleSoup& soup : soups)
  {
    SurfaceMesh mesh;
    IntakeReport report;
    CHECK(test::takeIn(soup, mesh, report).ok());
    CHECK(report.orientable);
    CHECK_EQUAL(report.flippedFacets, 0);
    CHECK_EQUAL(turnedFacets(mesh, soup), 0);
    CHECK(isConsistent(mesh));
  }
  // Inside out stays inside out.
  CHECK_NEAR(test::enclosedVolume(test::meshOf(soups[3])), 1.0, 1e-14);
  CHECK_NEAR(test::enclosedVolume(test::meshOf(soups[count + 3])), -1.0, 1e-14);
  CHECK_NEAR((vectorArea(test::meshOf(soups[0])) - Point3(0, 0, 2)).norm(), 0.0, 1e-8);
  CHECK_NEAR((vectorArea(test::meshOf(soups[count])) + Point3(0, 0, 2)).norm(), 0.0, 1e-8);
}

void testLargerAreaWins()
{
  // Every third triangle turned: they turn back. Two of three: the rest follows them.
  for (const std::size_t remainder : { std::size_t(0), std::size_t(1) })
  {
    TriangleSoup soup = test::gridPatch(15, 15, { -1e6, 0.0, 0.0 });
    Index turned = 0;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    {
      if ((t % 3 == 0) == (remainder == 0))
      {
        test::flip(soup, t);
        ++turned;
      }
    }
    SurfaceMesh mesh;
    IntakeReport report;
    CHECK(test::takeIn(soup, mesh, report).ok());
    CHECK(isConsistent(mesh));
    const Index expected = remainder == 0 ? turned : mesh.numberOfFacets() - turned;
    CHECK_EQUAL(report.flippedFacets, expected);
    CHECK_EQUAL(turnedFacets(mesh, soup), expected);
    CHECK_NEAR(vectorArea(mesh)[2], remainder == 0 ? 2.0 : -2.0, 1e-8);
  }
  // One large triangle against three small ones: area decides, not number.
  TriangleSoup fan = test::makeSoup(
    { { 0, 0, 0 }, { 10, 0, 0 }, { 0, 10, 0 }, { -1, 0, 0 }, { -1, -1, 0 }, { 0, -1, 0 } },
    { { 0, 3, 2 }, { 0, 4, 3 }, { 0, 5, 4 }, { 0, 1, 2 } });
  fan.triangles[0] = { 0, 3, 2 }; // faces -z, shares the edge 0-2
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(test::takeIn(fan, mesh, report).ok());
  CHECK_EQUAL(report.flippedFacets, 3);
  CHECK(vectorArea(mesh)[2] > 0.0);
}

void testTieKeepsTheFirst()
{
  for (const std::size_t turned : { std::size_t(0), std::size_t(1) })
  {
    // Half of the triangles turned, equal areas: whatever triangle 0 says.
    TriangleSoup soup = test::gridPatch(8, 8, { 1e6, 1e6, 0.0 });
    for (std::size_t t = turned; t < soup.triangles.size(); t += 2)
    {
      test::flip(soup, t);
    }
    SurfaceMesh mesh;
    IntakeReport report;
    CHECK(test::takeIn(soup, mesh, report).ok());
    CHECK(report.orientable);
    CHECK(isConsistent(mesh));
    CHECK_EQUAL(report.flippedFacets, 64);
    CHECK_NEAR(vectorArea(mesh)[2], turned == 0 ? -2.0 : 2.0, 1e-8);
  }
}

void testOneSided()
{
  for (const int n : { 5, 20, 101 })
  {
    TriangleSoup soup = test::moebiusStrip(n);
    test::append(soup, test::cube(), { 5.0, 0.0, 0.0 });
    test::flip(soup, 3);                         // in the strip: stays as it is
    test::flip(soup, soup.triangles.size() - 1); // in the cube: is put right
    SurfaceMesh mesh;
    IntakeReport report;
    CHECK(test::takeIn(soup, mesh, report).ok());
    CHECK(!report.orientable);
    CHECK_EQUAL(report.flippedFacets, 1);
    CHECK_EQUAL(turnedFacets(mesh, soup), 1);
  }
}

void testNonManifoldEdgesSeparate()
{
  // Each sheet keeps its own sense; within a sheet the two triangles agree.
  for (int sheet = 0; sheet < 3; ++sheet)
  {
    TriangleSoup soup = test::threeSheets();
    test::flip(soup, 2 * sheet);
    test::flip(soup, 2 * sheet + 1);
    SurfaceMesh mesh;
    IntakeReport report;
    CHECK(test::takeIn(soup, mesh, report).ok());
    CHECK(report.orientable);
    CHECK_EQUAL(report.flippedFacets, 0);
    CHECK_EQUAL(report.nonManifoldEdges, 1);
  }
  // Two tetrahedra that touch in a point are two shells, each with its own majority.
  TriangleSoup soup = test::tetrahedron();
  test::append(soup, test::tetrahedron(), { 0.0, 0.0, 1.0 });
  test::flip(soup, 1);
  for (const std::size_t t : { 4, 5, 6, 7 })
  {
    test::flip(soup, t);
  }
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(test::takeIn(soup, mesh, report).ok());
  CHECK_EQUAL(report.flippedFacets, 1);
  CHECK_EQUAL(report.components, 1);
  CHECK_NEAR(test::enclosedVolume(mesh), 0.0, 1e-15);
}

/** Turning a facet keeps its first corner, and the ids stay with their corners. */
void testCornersAfterTurning()
{
  TriangleSoup soup = test::icosphere(1);
  test::flip(soup, 17);
  const SurfaceMesh mesh = test::meshOf(soup);
  for (Index f = 0; f < mesh.numberOfFacets(); ++f)
  {
    const auto& triangle = soup.triangles[mesh.facetInputCells[f]];
    CHECK_EQUAL(mesh.facetInputPoints[f][0], triangle[0]);
    for (int k = 0; k < 3; ++k)
    {
      CHECK(mesh.points[mesh.facetPoints[f][k]] == soup.points[mesh.facetInputPoints[f][k]]);
    }
  }
}
}

int TestOrientation(int, char*[])
{
  testConsistentInputIsUntouched();
  testLargerAreaWins();
  testTieKeepsTheFirst();
  testOneSided();
  testNonManifoldEdgesSeparate();
  testCornersAfterTurning();
  return test::result();
}
