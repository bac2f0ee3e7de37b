// Optimization/LocalRelaxation: steps that are Lloyd's around it.

#include "Optimization/FixedSites.h"
#include "Optimization/Lloyd.h"
#include "Optimization/LocalRelaxation.h"
#include "TestDiagrams.h"
#include "TestSiteEdits.h"

#include <algorithm>
#include <numeric>

using namespace remesh;

namespace
{
/**
 * One step around sites that are gone and added: those around take Lloyd's step on the whole
 * surface, all others stay to the bit; fixed ones, too.
 */
void testOneStep()
{
  for (const int d : { 3, 6, 17, 65 })
  {
    const EmbeddedSurface surface = test::embedded(test::meshOf(test::torus(1.0, 0.4, 48, 24)), d);
    Sites earlier = test::sampled(surface, 600, 2);
    RestrictedVoronoi voronoi(surface);
    CellSums sums;
    Convergence rows;
    Index empty = 0;
    CHECK(relaxLloyd({ voronoi, surface, 1, earlier, sums, rows, empty }, 20, RunControl()).ok());
    earlier.fixed = 300;
    Diagram diagram;
    CHECK(RestrictedVoronoi(surface).decompose(earlier, RunControl(), sums, diagram).ok());

    Sites later = earlier;
    test::erase(later, 400);
    test::append(later, 500, 1e-3);
    const Sites start = later;
    const SiteChanges changes = compareSites(earlier, later);
    CHECK(relaxAround({ surface, earlier, diagram }, changes, { 1, 1 }, RunControl(), later).ok());
    Sites all = start;
    CHECK(relaxLloyd({ voronoi, surface, 1, all, sums, rows, empty }, 1, RunControl()).ok());
    Index moved = 0;
    for (Index i = 0; i < later.count(); ++i)
    {
      const bool stays = std::equal(later.site(i), later.site(i) + d, start.site(i));
      moved += !stays;
      for (int k = 0; k < d && !stays; ++k)
      {
        CHECK_NEAR(later.site(i)[k], all.site(i)[k], 1e-12);
      }
      CHECK(stays || i >= later.fixed);
    }
    CHECK(moved > 10);
    CHECK(moved <= 51);
    CHECK(!std::equal(later.site(599), later.site(599) + d, start.site(599)));
  }
}

/** A free site without a cell, for another is at its place, takes part: it moves, and gets one. */
void testEmptyCell()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::icosphere(3)), 6);
  Sites earlier = test::sampled(surface, 300, 4);
  test::append(earlier, 150, 0.0);
  CellSums sums;
  Diagram diagram;
  CHECK(RestrictedVoronoi(surface).decompose(earlier, RunControl(), sums, diagram).ok());
  CHECK_EQUAL(countEmptyFree(earlier, sums), 1);
  Sites later = earlier;
  SiteChanges changes = compareSites(earlier, later);
  changes.places.assign(earlier.site(150), earlier.site(150) + 6);
  CHECK(relaxAround({ surface, earlier, diagram }, changes, { 2, 1 }, RunControl(), later).ok());
  CHECK_EQUAL(countEmptyFree(later, test::computed(surface, later).sums), 0);
  CHECK(sums.isEmpty(300));
  CHECK(!std::equal(later.site(300), later.site(300) + 6, earlier.site(300)));
}

/** Corners that the caller lends are the same as held ones. */
void testLentCorners()
{
  constexpr int d = manyDimensions;
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 32, 16));
  CornerCoordinates held;
  held.dimension = d;
  for (const Index point : mesh.cornerPoints)
  {
    for (int k = 0; k < d; ++k)
    {
      held.values.push_back(mesh.points[point][k % 3] * (1.0 + 0.01 * k));
    }
  }
  const std::vector<double> rows = held.values;
  CornerCoordinates lent;
  lent.dimension = d;
  lent.lent = { { rows.data(), nullptr, d, 1.0 } };
  lent.rows.resize(mesh.cornerPoints.size());
  std::iota(lent.rows.begin(), lent.rows.end(), Offset(0));

  EmbeddedSurface holding;
  CHECK(embedSurface(mesh, held, RunControl(), holding).ok());
  const Sites earlier = test::sampled(holding, 200, 3);
  Sites moved[2];
  for (const bool lends : { false, true })
  {
    EmbeddedSurface surface;
    CHECK(embedSurface(mesh, lends ? lent : held, RunControl(), surface).ok());
    CHECK_EQUAL(surface.source.isLent(), lends);
    CellSums sums;
    Diagram diagram;
    CHECK(RestrictedVoronoi(surface).decompose(earlier, RunControl(), sums, diagram).ok());
    Sites& later = moved[lends];
    later = earlier;
    test::erase(later, 70);
    const Sites start = later;
    const SiteChanges changes = compareSites(earlier, later);
    CHECK(relaxAround({ surface, earlier, diagram }, changes, { 2, 1 }, RunControl(), later).ok());
    CHECK(later.coordinates != start.coordinates);
  }
  CHECK(moved[0].coordinates == moved[1].coordinates);
}

/** Where all sites around are fixed there is nothing to do. */
void testNothingToMove()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::icosphere(2)), 3);
  Sites earlier = test::sampled(surface, 100, 3);
  earlier.fixed = 100;
  CellSums sums;
  Diagram diagram;
  CHECK(RestrictedVoronoi(surface).decompose(earlier, RunControl(), sums, diagram).ok());
  Sites later = earlier;
  test::erase(later, 20);
  later.fixed = 99;
  const Sites start = later;
  const SiteChanges changes = compareSites(earlier, later);
  CHECK(relaxAround({ surface, earlier, diagram }, changes, { 2, 1 }, RunControl(), later).ok());
  CHECK(later.coordinates == start.coordinates);
}
}

int TestLocalRelaxation(int, char*[])
{
  testOneStep();
  testEmptyCell();
  testLentCorners();
  testNothingToMove();
  return test::result();
}
