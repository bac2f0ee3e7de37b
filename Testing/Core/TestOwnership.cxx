// Voronoi/Ownership: the nearest site of each corner, the lowest of those that tie.

#include "Embedding/Distance.h"
#include "TestEmbeddings.h"
#include "Voronoi/Ownership.h"

#include <algorithm>
#include <chrono>

using namespace remesh;

namespace
{
/** By definition, with the distances that all decisions rest on. */
std::vector<Index> ownersByDefinition(const EmbeddedSurface& surface, const Sites& sites)
{
  const auto distance2 = [&](Index site, Index corner)
  {
    return dispatchDimension(surface.dimension,
      [&](auto dimension)
      {
        return squaredDistance<decltype(dimension)::value>(
          sites.site(site), surface.corner(corner), surface.dimension);
      });
  };
  std::vector<Index> owners;
  for (Index corner = 0; corner < surface.numberOfCorners(); ++corner)
  {
    Index nearest = 0;
    for (Index site = 1; site < sites.count(); ++site)
    {
      nearest = distance2(site, corner) < distance2(nearest, corner) ? site : nearest;
    }
    owners.push_back(nearest);
  }
  return owners;
}

void checkUpdate(
  const EmbeddedSurface& surface, const Sites& sites, NeighborLists& lists, Ownership& ownership)
{
  CHECK(lists.update(sites, RunControl()).ok());
  CHECK(ownership.update(surface, sites, lists, RunControl()).ok());
  CHECK(ownership.owners() == ownersByDefinition(surface, sites));
  CHECK_EQUAL(static_cast<int>(ownership.squared().size()),
    surface.dimension >= manyDimensions ? surface.numberOfCorners() : 0);
  for (std::size_t corner = 0; corner < ownership.squared().size(); ++corner)
  {
    CHECK_EQUAL(ownership.squared()[corner],
      squaredDistance<Eigen::Dynamic>(sites.site(ownership.owners()[corner]),
        surface.corner(static_cast<Index>(corner)), sites.dimension));
  }
}

/** Moves each site by up to `size` in each coordinate, and a few by a hundred times as much. */
void move(Sites& sites, double size, int step)
{
  const auto d = static_cast<std::size_t>(sites.dimension);
  for (std::size_t k = 0; k < sites.coordinates.size(); ++k)
  {
    const bool far = uniform01(7, k / d, step) < 0.02;
    sites.coordinates[k] += (far ? 100.0 : 1.0) * size * (2.0 * uniform01(8, k, step) - 1.0);
  }
}

/** From nothing; while all sites creep, rest, jump; all at once; and after others. */
void checkOwners(const EmbeddedSurface& surface, const Sites& first)
{
  NeighborLists lists;
  Ownership ownership;
  Sites sites = first;
  checkUpdate(surface, sites, lists, ownership);
  for (int step = 0; step < 6; ++step)
  {
    move(sites, step == 3 ? 0.0 : 1e-3, step);
    checkUpdate(surface, sites, lists, ownership);
  }
  move(sites, 0.3, 6);
  checkUpdate(surface, sites, lists, ownership);
  checkUpdate(surface, first, lists, ownership);
  Sites fewer = first;
  fewer.coordinates.resize(static_cast<std::size_t>((first.count() + 1) / 2 * first.dimension));
  checkUpdate(surface, fewer, lists, ownership);
}

/** Sites that move so little that most leads hold: still not one owner may be wrong. */
void testCreep()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::gridPatch(40, 40)), 6);
  Sites sites = test::sampled(surface, 60, 3);
  NeighborLists lists;
  Ownership ownership;
  for (int step = 0; step < 100; ++step)
  {
    checkUpdate(surface, sites, lists, ownership);
    move(sites, step % 10 == 0 ? 1e-2 : 1e-4, step);
  }
}

void testRandomSites()
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    for (const int d : { 3, 6, 8, 17, manyDimensions })
    {
      const EmbeddedSurface surface = test::embedded(mesh, d);
      for (const Offset n : { 1, 2, 30, 500 })
      {
        const Sites sites = test::sampled(surface, n, 1);
        checkOwners(surface, sites);
        checkOwners(surface, test::shaken(sites, 1.0, 2));
      }
    }
  }
}

/**
 * Sites in a clump far smaller than their distance to the surface: all are about as far from each
 * corner. That takes little longer than a few hundred, whatever they do; and they move.
 */
void testClump()
{
  using Clock = std::chrono::steady_clock;
  for (const int d : { 3, 6 })
  {
    const EmbeddedSurface surface = test::embedded(test::meshOf(test::icosphere(3)), d);
    Sites sites;
    sites.dimension = d;
    for (Index k = 0; k < 8000 * d; ++k)
    {
      const double middle = k % d == 0 ? 1.5 : 0.0;
      sites.coordinates.push_back(middle + 1e-3 * (2.0 * uniform01(5, k, 0) - 1.0));
    }
    NeighborLists lists;
    Ownership ownership;
    for (const int step : { 0, 1, 2 })
    {
      CHECK(lists.update(sites, RunControl()).ok());
      const Clock::time_point start = Clock::now();
      CHECK(ownership.update(surface, sites, lists, RunControl()).ok());
      CHECK(Clock::now() - start < std::chrono::seconds(3));
      CHECK(ownership.owners() == ownersByDefinition(surface, sites));
      move(sites, 1e-7, step);
    }
  }
}

/** Sites on a grid and corners on a finer one: many corners tie, between up to four sites. */
void testTies()
{
  const SurfaceMesh mesh = test::meshOf(test::gridPatch(16, 16));
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  std::vector<Point3> places;
  for (int s = 0; s < 64; ++s)
  {
    places.emplace_back((s % 8 + 0.5) / 8.0, (s / 8 + 0.5) / 8.0, 0.25);
  }
  checkOwners(surface, test::sitesAt(surface, places));
  std::reverse(places.begin(), places.end());
  places.insert(places.end(), places.begin(), places.end()); // each twice
  checkOwners(surface, test::sitesAt(surface, places));
  checkOwners(surface, test::sitesAt(surface, std::vector<Point3>(100, places.front())));
}
}

int TestOwnership(int, char*[])
{
  testRandomSites();
  testCreep();
  testClump();
  testTies();
  return test::result();
}
