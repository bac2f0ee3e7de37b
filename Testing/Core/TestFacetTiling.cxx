// Voronoi/FacetTiling: one facet, any H values, ties among them, clipped in any order.

#include "Support/Random.h"
#include "TestChecks.h"
#include "Voronoi/FacetTiling.h"
#include "Voronoi/PieceIntegral.h"
#include "Voronoi/VertexPlaces.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

using namespace remesh;

namespace
{
/** What tells a vertex: the sites (or facet edges) on both sides of it, and its place. */
struct Corner
{
  Index incoming;
  Index outgoing;
  std::array<double, 3> b;

  bool operator==(const Corner& other) const
  {
    return this->incoming == other.incoming && this->outgoing == other.outgoing &&
      this->b == other.b;
  }
  bool operator<(const Corner& other) const
  {
    return std::tie(this->incoming, this->outgoing, this->b) <
      std::tie(other.incoming, other.outgoing, other.b);
  }
};

/** Corners of each site's piece, in terms of site ids, sorted. */
using Tiling = std::map<Index, std::vector<Corner>>;

Triple corners()
{
  return { 5, 9, 2 };
}

FacetConstants constants()
{
  FacetConstants facet;
  facet.mass = 1.0;
  return facet;
}

std::vector<FacetSite> randomSites(int count, double largest, std::uint64_t seed)
{
  std::vector<FacetSite> sites(static_cast<std::size_t>(count));
  for (int s = 0; s < count; ++s)
  {
    sites[s].id = s;
    for (int k = 0; k < 3; ++k)
    {
      sites[s].h[k] = std::floor(largest * uniform01(seed, s, k)) + 100.0;
    }
  }
  return sites;
}

/** All pieces, each clipped by all others in the order in which they are given. */
Tiling tile(const std::vector<FacetSite>& sites, double& fractions)
{
  FacetTiling tiling;
  tiling.begin(corners(), constants());
  for (const FacetSite& site : sites)
  {
    tiling.addSite(site);
  }
  Tiling result;
  fractions = 0.0;
  for (int i = 0; i < tiling.numberOfSites(); ++i)
  {
    Polygon polygon;
    tiling.wholeFacet(polygon);
    for (int q = 0; q < tiling.numberOfSites() && !polygon.empty(); ++q)
    {
      if (q != i)
      {
        tiling.clip(polygon, i, q);
      }
    }
    const auto idOf = [&](int edge) { return edge < 0 ? edge : tiling.site(edge).id; };
    std::vector<Corner> piece;
    for (std::size_t v = 0; v < polygon.size(); ++v)
    {
      const PieceVertex& before = polygon[(v + polygon.size() - 1) % polygon.size()];
      const double* b = polygon[v].b;
      piece.push_back({ idOf(before.edge), idOf(polygon[v].edge), { b[0], b[1], b[2] } });
    }
    std::sort(piece.begin(), piece.end());
    if (!piece.empty())
    {
      result[tiling.site(i).id] = piece;
      fractions += integratePiece(tiling, constants(), polygon, i).fraction();
    }
  }
  return result;
}

/** Each vertex of a piece is one of the pieces across its two edges, too, bit by bit. */
int unmatchedCorners(const Tiling& tiling)
{
  int unmatched = 0;
  for (const auto& [site, piece] : tiling)
  {
    for (const Corner& corner : piece)
    {
      for (const Index other : { corner.incoming, corner.outgoing })
      {
        if (other >= 0)
        {
          const auto found = tiling.find(other);
          unmatched += found == tiling.end() ||
            std::none_of(found->second.begin(), found->second.end(),
              [&, id = site](const Corner& c)
              { return c.b == corner.b && (c.incoming == id || c.outgoing == id); });
        }
      }
    }
  }
  return unmatched;
}

/** Pieces - edges + vertices of the whole tiling is 1: it has the combinatorics of a disk. */
int eulerCharacteristic(const Tiling& tiling)
{
  int onFacetCorners = 0, onEdges = 0, inside = 0, edges = 0, borderEdges = 0;
  for (const auto& [site, piece] : tiling)
  {
    for (const Corner& corner : piece)
    {
      const int sides = (corner.incoming < 0) + (corner.outgoing < 0);
      onFacetCorners += sides == 2;
      onEdges += sides == 1;
      inside += sides == 0;
      (corner.outgoing < 0 ? borderEdges : edges) += 1;
    }
  }
  CHECK_EQUAL(onFacetCorners, 3);
  CHECK_EQUAL(onEdges % 2, 0);
  CHECK_EQUAL(inside % 3, 0);
  return static_cast<int>(tiling.size()) - edges / 2 - borderEdges + 3 + onEdges / 2 + inside / 3;
}

/** Random H values, from none in common to all on a grid of 2 x 2 x 2. */
void testAnyOrder(double largest)
{
  for (std::uint64_t seed = 0; seed < 300; ++seed)
  {
    std::vector<FacetSite> sites = randomSites(12, largest, seed);
    double fractions = 0.0;
    const Tiling tiling = tile(sites, fractions);
    CHECK_NEAR(fractions, 1.0, 1e-12);
    CHECK_EQUAL(unmatchedCorners(tiling), 0);
    CHECK_EQUAL(eulerCharacteristic(tiling), 1);
    for (int turn = 0; turn < 3; ++turn)
    {
      std::rotate(sites.begin(), sites.begin() + 5, sites.end());
      std::reverse(sites.begin(), sites.begin() + 7);
      CHECK(tile(sites, fractions) == tiling);
    }
  }
}

/** The envelope by definition at points of a grid; H values are integers, ties go either way. */
void testEnvelope()
{
  for (std::uint64_t seed = 0; seed < 50; ++seed)
  {
    const std::vector<FacetSite> sites = randomSites(10, 1000.0, seed);
    double fractions = 0.0;
    const Tiling tiling = tile(sites, fractions);
    for (const auto& [id, piece] : tiling)
    {
      for (const Corner& corner : piece)
      {
        const auto valueOf = [&](const FacetSite& site)
        { return corner.b[0] * site.h[0] + corner.b[1] * site.h[1] + corner.b[2] * site.h[2]; };
        for (const FacetSite& other : sites)
        {
          CHECK(valueOf(sites[id]) <= valueOf(other) + 1e-9);
        }
      }
    }
  }
}

/** A facet that goes the other way round cuts its common edge at the same place, bit by bit. */
void testEdgeFromBothSides()
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    const std::vector<FacetSite> sites = randomSites(2, 1e6, seed);
    std::vector<std::array<double, 2>> places;
    for (const bool turned : { false, true })
    {
      FacetTiling tiling;
      tiling.begin(turned ? Triple{ 9, 5, 4 } : Triple{ 5, 9, 2 }, constants());
      for (FacetSite site : sites)
      {
        if (turned)
        {
          std::swap(site.h[0], site.h[1]);
        }
        tiling.addSite(site);
      }
      Polygon polygon;
      tiling.wholeFacet(polygon);
      tiling.clip(polygon, 0, 1);
      for (const PieceVertex& vertex : polygon)
      {
        if (vertex.b[2] == 0.0 && vertex.b[0] < 1.0 && vertex.b[1] < 1.0)
        {
          places.push_back({ vertex.b[turned], vertex.b[!turned] });
        }
      }
    }
    CHECK(places.size() != 1 && (places.empty() || places.front() == places.back()));
  }
}

/** Two sites that differ in the last bits of H: where they meet a third one is no matter of luck.
 */
void testPlaceOfNearTwins()
{
  const double unit = 0x1p-56;
  const FacetSite other{ 1, { 0.716, 0.16, 0.124 } };
  const FacetSite twin{ 39, { 0.8, 0.25, 0.0625 } };
  for (const double sign : { 1.0, -1.0 })
  {
    // Differences by whole last places, so that nothing is rounded.
    const double u[3] = { 0.0, 4.0 * sign, -2.0 * sign };
    const FacetSite near{ 58, { twin.h[0], twin.h[1] + u[1] * unit, twin.h[2] + u[2] * unit } };
    double v[3], expected[3];
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      v[k] = other.h[k] - twin.h[k];
    }
    for (int k = 0; k < 3; ++k)
    {
      expected[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
      sum += expected[k];
    }
    double b[3];
    placeInside(twin, near, other, b);
    for (int k = 0; k < 3; ++k)
    {
      CHECK(expected[k] / sum >= 0.0);
      CHECK_NEAR(b[k], expected[k] / sum, 1e-14);
    }
  }
}

/** Distances from H values against distances of points. */
void testSquaredDistance()
{
  const double p[3][2] = { { 0, 0 }, { 3, 0 }, { 1, 2 } };
  const double x[2] = { -1.0, 4.0 };
  const auto distance2 = [](const double* a, const double* b)
  { return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]); };
  FacetConstants facet;
  FacetSite site{ 0, {} };
  for (int k = 0; k < 3; ++k)
  {
    facet.edge2[k] = distance2(p[k], p[(k + 1) % 3]);
    site.h[k] = distance2(p[k], x);
  }
  FacetTiling tiling;
  tiling.begin(corners(), facet);
  const int slot = tiling.addSite(site);
  const double b[3] = { 0.25, 0.125, 0.625 };
  const double point[2] = { b[0] * p[0][0] + b[1] * p[1][0] + b[2] * p[2][0],
    b[0] * p[0][1] + b[1] * p[1][1] + b[2] * p[2][1] };
  CHECK_NEAR(tiling.squaredDistance(slot, b), distance2(point, x), 1e-14);
  Polygon polygon;
  tiling.wholeFacet(polygon);
  CHECK_NEAR(tiling.squaredRadius(polygon, slot), 32.0, 1e-14); // corner (3, 0)
}
}

int TestFacetTiling(int, char*[])
{
  for (const double largest : { 2.0, 3.0, 5.0, 20.0, 1e6, 1e14 })
  {
    testAnyOrder(largest);
  }
  testEnvelope();
  testEdgeFromBothSides();
  testPlaceOfNearTwins();
  testSquaredDistance();
  return test::result();
}
