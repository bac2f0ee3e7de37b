// Voronoi/NeighborLists: each walk yields all other sites by increasing distance.

#include "TestEmbeddings.h"
#include "Voronoi/NeighborLists.h"

#include <algorithm>

using namespace remesh;

namespace
{
/** One walk against the distances by definition. */
void checkWalk(const Sites& sites, const NeighborLists& lists, LongerLists& longer, Index site)
{
  const double rounding = 1e-14;
  std::vector<char> seen(static_cast<std::size_t>(sites.count()), 0);
  Index distinct = 0;
  int wrong = 0;
  double last = 0.0;
  NeighborWalk walk(lists, longer, site);
  while (const Neighbor* neighbor = walk.next())
  {
    const double distance = std::sqrt(test::exactDistance2(
      sites.site(site), sites.site(neighbor->site), sites.dimension));
    wrong += neighbor->site == site || neighbor->distance < last ||
      std::abs(neighbor->distance - distance) > rounding;
    last = neighbor->distance;
    distinct += !seen[neighbor->site];
    seen[neighbor->site] = 1;
  }
  CHECK_EQUAL(wrong, 0);
  CHECK_EQUAL(distinct, sites.count() - 1);
}

/** What comes first is nearest: no site left out is nearer than one that has come. */
void checkPrefix(const Sites& sites, const NeighborLists& lists, LongerLists& longer, Index site)
{
  std::vector<double> distances;
  for (Index other = 0; other < sites.count(); ++other)
  {
    if (other != site)
    {
      distances.push_back(std::sqrt(
        test::exactDistance2(sites.site(site), sites.site(other), sites.dimension)));
    }
  }
  std::sort(distances.begin(), distances.end());
  // Repeats at equal distances aside, the k-th distinct neighbour is at the k-th distance.
  std::vector<char> seen(static_cast<std::size_t>(sites.count()), 0);
  std::size_t distinct = 0;
  double largestError = 0.0;
  NeighborWalk walk(lists, longer, site);
  while (const Neighbor* neighbor = walk.next())
  {
    if (!seen[neighbor->site])
    {
      seen[neighbor->site] = 1;
      largestError = std::max(largestError, std::abs(neighbor->distance - distances[distinct]));
      ++distinct;
    }
  }
  CHECK_NEAR(largestError, 0.0, 1e-14);
}

void checkSites(const Sites& sites, Index stride)
{
  NeighborLists lists;
  CHECK(lists.build(sites, RunControl()).ok());
  LongerLists longer;
  for (Index site = 0; site < sites.count(); site += stride)
  {
    checkWalk(sites, lists, longer, site);
    checkPrefix(sites, lists, longer, site);
  }
  longer.clear();
  checkWalk(sites, lists, longer, sites.count() - 1);
  CHECK_EQUAL(lists.search().numberOfSites(), sites.count());
}

void testRandomSites()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(2));
  for (const int d : { 3, 6, 8, 17 })
  {
    const EmbeddedSurface surface = test::embedded(mesh, d);
    for (const Offset n : { 1, 2, 20, 21, 22, 400 })
    {
      checkSites(test::sampled(surface, n, 1), n > 100 ? 13 : 1);
    }
  }
}

/** All at one place; half of them; on a grid with many equal distances. */
void testTies()
{
  Sites sites;
  sites.dimension = 3;
  for (int s = 0; s < 343; ++s)
  {
    sites.coordinates.insert(sites.coordinates.end(),
      { 0.125 * (s % 7), 0.125 * (s / 7 % 7), 0.125 * (s / 49) });
  }
  checkSites(sites, 7);
  for (Index s = 150; s < sites.count(); ++s)
  {
    std::copy_n(sites.site(10), 3, sites.site(s));
  }
  checkSites(sites, 7);
  for (Index s = 0; s < sites.count(); ++s)
  {
    std::copy_n(sites.site(10), 3, sites.site(s));
  }
  checkSites(sites, 50);
}
}

int TestNeighborLists(int, char*[])
{
  testRandomSites();
  testTies();
  return test::result();
}
