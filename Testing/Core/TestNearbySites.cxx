// Sites near others, several searched for at once: those that brute force finds, each site visited
// once, and the same bits for all sets of instructions.

#include "TestEmbeddings.h"
#include "TestLanes.h"
#include "TestSurfaces.h"
#include "Voronoi/NearbySites.h"

#include <numeric>

using namespace remesh;

namespace
{
/** The ids of the sites nearer than a radius, ascending. */
std::vector<Index> nearerThan(const Sites& sites, Index site, double radius)
{
  std::vector<Index> ids;
  for (Index other = 0; other < sites.count(); ++other)
  {
    if (std::sqrt(test::exactDistance2(sites.site(site), sites.site(other), sites.dimension)) <
      radius)
    {
      ids.push_back(other);
    }
  }
  return ids;
}

std::vector<Index> idsOf(const std::vector<Neighbor>& found)
{
  std::vector<Index> ids;
  for (const Neighbor& neighbor : found)
  {
    ids.push_back(neighbor.site);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

void checkSites(const Sites& sites, Index begin, Index end, double maxRadius)
{
  const NeighborSearch search(sites);
  NearbySites nearby(search, sites);
  std::vector<int> visits(static_cast<std::size_t>(sites.count()), 0);
  std::vector<Neighbor> found;
  const auto radiusOf = [&](Index site) { return maxRadius * uniform01(5, site, 0); };
  std::vector<Index> some(static_cast<std::size_t>(end - begin));
  std::iota(some.begin(), some.end(), begin);
  nearby.forEach(some.data(), some.data() + some.size(), radiusOf,
    [&](Index site, double radius)
    {
      ++visits[static_cast<std::size_t>(site)];
      CHECK_EQUAL(radius, radiusOf(site));
      nearby.within(site, radius, found);
      for (const Neighbor& neighbor : found)
      {
        const double squared =
          test::exactDistance2(sites.site(site), sites.site(neighbor.site), sites.dimension);
        CHECK(std::abs(neighbor.distance - std::sqrt(squared)) <= 1e-14);
      }
      CHECK(idsOf(found) == nearerThan(sites, site, radius));
    });
  for (Index site = 0; site < sites.count(); ++site)
  {
    CHECK_EQUAL(visits[static_cast<std::size_t>(site)], site >= begin && site < end ? 1 : 0);
  }
}

void testSites()
{
  SurfaceMesh mesh = test::meshOf(test::icosphere(3));
  for (const int d : { 3, 6, 11 })
  {
    const EmbeddedSurface surface = test::embedded(mesh, d);
    const Sites sites = test::sampled(surface, 700, 3);
    for (const double radius : { 0.0, 0.05, 0.3, 10.0 })
    {
      checkSites(sites, 0, 700, radius);
      checkSites(sites, 100, 101, radius);
    }
    checkSites(sites, 5, 5, 1.0);
    Sites coincident = sites;
    for (Index i = 1; i < 60; ++i)
    {
      std::copy_n(sites.site(0), d, coincident.site(i));
    }
    checkSites(coincident, 0, 700, 0.2);
  }
}

/** What was visited before may tell how far to look next. */
void testRadiusFromBefore()
{
  SurfaceMesh mesh = test::meshOf(test::icosphere(3));
  const Sites sites = test::sampled(test::embedded(mesh, 6), 500, 3);
  const NeighborSearch search(sites);
  NearbySites nearby(search, sites);
  std::vector<Neighbor> found;
  double former = 0.0;
  std::vector<Index> all(static_cast<std::size_t>(sites.count()));
  std::iota(all.begin(), all.end(), 0);
  nearby.forEach(
    all.data(), all.data() + all.size(), [&](Index) { return former; },
    [&](Index site, double radius)
    {
      nearby.within(site, radius, found);
      CHECK(idsOf(found) == nearerThan(sites, site, radius));
      former = former > 0.4 ? 0.1 : former + 0.01;
    });
}

/** A spacing that jumps: far in the sparse part is all of the dense one. */
void testJump()
{
  SurfaceMesh mesh = test::meshOf(test::icosphere(3));
  Sites sites = test::sampled(test::embedded(mesh, 3), 2000, 3);
  for (Index i = 200; i < sites.count(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      sites.site(i)[k] = 1.0 + 1e-3 * sites.site(i)[k];
    }
  }
  checkSites(sites, 150, 250, 1.0);
}

void testSets()
{
  for (const int d : { 1, 3, 6, 7 })
  {
    constexpr int groups = 3;
    std::vector<double> coordinates;
    for (int k = 0; k < groups * lanes * d; ++k)
    {
      coordinates.push_back(uniform01(1, k, d));
    }
    std::vector<double> point(static_cast<std::size_t>(d), 0.4);
    const auto squaredBy = [&](InstructionSet set)
    {
      std::vector<double> squared(groups * lanes);
      siteDistanceEvaluation(set)({ coordinates.data(), groups, d, point.data(), squared.data() });
      return squared;
    };
    const std::vector<double> baseline = squaredBy(InstructionSet::Baseline);
    for (int site = 0; site < groups * lanes; ++site)
    {
      double sum = 0.0;
      for (int k = 0; k < d; ++k)
      {
        const double x = coordinates[(site / lanes * d + k) * lanes + site % lanes];
        sum += (x - 0.4) * (x - 0.4);
      }
      CHECK_EQUAL(baseline[static_cast<std::size_t>(site)], sum);
    }
    for (const InstructionSet set : test::availableSets())
    {
      CHECK(squaredBy(set) == baseline);
    }
  }
}
}

int TestNearbySites(int, char*[])
{
  testSites();
  testRadiusFromBefore();
  testJump();
  testSets();
  return test::result();
}
