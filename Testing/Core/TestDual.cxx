// Delaunay/Dual: the topology and the orientation of the surface, for enough sites.

#include "Optimization/Lloyd.h"
#include "TestDuals.h"

#include <set>

using namespace remesh;

namespace
{
/** Evenly spread sites. */
Sites relaxed(const EmbeddedSurface& surface, Offset n)
{
  Sites sites = test::sampled(surface, n, 1, SamplingMethod::Stratified);
  RestrictedVoronoi voronoi(surface);
  CellSums sums;
  Convergence convergence;
  Index empty = 0;
  CHECK(
    relaxLloyd({ voronoi, surface, 1, sites, sums, convergence, empty }, 15, RunControl()).ok());
  return sites;
}

/** The sites whose cells share a segment, by the diagram's own edges. */
void checkNeighbors(const test::PlacedDiagram& diagram, Index numberOfSites)
{
  std::vector<std::set<Index>> neighbors(static_cast<std::size_t>(numberOfSites));
  for (Offset p = 0; p < diagram.numberOfPieces(); ++p)
  {
    for (const test::DiagramVertex& vertex : test::loopOf(diagram, p))
    {
      if (vertex.across >= 0)
      {
        neighbors[diagram.sites[p]].insert(vertex.across);
      }
    }
  }
  std::vector<Index> counts;
  CHECK(countNeighbors(diagram, numberOfSites, RunControl(), counts).ok());
  CHECK_EQUAL(Index(counts.size()), numberOfSites);
  for (std::size_t site = 0; site < counts.size(); ++site)
  {
    CHECK_EQUAL(counts[site], Index(neighbors[site].size()));
  }
}

/** One triangle for each point of three cells, none twice; Euler's number and crowded edges. */
test::DualOf checkedDual(
  const SurfaceMesh& mesh, const EmbeddedSurface& surface, const Sites& sites)
{
  const test::Computed result = test::computed(surface, sites);
  const test::DualOf made = test::dualOf(mesh, surface, result);
  checkNeighbors(result.diagram, sites.count());
  Offset meetings = 0;
  for (Offset p = 0; p < result.diagram.numberOfPieces(); ++p)
  {
    const std::vector<test::DiagramVertex> loop = test::loopOf(result.diagram, p);
    for (std::size_t v = 0; v + 1 < loop.size(); ++v)
    {
      meetings += loop[v].across >= 0 && loop[v == 0 ? loop.size() - 2 : v - 1].across >= 0;
    }
  }
  const auto count = static_cast<Offset>(made.dual.triangles.size());
  CHECK_EQUAL(3 * (count + static_cast<Offset>(made.dual.repeated.size())), meetings);
  std::set<std::set<Index>> distinct;
  std::set<std::pair<Index, Index>> edges;
  for (const Triple& t : made.dual.triangles)
  {
    distinct.insert({ t[0], t[1], t[2] });
    for (int k = 0; k < 3; ++k)
    {
      edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
  }
  CHECK_EQUAL(Offset(distinct.size()), count);
  const test::Shape shape = test::shapeOf(made.dual.triangles);
  CHECK_EQUAL(made.dual.eulerCharacteristic, shape.vertices - Offset(edges.size()) + count);
  CHECK_EQUAL(made.dual.edges.numberOfNonManifold(), Offset(shape.crowdedEdges));
  return made;
}

void testClosedSurfaces()
{
  const SurfaceMesh sphere = test::meshOf(test::icosphere(3));
  const SurfaceMesh ring = test::meshOf(test::torus(1.0, 0.4, 36, 18));
  for (const int d : { 3, 6 })
  {
    for (const SurfaceMesh* mesh : { &sphere, &ring })
    {
      const EmbeddedSurface surface = test::embedded(*mesh, d);
      const test::DualOf made = checkedDual(*mesh, surface, relaxed(surface, 300));
      const test::Shape shape = test::shapeOf(made.dual.triangles);
      CHECK(shape.isManifold());
      CHECK_EQUAL(shape.borderEdges, 0);
      CHECK_EQUAL(shape.pieces, 1);
      CHECK_EQUAL(shape.vertices, 300);
      CHECK_EQUAL(made.dual.eulerCharacteristic, mesh == &sphere ? 2 : 0);
      CHECK(made.dual.repeated.empty());
      // About the input's volume: outward.
      const double volume = test::enclosedVolume(*mesh);
      CHECK_NEAR(test::enclosedVolume(made), volume, 0.1 * volume);
    }
  }
}

void testInsideOut()
{
  TriangleSoup soup = test::icosphere(3);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    test::flip(soup, t);
  }
  const SurfaceMesh mesh = test::meshOf(soup);
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  const test::DualOf made = checkedDual(mesh, surface, relaxed(surface, 200));
  CHECK(test::shapeOf(made.dual.triangles).isManifold());
  CHECK_NEAR(test::enclosedVolume(made), test::enclosedVolume(mesh), 0.5);
}

/** Faces up, wherever it is. */
void testPatch()
{
  for (const Point3& origin : { Point3(0, 0, 0), Point3(1e6, -1e6, 1e6) })
  {
    const SurfaceMesh mesh = test::meshOf(test::gridPatch(12, 12, origin));
    const EmbeddedSurface surface = test::embedded(mesh, 3);
    const test::DualOf made = checkedDual(mesh, surface, relaxed(surface, 100));
    const test::Shape shape = test::shapeOf(made.dual.triangles);
    CHECK(shape.isManifold());
    CHECK_EQUAL(shape.pieces, 1);
    CHECK_EQUAL(shape.vertices, 100);
    CHECK_EQUAL(made.dual.eulerCharacteristic, 1);
    for (const auto& [a, b, c] : made.dual.triangles)
    {
      const Point3 p = made.vertex(a);
      CHECK((made.vertex(b) - p).cross(made.vertex(c) - p).z() > 0.0);
    }
  }
}

/** Three sheets on one line: the dual is joined there, and each sheet is there. */
void testThreeSheets()
{
  TriangleSoup soup;
  for (int sheet = 0; sheet < 3; ++sheet)
  {
    TriangleSoup square = test::gridPatch(8, 8);
    const Eigen::AngleAxisd turn(2.0 * test::pi * sheet / 3.0, Point3::UnitY());
    for (Point3& point : square.points)
    {
      point = point.x() == 0.0 ? point : Point3(turn * point);
    }
    test::append(soup, square, Point3::Zero());
  }
  const SurfaceMesh mesh = test::meshOf(soup);
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  const test::DualOf made = checkedDual(mesh, surface, relaxed(surface, 200));
  const test::Shape shape = test::shapeOf(made.dual.triangles);
  CHECK_EQUAL(shape.pieces, 1);
  CHECK_EQUAL(shape.vertices, 200);
  CHECK(made.dual.edges.numberOfNonManifold() > 0);
}

/** One or two cells meet nowhere in three. */
void testFewSites()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(1));
  const EmbeddedSurface surface = test::embedded(mesh, 6);
  for (const Offset n : { 1, 2 })
  {
    const test::DualOf made = checkedDual(mesh, surface, test::sampled(surface, n, 1));
    CHECK(made.dual.triangles.empty());
    CHECK_EQUAL(made.dual.eulerCharacteristic, 0);
  }
}
}

int TestDual(int, char*[])
{
  testClosedSurfaces();
  testInsideOut();
  testPatch();
  testThreeSheets();
  testFewSites();
  return test::result();
}
