// Voronoi/Ownership: the nearest site of each corner, the lowest of those that tie.

#include "Embedding/Distance.h"
#include "TestEmbeddings.h"
#include "Voronoi/Ownership.h"

#include <algorithm>

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

/** From nothing, from the right owners, from one site for all, and from any. */
void checkOwners(const EmbeddedSurface& surface, const Sites& sites)
{
  const std::vector<Index> expected = ownersByDefinition(surface, sites);
  NeighborLists lists;
  CHECK(lists.build(sites, RunControl()).ok());
  std::vector<Index> arbitrary;
  for (std::size_t corner = 0; corner < expected.size(); ++corner)
  {
    arbitrary.push_back(static_cast<Index>(uniform01(1, corner, 0) * sites.count()));
  }
  for (std::vector<Index> owners :
    { std::vector<Index>(), expected, std::vector<Index>(expected.size(), 0),
      std::vector<Index>(expected.size(), sites.count() - 1), arbitrary })
  {
    std::vector<double> squared;
    CHECK(findOwners(surface, sites, lists, RunControl(), owners, squared).ok());
    CHECK(owners == expected);
    CHECK_EQUAL(squared.size(), owners.size());
    for (Index corner = 0; corner < surface.numberOfCorners(); ++corner)
    {
      CHECK_EQUAL(squared[corner],
        squaredDistance<Eigen::Dynamic>(
          sites.site(owners[corner]), surface.corner(corner), sites.dimension));
    }
  }
}

void testRandomSites()
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    for (const int d : { 3, 6, 8, 17 })
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
  testTies();
  return test::result();
}
