// Restricted Voronoi diagrams of sites that tie: everywhere, on edges, at corners, on circles.

#include "TestDiagrams.h"
#include "TestDuals.h"

#include <algorithm>
#include <chrono>

using namespace remesh;

namespace
{
/** All sites at one place: the lowest id has the whole surface. */
void testCoincidentSites()
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    const EmbeddedSurface surface = test::embedded(mesh, 6);
    Sites sites = test::sampled(surface, 60, 1);
    for (Index site = 1; site < sites.count(); ++site)
    {
      std::copy_n(sites.site(0), 6, sites.site(site));
    }
    const test::Computed result = test::computed(surface, sites);
    test::checkDiagram(mesh, surface, sites, result);
    CHECK_EQUAL(result.diagram.numberOfPieces(), Offset(surface.numberOfFacets()));
    CHECK_EQUAL(std::count(result.diagram.sites.begin(), result.diagram.sites.end(), 0),
      result.diagram.numberOfPieces());
  }
}

/** Pairs of coincident sites: of each the lower id has the cell that the pair would have alone. */
void testTwins()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 12, 9));
  for (const int d : { 3, 8 })
  {
    const EmbeddedSurface surface = test::embedded(mesh, d);
    const Sites single = test::sampled(surface, 25, 2);
    Sites twins = single;
    for (Index site = single.count() - 1; site >= 0; --site)
    {
      twins.coordinates.insert(twins.coordinates.end(), single.site(site), single.site(site) + d);
    }
    const test::Computed expected = test::computed(surface, single);
    const test::Computed result = test::computed(surface, twins);
    test::checkTiling(surface, result.diagram);
    CHECK(result.diagram.sites == expected.diagram.sites);
    CHECK(result.owners == expected.owners);
    for (Index site = 0; site < twins.count(); ++site)
    {
      const double mass = site < single.count() ? expected.sums.mass[site] : 0.0;
      CHECK_NEAR(result.sums.mass[site], mass, 1e-14);
    }
  }
}

/** Sites on the surface's points and on the middles of its edges. */
void testSitesOnTheMesh()
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    const EmbeddedSurface surface = test::embedded(mesh, 3);
    Sites corners;
    corners.dimension = 3;
    corners.coordinates = surface.corners;
    Sites middles = corners;
    for (const Triple& facet : surface.facetCorners)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double* a = surface.corner(facet[k]);
        const double* b = surface.corner(facet[(k + 1) % 3]);
        for (int c = 0; c < 3; ++c)
        {
          middles.coordinates.push_back(0.5 * (a[c] + b[c])); // most of them twice
        }
      }
    }
    for (const Sites& sites : { corners, middles })
    {
      const test::Computed result = test::computed(surface, sites);
      test::checkDiagram(mesh, surface, sites, result);
    }
    const test::Computed result = test::computed(surface, corners);
    for (Index corner = 0; corner < surface.numberOfCorners(); ++corner)
    {
      CHECK_EQUAL(result.owners[corner], corner);
    }
  }
}

/**
 * m x m sites in the middles of the squares of a grid, on a patch of k x k squares: four cells meet
 * at each inner corner of the grid. Cells are squares, and the dual triangulates the m x m points.
 */
void checkCircularGrid(int k, int m, const Point3& shift, std::uint64_t shuffle)
{
  const SurfaceMesh mesh = test::meshOf(test::gridPatch(k, k));
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  std::vector<Point3> places;
  for (int s = 0; s < m * m; ++s)
  {
    places.push_back(Point3((s % m + 0.5) / m, (s / m + 0.5) / m, 0.0) + shift);
  }
  for (std::size_t s = places.size(); s > 1 && shuffle > 0; --s)
  {
    const double at = uniform01(shuffle, s, 0) * static_cast<double>(s);
    std::swap(places[s - 1], places[static_cast<std::size_t>(at)]);
  }
  const Sites sites = test::sitesAt(surface, places);
  const test::Computed result = test::computed(surface, sites);
  test::checkDiagram(mesh, surface, sites, result);
  for (const double area : measureCellAreas(mesh, result.diagram, sites.count()))
  {
    CHECK_NEAR(area, 1.0 / (m * m), 1e-14);
  }
  const test::DualOf dual = test::dualOf(mesh, surface, result);
  CHECK_EQUAL(dual.components.count(), m * m);
  CHECK_EQUAL(dual.dual.triangles.size(), std::size_t(2) * (m - 1) * (m - 1));
  CHECK_EQUAL(dual.dual.eulerCharacteristic, 1);
  CHECK(dual.dual.repeated.empty());
  const test::Shape shape = test::shapeOf(dual.dual.triangles);
  CHECK(shape.isManifold());
  CHECK_EQUAL(shape.borderEdges, 4 * (m - 1));
}

void testCircularGrids()
{
  for (const int k : { 1, 2, 3, 8 })
  {
    for (const int m : { 2, 4, 8 })
    {
      for (const std::uint64_t shuffle : { 0, 1, 2, 3 })
      {
        checkCircularGrid(k, m, Point3::Zero(), shuffle);
        checkCircularGrid(k, m, Point3(0, 0, 0.5), shuffle);
      }
    }
  }
}

/** The same where neither the grid nor the patch is exact in doubles: ties within rounding. */
void testInexactGrids()
{
  for (const int k : { 3, 5, 6, 7 })
  {
    for (const int m : { 3, 5, 6, 7 })
    {
      checkCircularGrid(k, m, Point3(0, 0, 0.1), 4);
    }
  }
}

/** Sites far away on a line through the middle of a sphere: cells meet along tilted circles. */
void testSitesOnAnAxis()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(2));
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  std::vector<Point3> places;
  for (int s = -4; s <= 4; ++s)
  {
    places.emplace_back(0.0, 0.0, 0.25 * s);
  }
  const Sites sites = test::sitesAt(surface, places);
  const test::Computed result = test::computed(surface, sites);
  test::checkDiagram(mesh, surface, sites, result);
  for (Index site = 0; site < 9; ++site)
  {
    CHECK_NEAR(result.sums.mass[site], result.sums.mass[8 - site], 1e-13);
  }
  const test::DualOf dual = test::dualOf(mesh, surface, result);
  CHECK(dual.dual.triangles.empty());
}

/** The eight corners of a cube as sites of the cube, and of a sphere around its middle. */
void testSymmetricSites()
{
  std::vector<Point3> places;
  for (int s = 0; s < 8; ++s)
  {
    places.emplace_back(s & 1 ? 0.5 : -0.5, s & 2 ? 0.5 : -0.5, s & 4 ? 0.5 : -0.5);
  }
  TriangleSoup box = test::cube();
  for (Point3& point : box.points)
  {
    point -= Point3(0.5, 0.5, 0.5);
  }
  for (const TriangleSoup& soup : { box, test::icosphere(2) })
  {
    const SurfaceMesh mesh = test::meshOf(soup);
    const EmbeddedSurface surface = test::embedded(mesh, 3);
    const Sites sites = test::sitesAt(surface, places);
    const test::Computed result = test::computed(surface, sites);
    test::checkDiagram(mesh, surface, sites, result);
    for (const double mass : result.sums.mass)
    {
      CHECK_NEAR(mass, surface.mass / 8.0, 1e-13);
    }
    const test::DualOf dual = test::dualOf(mesh, surface, result);
    CHECK_EQUAL(dual.dual.eulerCharacteristic, 2);
    CHECK_EQUAL(dual.dual.triangles.size(), std::size_t(12));
    const test::Shape shape = test::shapeOf(dual.dual.triangles);
    CHECK(shape.isManifold());
    CHECK_EQUAL(shape.borderEdges, 0);
  }
}

/** A clump of sites far away from the surface against its own size: few have cells, and soon. */
void testClump()
{
  using Clock = std::chrono::steady_clock;
  const SurfaceMesh mesh = test::meshOf(test::icosphere(3));
  for (const int d : { 3, 6, 8 })
  {
    const EmbeddedSurface surface = test::embedded(mesh, d);
    Sites sites;
    sites.dimension = d;
    for (Index k = 0; k < 5000 * d; ++k)
    {
      const double middle = k % d == 0 ? 1.5 : 0.0;
      sites.coordinates.push_back(middle + 1e-3 * (2.0 * uniform01(5, k, 0) - 1.0));
    }
    const Clock::time_point first = Clock::now();
    test::computed(surface, test::sampled(surface, sites.count(), 1));
    const Clock::time_point start = Clock::now();
    const test::Computed result = test::computed(surface, sites);
    CHECK(Clock::now() - start < 100 * (start - first));
    test::checkDiagram(mesh, surface, sites, result);
    CHECK(result.diagram.numberOfPieces() > surface.numberOfFacets());
  }
}
}

int TestDegenerateSites(int, char*[])
{
  testCoincidentSites();
  testTwins();
  testSitesOnTheMesh();
  testCircularGrids();
  testInexactGrids();
  testSitesOnAnAxis();
  testSymmetricSites();
  testClump();
  return test::result();
}
