// Voronoi/RestrictedVoronoi against the definition: all cells by clipping with all bisectors.

#include "Embedding/Distance.h"
#include "TestDiagrams.h"
#include "Voronoi/FacetDecomposition.h"
#include "Voronoi/Ownership.h"

#include <iostream>

using namespace remesh;

namespace
{
using Cell = std::vector<test::Barycentric>;

/** Sutherland-Hodgman: the part of a polygon where an affine function is not negative. */
Cell clipped(const Cell& polygon, const std::array<double, 3>& values)
{
  const auto valueAt = [&](const test::Barycentric& b)
  { return b[0] * values[0] + b[1] * values[1] + b[2] * values[2]; };
  Cell result;
  for (std::size_t v = 0; v < polygon.size(); ++v)
  {
    const test::Barycentric& start = polygon[v];
    const test::Barycentric& end = polygon[(v + 1) % polygon.size()];
    const double atStart = valueAt(start);
    const double atEnd = valueAt(end);
    if (atStart >= 0.0)
    {
      result.push_back(start);
    }
    if ((atStart >= 0.0) != (atEnd >= 0.0))
    {
      const double t = atStart / (atStart - atEnd);
      result.push_back({ start[0] + t * (end[0] - start[0]), start[1] + t * (end[1] - start[1]),
        start[2] + t * (end[2] - start[2]) });
    }
  }
  return result;
}

/** What the site has of the facet: clipped with all other sites. */
Cell cellOn(const EmbeddedSurface& surface, const Sites& sites, Index facet, Index site)
{
  Cell cell = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  for (Index other = 0; other < sites.count() && !cell.empty(); ++other)
  {
    std::array<double, 3> values{};
    for (int k = 0; k < 3; ++k)
    {
      const double* corner = surface.corner(surface.facetCorners[facet][k]);
      values[k] = test::exactDistance2(sites.site(other), corner, sites.dimension) -
        test::exactDistance2(sites.site(site), corner, sites.dimension);
    }
    const bool coincide = values[0] == 0.0 && values[1] == 0.0 && values[2] == 0.0;
    if (coincide ? other < site : other != site)
    {
      cell = coincide ? Cell() : clipped(cell, values);
    }
  }
  return cell;
}

/** Adds the integrals over the triangle of R^d, from its points. */
void addTriangle(const EmbeddedSurface& surface, const Sites& sites, Index facet, Index site,
  const test::Barycentric corners[3], CellSums& sums)
{
  const int d = surface.dimension;
  std::vector<double> p[3];
  for (int k = 0; k < 3; ++k)
  {
    p[k] = test::pointAt(surface, facet, corners[k]);
  }
  const double mass = triangleArea(p[0].data(), p[1].data(), p[2].data(), d);
  const double* x = sites.site(site);
  double squares = 0.0;
  for (int k = 0; k < d; ++k)
  {
    const double center = (p[0][k] + p[1][k] + p[2][k]) / 3.0 - x[k];
    sums.moment[static_cast<std::size_t>(site) * d + k] += mass * center;
    squares += 9.0 * center * center;
  }
  for (const std::vector<double>& point : p)
  {
    squares += test::exactDistance2(point.data(), x, d);
  }
  sums.mass[site] += mass;
  sums.energy[site] += mass * squares / 12.0;
}

CellSums bruteForce(const EmbeddedSurface& surface, const Sites& sites)
{
  CellSums sums;
  const auto n = static_cast<std::size_t>(sites.count());
  sums.mass.resize(n);
  sums.energy.resize(n);
  sums.moment.resize(sites.coordinates.size());
  for (Index facet = 0; facet < surface.numberOfFacets(); ++facet)
  {
    for (Index site = 0; site < sites.count(); ++site)
    {
      const Cell cell = cellOn(surface, sites, facet, site);
      for (std::size_t v = 1; v + 1 < cell.size(); ++v)
      {
        const test::Barycentric corners[3] = { cell[0], cell[v], cell[v + 1] };
        addTriangle(surface, sites, facet, site, corners, sums);
      }
    }
  }
  return sums;
}

void checkSums(const EmbeddedSurface& surface, const Sites& sites, const CellSums& sums)
{
  const CellSums expected = bruteForce(surface, sites);
  const double scale = surface.mass;
  CHECK_NEAR(test::largestDifference(sums.mass, expected.mass), 0.0, 1e-12 * scale);
  CHECK_NEAR(test::largestDifference(sums.energy, expected.energy), 0.0, 1e-12 * scale);
  CHECK_NEAR(test::largestDifference(sums.moment, expected.moment), 0.0, 1e-12 * scale);
  double squared = 0.0;
  for (const double moment : expected.moment)
  {
    squared += 4.0 * moment * moment;
  }
  CHECK_NEAR(sums.gradientNorm, std::sqrt(squared), 1e-12 * scale);
}

/** Everything about the diagram of these sites; names the case if something failed. */
void checkCase(const std::string& name, const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const Sites& sites)
{
  const int before = test::failures();
  const test::Computed result = test::computed(surface, sites);
  test::checkDiagram(mesh, surface, sites, result);
  checkSums(surface, sites, result.sums);
  if (test::failures() > before)
  {
    std::cerr << "  in: " << name << ", d = " << surface.dimension << ", n = " << sites.count()
              << "\n";
  }
}

/** On and off the surface, from one site to many more than facets. */
void testRandomSites()
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    for (const int d : { 3, 6, 8, 17 })
    {
      const EmbeddedSurface surface = test::embedded(mesh, d);
      for (const Offset n : { 1, 2, 5, 40 })
      {
        const Sites sites = test::sampled(surface, n, static_cast<std::uint64_t>(10 * n + d));
        checkCase(name + ", on the surface", mesh, surface, sites);
        checkCase(name + ", near the surface", mesh, surface, test::shaken(sites, 0.1, 3));
      }
    }
    const EmbeddedSurface surface = test::embedded(mesh, 6);
    checkCase(
      name + ", far off", mesh, surface, test::shaken(test::sampled(surface, 30, 1), 2.0, 4));
  }
}

/** Twelve facets and many sites: each piece lies inside a facet. */
void testManySitesPerFacet()
{
  const SurfaceMesh mesh = test::meshOf(test::cube());
  for (const int d : { 3, 6 })
  {
    const EmbeddedSurface surface = test::embedded(mesh, d);
    checkCase("cube, crowded", mesh, surface, test::sampled(surface, 250, 5));
  }
}

/** A clump of sites and a few afar: neighbour lists must grow. */
void testUnevenSites()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(2));
  for (const int d : { 3, 17 })
  {
    const EmbeddedSurface surface = test::embedded(mesh, d);
    Sites sites = test::sampled(surface, 64, 6);
    for (Index site = 4; site < sites.count(); ++site)
    {
      for (int k = 0; k < d; ++k)
      {
        sites.site(site)[k] = sites.site(3)[k] + 1e-3 * (sites.site(site)[k] - sites.site(3)[k]);
      }
    }
    checkCase("a clump", mesh, surface, sites);
  }
}

/**
 * Evaluations one after the other do not depend on what came before, nor on its size; but for
 * rounding, if that were as many sites.
 */
void testEvaluationsInSequence()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(2));
  const EmbeddedSurface surface = test::embedded(mesh, 6);
  RestrictedVoronoi voronoi(surface);
  int evaluations = 0;
  Offset last = 0;
  for (const Offset n : { 50, 3, 1, 80, 80 })
  {
    const Sites sites = test::sampled(surface, n, static_cast<std::uint64_t>(n));
    RestrictedVoronoi fresh(surface);
    CellSums sums, alone;
    CHECK(voronoi.integrate(sites, RunControl(), sums).ok());
    CHECK(fresh.integrate(sites, RunControl(), alone).ok());
    const double rounding = n == last ? 1e-13 : 0.0;
    CHECK_NEAR(test::largestDifference(sums.mass, alone.mass), 0.0, rounding);
    CHECK_NEAR(test::largestDifference(sums.moment, alone.moment), 0.0, rounding);
    last = n;
    CHECK(voronoi.owners() == fresh.owners());
    ++evaluations;
    CHECK_EQUAL(voronoi.evaluations(), evaluations);
  }
}

/** The sites of each facet's pieces, cut with lists that have been kept as long as they may be. */
template <int D>
std::vector<Index> sitesOfPieces(const EmbeddedSurface& surface, const Sites& sites,
  const NeighborLists& lists, const std::vector<Index>& owners)
{
  std::vector<Index> all;
  FacetDecomposition<D> decomposition(surface, sites, lists, owners);
  for (Index facet = 0; facet < surface.numberOfFacets(); ++facet)
  {
    decomposition.gather(facet);
    decomposition.tile();
    for (const FacetPiece& piece : decomposition)
    {
      all.push_back(decomposition.tiling().site(piece.slot).id);
    }
  }
  return all;
}

/** Small moves, where neighbour lists may be kept: the cells are those of the sites alone. */
void testCreepingSites()
{
  for (const int level : { 1, 2 })
  {
    const SurfaceMesh mesh = test::meshOf(test::icosphere(level));
    for (const int d : { 3, 6, 17 })
    {
      const EmbeddedSurface surface = test::embedded(mesh, d);
      Sites sites = test::sampled(surface, 120, 4);
      RestrictedVoronoi voronoi(surface);
      NeighborLists lists;
      Ownership ownership;
      for (int step = 0; step < 25; ++step)
      {
        const test::Computed alone = test::computed(surface, sites);
        test::checkTiling(surface, alone.diagram);
        test::Computed result;
        if (step % 8 == 5) // for which nothing is kept
        {
          CHECK(voronoi.decompose(sites, RunControl(), result.sums, result.diagram).ok());
          CHECK(result.diagram.sites == alone.diagram.sites);
        }
        else
        {
          CHECK(voronoi.integrate(sites, RunControl(), result.sums).ok());
        }
        CHECK(voronoi.owners() == alone.owners);
        CHECK_NEAR(test::largestDifference(result.sums.mass, alone.sums.mass), 0.0, 1e-13);
        CHECK_NEAR(test::largestDifference(result.sums.moment, alone.sums.moment), 0.0, 1e-13);
        CHECK(lists.update(sites, RunControl()).ok());
        CHECK(ownership.update(surface, sites, lists, RunControl()).ok());
        CHECK(ownership.owners() == alone.owners);
        dispatchDimension(d,
          [&](auto dimension)
          {
            CHECK(sitesOfPieces<decltype(dimension)::value>(
                    surface, sites, lists, ownership.owners()) == alone.diagram.sites);
          });
        // Sites take turns to creep towards each other, and jump at last.
        const double size = step == 20 ? 0.2 : step % 2 == 0 ? 0.02 : 3e-3;
        sites = test::shaken(sites, size, static_cast<std::uint64_t>(step));
      }
    }
  }
}

/** However many blocks are added up at once, the bytes are the same. */
void testWindows()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(4));
  for (const int d : { 3, 6, 70 })
  {
    const EmbeddedSurface surface = test::embedded(mesh, d);
    const Sites sites = test::sampled(surface, 300, 2);
    test::Computed expected;
    for (const Offset window : { 1000000, 1, 7, 100 })
    {
      RestrictedVoronoi voronoi(surface);
      voronoi.addUpAtOnce(window);
      test::Computed result;
      CHECK(voronoi.integrate(sites, RunControl(), result.sums).ok());
      expected.sums = expected.sums.mass.empty() ? result.sums : expected.sums;
      CHECK(result.sums.mass == expected.sums.mass);
      CHECK(result.sums.energy == expected.sums.energy);
      CHECK(result.sums.moment == expected.sums.moment);
      CHECK_EQUAL(result.sums.totalEnergy, expected.sums.totalEnergy);
      CellSums sums;
      CHECK(voronoi.decompose(sites, RunControl(), sums, result.diagram).ok());
      CHECK_NEAR(test::largestDifference(sums.mass, expected.sums.mass), 0.0, 1e-13);
      expected.diagram = expected.diagram.sites.empty() ? result.diagram : expected.diagram;
      CHECK(result.diagram.sites == expected.diagram.sites);
      CHECK(result.diagram.facetBegin == expected.diagram.facetBegin);
      CHECK(result.diagram.across == expected.diagram.across);
    }
  }
}
}

int TestRestrictedVoronoi(int, char*[])
{
  testRandomSites();
  testManySitesPerFacet();
  testUnevenSites();
  testEvaluationsInSequence();
  testCreepingSites();
  testWindows();
  return test::result();
}
