// Voronoi/NeighborLists, NeighborWalk: each walk yields all other sites by increasing distance.

#include "Support/Parallel.h"
#include "TestEmbeddings.h"
#include "Voronoi/NeighborWalk.h"

#include <algorithm>
#include <limits>

using namespace remesh;

namespace
{
double distanceBetween(const Sites& sites, Index a, Index b)
{
  return std::sqrt(test::exactDistance2(sites.site(a), sites.site(b), sites.dimension));
}

/**
 * One walk: all other sites come, the bound only grows, and no site from here on is nearer. With
 * sites at rest the bound is the distance, less the rounding of single precision.
 */
void checkWalk(
  const Sites& sites, const NeighborLists& lists, LongerLists& longer, Index site, bool atRest)
{
  const double rounding = 1e-14;
  std::vector<char> seen(static_cast<std::size_t>(sites.count()), 0);
  Index distinct = 0;
  int wrong = 0;
  double last = -std::numeric_limits<double>::infinity();
  NeighborWalk walk(lists, longer, site);
  while (walk.next([](double) { return false; }))
  {
    const double distance = distanceBetween(sites, site, walk.site());
    const double bound = walk.minDistance();
    wrong += walk.site() == site || bound < last || bound > distance + rounding;
    wrong +=
      atRest && bound < distance * (1.0 - 2.0 * std::numeric_limits<float>::epsilon()) - rounding;
    last = bound;
    distinct += !seen[walk.site()];
    seen[walk.site()] = 1;
  }
  CHECK_EQUAL(wrong, 0);
  CHECK_EQUAL(distinct, sites.count() - 1);
}

void checkAllWalks(const Sites& sites, const NeighborLists& lists, Index stride, bool atRest)
{
  LongerLists longer;
  for (Index site = 0; site < sites.count(); site += stride)
  {
    checkWalk(sites, lists, longer, site, atRest);
  }
  checkWalk(sites, lists, longer, 0, atRest); // again, with the longer lists there already
  longer.clear();
  checkWalk(sites, lists, longer, sites.count() - 1, atRest);
  CHECK_EQUAL(lists.search().numberOfSites(), sites.count());
}

void checkSites(const Sites& sites, Index stride)
{
  NeighborLists lists;
  CHECK(lists.build(sites, RunControl()).ok());
  checkAllWalks(sites, lists, stride, true);
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
    sites.coordinates.insert(
      sites.coordinates.end(), { 0.125 * (s % 7), 0.125 * (s / 7 % 7), 0.125 * (s / 49) });
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

/** Few sites far from many, as in a small patch: their lists stop at the limit, the walks do not.
 */
void testLimit()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::icosphere(2)), 3);
  Sites sites = test::sampled(surface, 300, 4);
  for (Index site = 0; site < 5; ++site)
  {
    sites.site(site)[2] += 16.0;
  }
  NeighborLists lists(8.0);
  for (int step = 0; step < 3; ++step) // the second time, the last reach tells how far to look
  {
    CHECK(lists.build(sites, RunControl()).ok());
    CHECK_EQUAL(lists.list(0).count, 4);
    CHECK_EQUAL(lists.reach(0), 8.0);
    CHECK(lists.list(100).count > 4);
  }
  checkAllWalks(sites, lists, 7, true);
  const double inPatch = 4.0;
  LongerLists longer;
  NeighborWalk walk(lists, longer, 0);
  int steps = 0;
  while (walk.next([=](double least) { return least > inPatch; }))
  {
    ++steps;
  }
  CHECK_EQUAL(steps, 4);
  CHECK_EQUAL(walk.minDistance(), 8.0);
}

/** Sites so far away that squares overflow: walks come to an end without them, and at once there.
 */
void testUnreachable()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::icosphere(2)), 3);
  for (const Offset n : { 10, 30, 300 })
  {
    Sites sites = test::sampled(surface, n, 4);
    sites.site(2)[1] = 1e200;
    NeighborLists lists;
    CHECK(lists.build(sites, RunControl()).ok());
    LongerLists longer;
    for (const Index site : { 0, 2, 9 })
    {
      std::vector<char> seen(static_cast<std::size_t>(n), 0);
      int steps = 0;
      NeighborWalk walk(lists, longer, site);
      while (steps < 1000 && walk.next([](double) { return false; }))
      {
        ++steps;
        seen[walk.site()] = 1;
      }
      CHECK(steps < 1000);
      CHECK_EQUAL(std::count(seen.begin(), seen.end(), 1), site == 2 ? 0 : n - 2);
      CHECK_EQUAL(walk.minDistance(), std::numeric_limits<double>::infinity());
    }
  }
}

/**
 * A site that leaps over its neighbours wears the lists around it out, and no others: none is built
 * anew. From farther away, walks would go far: all are.
 */
void testLeapers()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::icosphere(4)), 6);
  Sites sites = test::sampled(surface, 4000, 5);
  NeighborLists lists;
  CHECK(lists.update(sites, RunControl()).ok());
  std::vector<double> reaches;
  for (Index site = 0; site < sites.count(); ++site)
  {
    reaches.push_back(lists.reach(site));
  }
  constexpr Index leaper = 300;
  const Index target = lists.list(leaper).sites[15];
  std::copy_n(sites.site(target), 6, sites.site(leaper));
  sites.site(leaper)[0] += 1e-3;
  CHECK(lists.update(sites, RunControl()).ok());
  CHECK(lists.approachOfListed(leaper) > 0.0); // not built anew
  Index worn = 0;
  for (Index site = 0; site < sites.count(); ++site)
  {
    worn += lists.reach(site) < 0.6 * reaches[site];
  }
  CHECK(worn > 0);
  CHECK(worn < 100);
  checkAllWalks(sites, lists, 37, false);
  LongerLists longer;
  checkWalk(sites, lists, longer, leaper, false);
  checkWalk(sites, lists, longer, target, false);

  std::copy_n(sites.site(3900), 6, sites.site(leaper));
  CHECK(lists.update(sites, RunControl()).ok());
  CHECK_EQUAL(lists.approachOfListed(leaper), 0.0);
}

/** Sites that creep, then jump, then grow in number: the lists stay valid, kept or built anew. */
void testMovingSites()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(2));
  for (const int d : { 3, 6, 17 })
  {
    const EmbeddedSurface surface = test::embedded(mesh, d);
    Sites sites = test::sampled(surface, 150, 2);
    NeighborLists lists;
    for (int step = 0; step < 30; ++step)
    {
      CHECK(lists.update(sites, RunControl()).ok());
      checkAllWalks(sites, lists, 11, step == 0);
      sites = test::shaken(sites, step == 20 ? 1.0 : 2e-3, static_cast<std::uint64_t>(step));
    }
    for (const Offset n : { 151, 10, 1, 40 })
    {
      sites = test::sampled(surface, n, 3);
      CHECK(lists.update(sites, RunControl()).ok());
      checkAllWalks(sites, lists, 11, true);
    }
  }
}

/** How many of some sites, each asked for twice, have other lists than those of `expected`. */
Index countOthers(const NeighborLists& lists, const NeighborLists& expected, Index n, Index stride)
{
  const Offset count = n / stride;
  std::vector<char> differs(2 * static_cast<std::size_t>(count), 0);
  RunControl control;
  control.schedule = Schedule::EightThreads;
  const bool done = forEachItem(Blocks{ 2 * count, 1 }, control,
    [&](Offset k)
    {
      const Index site = n - 1 - static_cast<Index>(k / 2) * stride; // in another order
      const NeighborList list = lists.list(site);
      const NeighborList other = expected.list(site);
      differs[k] = list.count != other.count ||
        !std::equal(list.sites, list.sites + list.count, other.sites) ||
        !std::equal(list.distances, list.distances + list.count, other.distances) ||
        lists.reach(site) != expected.reach(site) ||
        lists.approachOfListed(site) != expected.approachOfListed(site);
    });
  CHECK(done);
  return static_cast<Index>(std::count(differs.begin(), differs.end(), 1));
}

/**
 * Lists are the same whenever they are made, with equal distances, too, and are kept or built anew
 * at the same time; nobody makes those that are not asked for.
 */
void testOnlyAsked(Sites sites)
{
  constexpr Index stride = 10;
  const Index n = sites.count();
  NeighborLists all;
  NeighborLists asked;
  asked.makeOnlyAsked();
  int anew = 0;
  for (int step = 0; step < 12; ++step)
  {
    CHECK(all.update(sites, RunControl()).ok());
    CHECK(asked.update(sites, RunControl()).ok());
    anew += all.approachOfListed(0) == 0.0;
    CHECK_EQUAL(countOthers(asked, all, n, step % 2 == 0 ? stride : 3 * stride), 0);
    CHECK_EQUAL(all.numberOfLists(), n);
    CHECK(asked.numberOfLists() < n / 2 + n / stride + 2); // a half are the sample
    sites = test::shaken(sites, step % 5 == 4 ? 0.1 : 2e-4, static_cast<std::uint64_t>(step));
    if (step % 5 == 2)
    {
      std::copy_n(sites.site(n / 2), sites.dimension, sites.site(n / 3)); // one leaps
    }
  }
  CHECK(anew >= 2 && anew < 12);
}

void testOnlyAsked()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::icosphere(4)), 6);
  testOnlyAsked(test::sampled(surface, 17000, 5));
  Sites grid;
  grid.dimension = 3;
  for (int s = 0; s < 27 * 27 * 27; ++s)
  {
    grid.coordinates.insert(
      grid.coordinates.end(), { 0.125 * (s % 27), 0.125 * (s / 27 % 27), 0.125 * (s / 729) });
  }
  testOnlyAsked(grid);
}
}

int TestNeighborLists(int, char*[])
{
  testRandomSites();
  testTies();
  testLimit();
  testUnreachable();
  testLeapers();
  testMovingSites();
  testOnlyAsked();
  return test::result();
}
