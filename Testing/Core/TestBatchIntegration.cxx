// Voronoi/BatchIntegration: sums of facets in batches against those of exact pieces, the same bits
// whatever the instructions and the batch, and who has no plain share refused.

#include "TestEmbeddings.h"
#include "TestInstructionSets.h"
#include "Voronoi/BatchIntegration.h"
#include "Voronoi/FacetDecomposition.h"
#include "Voronoi/Ownership.h"
#include "Voronoi/PieceIntegral.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <set>

using namespace remesh;

namespace
{
struct Tally
{
  int ofTwo = 0;   ///< facets that only the owners of their corners share, and there are two
  int ofThree = 0; ///< the same of three
  int doneOfTwo = 0;
  int doneOfThree = 0;
  int ofThird = 0; ///< facets of two owners and one other site
  int doneOfThird = 0;
  int others = 0; ///< facets with more parts
  int different = 0;
  double worst = 0.0;
};

/** Mass, energy and moment of a part. */
using Sums = std::vector<double>;
using Parts = std::vector<std::pair<Index, Sums>>;

template <int D>
class Facets
{
public:
  Facets(const EmbeddedSurface& surface, const Sites& sites)
    : m_surface(surface)
    , m_sites(sites)
  {
    CHECK(m_lists.build(sites, RunControl()).ok());
    CHECK(m_ownership.update(surface, sites, m_lists, RunControl()).ok());
  }

  void compare(Tally& tally) const
  {
    const std::vector<Index>& owners = m_ownership.owners();
    FacetDecomposition<D> decomposition(m_surface, m_sites, m_lists, owners);
    for (Index facet = 0; facet < m_surface.numberOfFacets(); ++facet)
    {
      const Triple& corners = m_surface.facetCorners[facet];
      const std::set<Index> different{ owners[corners[0]], owners[corners[1]], owners[corners[2]] };
      const auto count = static_cast<int>(different.size());
      if (count == 1)
      {
        continue;
      }
      m_facets[count].push_back(facet);
      decomposition.gather(facet);
      decomposition.tile();
      this->compareFacet(facet, count, decomposition, tally);
    }
    this->compareBatches(tally);
  }

private:
  /** The parts of these facets; false if any is refused. */
  bool integrate(
    const std::vector<Index>& facets, int count, InstructionSet set, Parts& parts) const
  {
    BisectorPacks packs(m_sites, m_lists, set);
    BatchIntegration<D> batches(m_surface, m_sites, m_lists, m_ownership.owners(), packs, set);
    std::vector<Index> refused;
    parts.clear();
    batches.integrate(
      facets, count,
      [&](Index site, const double(*sums)[lanes], int lane)
      {
        parts.emplace_back(site, Sums());
        for (int k = 0; k < 2 + m_surface.dimension; ++k)
        {
          parts.back().second.push_back(sums[k][lane]);
        }
      },
      refused);
    return refused.empty();
  }

  void compareFacet(
    Index facet, int count, const FacetDecomposition<D>& decomposition, Tally& tally) const
  {
    const FacetTiling& tiling = decomposition.tiling();
    const FacetConstants& constants = m_surface.constants[facet];
    std::map<Index, Sums> left; // of the exact parts
    double reach2 = 0.0;
    int parts = 0;
    for (const FacetPiece& piece : decomposition)
    {
      const FacetSite& site = tiling.site(piece.slot);
      const PieceIntegral exact = integratePiece(tiling, constants, piece.polygon, piece.slot);
      left[site.id] = this->sumsOf(facet, site.id, exact);
      reach2 = std::max({ reach2, site.h[0], site.h[1], site.h[2] });
      parts += exact.fraction() > 1e-8;
    }
    Parts found;
    const bool done = this->integrate({ facet }, count, InstructionSet::Baseline, found);
    const bool third = count == 2 && parts == 3;
    (third              ? tally.ofThird
        : parts > count ? tally.others
        : count == 2    ? tally.ofTwo
                        : tally.ofThree) += 1;
    (third ? tally.doneOfThird : count == 2 ? tally.doneOfTwo : tally.doneOfThree) += done;
    tally.different += done && parts > static_cast<int>(found.size());
    for (const InstructionSet set : test::availableSets())
    {
      Parts others;
      tally.different += this->integrate({ facet }, count, set, others) != done;
      tally.different += others != found;
    }
    if (!done)
    {
      return;
    }
    m_alone[count].insert(m_alone[count].end(), found.begin(), found.end());
    for (const auto& [site, sums] : found)
    {
      Sums& rest = left[site];
      rest.resize(sums.size());
      std::transform(rest.begin(), rest.end(), sums.begin(), rest.begin(), std::minus<>());
    }
    for (const auto& [site, rest] : left)
    {
      for (const double number : rest)
      {
        tally.worst = std::max(tally.worst, std::abs(number) / (constants.mass * (1.0 + reach2)));
      }
    }
  }

  Sums sumsOf(Index facet, Index site, const PieceIntegral& piece) const
  {
    const double mass = m_surface.constants[facet].mass;
    Sums sums = { mass * piece.fraction(), piece.energy };
    for (int m = 0; m < m_surface.dimension; ++m)
    {
      double moment = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const double* corner = m_surface.corner(m_surface.facetCorners[facet][k]);
        moment += mass * piece.weights[k] * (corner[m] - m_sites.site(site)[m]);
      }
      sums.push_back(moment);
    }
    return sums;
  }

  /** Who else is in a batch changes nothing but the order. */
  void compareBatches(Tally& tally) const
  {
    for (const int count : { 2, 3 })
    {
      Parts together;
      static_cast<void>(
        this->integrate(m_facets[count], count, InstructionSet::Baseline, together));
      std::sort(together.begin(), together.end());
      std::sort(m_alone[count].begin(), m_alone[count].end());
      tally.different += together != m_alone[count];
    }
  }

  const EmbeddedSurface& m_surface;
  const Sites& m_sites;
  NeighborLists m_lists;
  Ownership m_ownership;
  mutable std::vector<Index> m_facets[4]; ///< by the number of owners
  mutable Parts m_alone[4];               ///< the same, of facets that were done one by one
};

void compare(const EmbeddedSurface& surface, const Sites& sites, Tally& tally)
{
  dispatchDimension(surface.dimension,
    [&](auto dimension) { Facets<decltype(dimension)::value>(surface, sites).compare(tally); });
}

void print(const char* name, const Tally& tally)
{
  std::cout << name << ": " << tally.doneOfTwo << " of " << tally.ofTwo << " between two, "
            << tally.doneOfThree << " of " << tally.ofThree << " among three, " << tally.doneOfThird
            << " of " << tally.ofThird << " with a third, " << tally.others
            << " others; difference " << tally.worst << "\n";
}

void testRandomSites()
{
  Tally tally;
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    for (const int d : { 3, 5, 6, 16 })
    {
      const EmbeddedSurface surface = test::embedded(mesh, d);
      for (const Offset count : { 2, 12, 60, 300 })
      {
        compare(surface, test::sampled(surface, count, 3), tally);
        compare(surface, test::shaken(test::sampled(surface, count, 4), 0.05, 5), tally);
      }
    }
  }
  print("random", tally);
  CHECK_EQUAL(tally.different, 0);
  CHECK_NEAR(tally.worst, 0.0, 1e-12);
  CHECK(tally.ofTwo > 2000 && tally.ofThree > 1000 && tally.others > 1000);
  CHECK(tally.doneOfTwo * 10 > tally.ofTwo * 9);
  CHECK(tally.doneOfThree * 10 > tally.ofThree * 8);
  CHECK(tally.ofThird > 500);
  CHECK(tally.doneOfThird * 10 > tally.ofThird * 7);
}

/** Sites on corners, twins, borders through corners: refused or right. */
void testTies()
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
    compare(surface, corners, tally);
    compare(surface, twins, tally);
  }
  std::vector<Point3> grid;
  for (int s = 0; s < 36; ++s)
  {
    grid.emplace_back((s % 6 + 0.5) / 6, (s / 6 + 0.5) / 6, 0.1);
  }
  for (const int squares : { 3, 6, 7, 12, 18 })
  {
    const SurfaceMesh mesh = test::meshOf(test::gridPatch(squares, squares));
    const EmbeddedSurface surface = test::embedded(mesh, 3);
    compare(surface, test::sitesAt(surface, grid), tally);
  }
  print("ties", tally);
  CHECK_EQUAL(tally.different, 0);
  CHECK_NEAR(tally.worst, 0.0, 1e-11);
}
}

int TestBatchIntegration(int, char*[])
{
  testRandomSites();
  testTies();
  return test::result();
}
