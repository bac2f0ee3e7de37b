// Optimization/SiteGrowth: lattices where a coarse tessellation is one, drawn sites elsewhere, and
// as many in each place as are due to its measure.

#include "Optimization/Lloyd.h"
#include "Optimization/SiteGrowth.h"
#include "TestDiagrams.h"
#include "TestEmbeddings.h"
#include "Voronoi/NeighborSearch.h"

#include <set>

using namespace remesh;

namespace
{
constexpr Index coarseCount = 500;
constexpr Index count = 2000;

/** A torus that is wrinkled, far below the size of the cells, where x > 0. */
SurfaceMesh halfWrinkled()
{
  TriangleSoup soup = test::torus(1.0, 0.4, 160, 96);
  for (std::size_t k = 0; k < soup.points.size(); ++k)
  {
    if (soup.points[k][0] > 0.0)
    {
      soup.points[k] *= 1.0 + 0.06 * (uniform01(3, k, 1) - 0.5);
    }
  }
  return test::meshOf(soup);
}

std::vector<double> coordinatesOf(const Sites& sites, Index site)
{
  return { sites.site(site), sites.site(site) + sites.dimension };
}

std::set<std::vector<double>> asSet(const Sites& sites)
{
  std::set<std::vector<double>> result;
  for (Index i = 0; i < sites.count(); ++i)
  {
    result.insert(coordinatesOf(sites, i));
  }
  return result;
}

void testHalves()
{
  const EmbeddedSurface surface = test::embedded(halfWrinkled(), 3);
  Sites coarse = test::sampled(surface, coarseCount, 1, SamplingMethod::Stratified);
  RestrictedVoronoi voronoi(surface);
  CellSums sums;
  Convergence rows;
  Index empty = 0;
  CHECK(relaxLloyd({ voronoi, surface, 1, coarse, sums, rows, empty }, 60, RunControl()).ok());
  Diagram diagram;
  CHECK(voronoi.decompose(coarse, RunControl(), sums, diagram).ok());

  const Sites drawn = test::sampled(surface, count, 2, SamplingMethod::Stratified);
  Sites grown = drawn;
  CHECK(growSites(surface, { coarse, sums, diagram }, RunControl(), grown).ok());
  CHECK_EQUAL(grown.count(), count);

  const std::set<std::vector<double>> fromCoarse = asSet(coarse), fromDrawn = asSet(drawn);
  Index sites[2] = {}, coarseSites[2] = {}, drawnSites[2] = {}, cells[2] = {};
  for (Index i = 0; i < grown.count(); ++i)
  {
    const int wrinkled = grown.site(i)[0] > 0.0 ? 1 : 0;
    const std::vector<double> site = coordinatesOf(grown, i);
    ++sites[wrinkled];
    coarseSites[wrinkled] += fromCoarse.count(site) > 0 ? 1 : 0;
    drawnSites[wrinkled] += fromDrawn.count(site) > 0 ? 1 : 0;
  }
  double measures[2] = {};
  for (Index f = 0; f < surface.numberOfFacets(); ++f)
  {
    const Triple& corners = surface.facetCorners[f];
    const double middle = surface.corners[3 * corners[0]] + surface.corners[3 * corners[1]] +
      surface.corners[3 * corners[2]];
    measures[middle > 0.0 ? 1 : 0] += surface.siteMeasureOf(f);
  }
  for (Index i = 0; i < coarse.count(); ++i)
  {
    ++cells[coarse.site(i)[0] > 0.0 ? 1 : 0];
  }
  CHECK(coarseSites[0] > cells[0] * 3 / 4);
  CHECK(coarseSites[1] < cells[1] / 20);
  CHECK(drawnSites[0] < sites[0] / 4);
  CHECK(drawnSites[1] > sites[1] * 9 / 10);
  CHECK_NEAR(sites[0] / (measures[0] / surface.siteMeasure * count), 1.0, 0.02);

  // Cell by cell.
  const NeighborSearch search(coarse);
  std::vector<double> left(static_cast<std::size_t>(coarse.count()), 0.0);
  for (Index i = 0; i < coarse.count(); ++i)
  {
    left[i] = sums.mass[i] / surface.mass * count;
  }
  for (Index i = 0; i < grown.count(); ++i)
  {
    left[search.nearest(grown.site(i))] -= 1.0;
  }
  for (const double sitesLeft : left)
  {
    CHECK_NEAR(sitesLeft, 0.0, 4.0);
  }
}

void testCancel()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::torus(1.0, 0.4, 48, 24)), 3);
  const Sites coarse = test::sampled(surface, 100, 1);
  const test::Computed at = test::computed(surface, coarse);
  Sites grown = test::sampled(surface, 400, 1);
  const RunControl control(nullptr, []() { return true; });
  CHECK(growSites(surface, { coarse, at.sums, at.diagram }, control, grown).code ==
    StatusCode::Cancelled);
}
}

int TestSiteGrowth(int, char*[])
{
  testHalves();
  testCancel();
  return test::result();
}
