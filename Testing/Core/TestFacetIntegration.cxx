// Voronoi/FacetIntegration: rounded integrals against those of exact pieces, the same bits whatever
// the instructions, and few facets refused.

#include "Embedding/Distance.h"
#include "TestEmbeddings.h"
#include "Voronoi/FacetDecomposition.h"
#include "Voronoi/FacetIntegration.h"
#include "Voronoi/Ownership.h"
#include "Voronoi/PieceIntegral.h"

#include <algorithm>
#include <cstring>
#include <iostream>
#include <map>

using namespace remesh;

namespace
{
/** What is known about the facets that several cells share. */
struct Tally
{
  int shared = 0;
  int refused = 0;
  int smallShared = 0; ///< by up to three cells, as most are where facets are small
  int smallRefused = 0;
  double worst = 0.0;
  int different = 0;
  int large = 0; ///< facets with a centre
  int notNearest = 0;
};

template <int D>
void compareFacets(
  const EmbeddedSurface& surface, const Sites& sites, std::vector<Index>& centers, Tally& tally)
{
  NeighborLists lists;
  CHECK(lists.build(sites, RunControl()).ok());
  Ownership ownership;
  CHECK(ownership.update(surface, sites, lists, RunControl()).ok());
  const std::vector<Index>& owners = ownership.owners();
  FacetDecomposition<D> decomposition(surface, sites, lists, owners);
  std::vector<Index> otherCenters = centers;
  FacetIntegration<D> baseline(surface, sites, lists, owners, centers, InstructionSet::Baseline);
  FacetIntegration<D> widest(surface, sites, lists, owners, otherCenters, widestInstructionSet());
  for (Index facet = 0; facet < surface.numberOfFacets(); ++facet)
  {
    const FacetConstants& constants = surface.constants[facet];
    decomposition.gather(facet);
    decomposition.tile();
    std::map<Index, PieceIntegral> difference;
    double reach2 = 0.0;
    for (const FacetPiece& piece : decomposition)
    {
      const FacetSite& site = decomposition.tiling().site(piece.slot);
      difference[site.id] =
        integratePiece(decomposition.tiling(), constants, piece.polygon, piece.slot);
      reach2 = std::max({ reach2, site.h[0], site.h[1], site.h[2] });
    }
    if (difference.size() < 2)
    {
      continue;
    }
    ++tally.shared;
    const bool success = baseline.integrate(facet);
    tally.different += widest.integrate(facet) != success;
    tally.refused += !success;
    tally.smallShared += difference.size() <= 3;
    tally.smallRefused += !success && difference.size() <= 3;
    if (!success)
    {
      continue;
    }
    std::vector<std::pair<Index, PieceIntegral>> parts;
    baseline.forEachPart(
      constants, [&](Index site, const PieceIntegral& part) { parts.emplace_back(site, part); });
    std::size_t next = 0;
    widest.forEachPart(constants,
      [&](Index site, const PieceIntegral& part)
      {
        tally.different += next >= parts.size() || parts[next].first != site ||
          std::memcmp(&parts[next].second, &part, sizeof part) != 0;
        ++next;
      });
    tally.different += next != parts.size();
    tally.different += otherCenters[facet] != centers[facet];
    for (const auto& [site, part] : parts)
    {
      PieceIntegral& rest = difference[site];
      rest.energy -= part.energy;
      for (int k = 0; k < 3; ++k)
      {
        rest.weights[k] -= part.weights[k];
      }
    }
    for (const auto& [site, rest] : difference)
    {
      tally.worst = std::max({ tally.worst, std::abs(rest.fraction()), std::abs(rest.weights[0]),
        std::abs(rest.weights[1]), std::abs(rest.weights[2]),
        std::abs(rest.energy) / (constants.mass * reach2 + 1e-300) });
    }
  }
}

/** A large facet's centre is the site nearest to it. */
void checkCenters(const EmbeddedSurface& surface, const Sites& sites,
  const std::vector<Index>& centers, Tally& tally)
{
  const int d = surface.dimension;
  std::vector<double> middle(static_cast<std::size_t>(d));
  for (Index facet = 0; facet < surface.numberOfFacets(); ++facet)
  {
    if (centers[facet] == noIndex)
    {
      continue;
    }
    ++tally.large;
    const Triple& corners = surface.facetCorners[facet];
    for (int m = 0; m < d; ++m)
    {
      middle[m] = (surface.corner(corners[0])[m] + surface.corner(corners[1])[m] +
                    surface.corner(corners[2])[m]) /
        3.0;
    }
    const auto squared = [&](Index site)
    { return squaredDistance<Eigen::Dynamic>(sites.site(site), middle.data(), d); };
    const double found = squared(centers[facet]);
    for (Index site = 0; site < sites.count(); ++site)
    {
      tally.notNearest += squared(site) < found - 1e-12;
    }
  }
}

/** As seen from a corner's owner, from known centres, and from any sites taken for them. */
void compare(const EmbeddedSurface& surface, const Sites& sites, Tally& tally)
{
  std::vector<Index> centers(static_cast<std::size_t>(surface.numberOfFacets()), noIndex);
  const auto look = [&]()
  {
    dispatchDimension(surface.dimension,
      [&](auto dimension)
      { compareFacets<decltype(dimension)::value>(surface, sites, centers, tally); });
  };
  look();
  look();
  checkCenters(surface, sites, centers, tally);
  for (Index& center : centers)
  {
    center = static_cast<Index>(
      uniform01(7, &center - centers.data(), 0) * static_cast<double>(sites.count()));
  }
  look();
}

/** Facets much smaller than the cells, and much larger: any number of sites. */
void testRandomSites()
{
  Tally tally;
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    for (const int d : { 3, 5, 6, 8 })
    {
      const EmbeddedSurface surface = test::embedded(mesh, d);
      for (const Offset count : { 2, 12, 60, 300 })
      {
        compare(surface, test::sampled(surface, count, 3), tally);
        compare(surface, test::shaken(test::sampled(surface, count, 4), 0.05, 5), tally);
      }
    }
  }
  std::cout << tally.refused << " of " << tally.shared << " facets refused, " << tally.smallRefused
            << " of " << tally.smallShared << " with up to three cells, " << tally.large
            << " large; difference " << tally.worst << "\n";
  CHECK(tally.shared > 5000);
  CHECK_EQUAL(tally.different, 0);
  CHECK_NEAR(tally.worst, 0.0, 1e-12);
  CHECK(tally.refused * 100 < tally.shared); // by more sites than an envelope holds
  CHECK(tally.smallRefused * 1000 < tally.smallShared);
  CHECK(tally.large > 4000);
  CHECK_EQUAL(tally.notNearest, 0);
}

/** Beside many sites close together, as on a curve with short sections, lists end early. */
void testCrowdedSites()
{
  Tally tally;
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::gridPatch(5, 5)), 3);
  for (const int crowd : { 40, 200 })
  {
    std::vector<Point3> places;
    for (int k = 0; k < crowd; ++k)
    {
      places.emplace_back(0.5 + 0.0001 * uniform01(1, k, 0), (k + 0.5) * 0.2 / crowd, 0.0);
    }
    for (int k = 0; k < 100; ++k)
    {
      places.emplace_back(uniform01(1, k, 1), uniform01(1, k, 2), 0.0);
    }
    compare(surface, test::sitesAt(surface, places), tally);
  }
  std::cout << "crowded: " << tally.refused << " of " << tally.shared
            << " facets refused, difference " << tally.worst << "\n";
  CHECK(tally.shared > 200);
  CHECK_EQUAL(tally.different, 0);
  CHECK_NEAR(tally.worst, 0.0, 1e-12);
  CHECK(tally.refused * 30 < tally.shared);
}

/** Ties: refused or right. */
void testDegenerateSites()
{
  Tally tally;
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    const EmbeddedSurface surface = test::embedded(mesh, 3);
    Sites corners;
    corners.dimension = 3;
    corners.coordinates = surface.corners;
    Sites twins = test::sampled(surface, 40, 6);
    twins.coordinates.insert(
      twins.coordinates.end(), twins.coordinates.begin(), twins.coordinates.begin() + 60);
    Sites near = twins;
    for (std::size_t k = 120; k < near.coordinates.size(); ++k)
    {
      near.coordinates[k] += 1e-3; // far enough for borders to be clear
    }
    for (const Sites& sites : { corners, twins, near })
    {
      compare(surface, sites, tally);
    }
  }
  std::vector<Point3> grid;
  for (int s = 0; s < 36; ++s)
  {
    grid.emplace_back((s % 6 + 0.5) / 6, (s / 6 + 0.5) / 6, 0.1);
  }
  for (const int squares : { 1, 3, 4, 6, 7 })
  {
    const SurfaceMesh mesh = test::meshOf(test::gridPatch(squares, squares));
    const EmbeddedSurface surface = test::embedded(mesh, 3);
    compare(surface, test::sitesAt(surface, grid), tally);
  }
  std::cout << "ties: " << tally.refused << " of " << tally.shared << " facets refused, difference "
            << tally.worst << "\n";
  CHECK_EQUAL(tally.different, 0);
  CHECK_NEAR(tally.worst, 0.0, 1e-11);
  CHECK(tally.refused > 0);
}
}

int TestFacetIntegration(int, char*[])
{
  testRandomSites();
  testCrowdedSites();
  testDegenerateSites();
  return test::result();
}
