/**
 * @file EdgeTable.cxx
 *
 * Half-edge 3 f + k is edge k of facet f.
 * 1. Put the half-edges into one bucket per lower end point (count, scan, fill).
 * 2. Sort each bucket by upper end point, then by half-edge: the half-edges of an edge become
 *    consecutive, and the first of them leads the others.
 * 3. Run over the half-edges: a leader opens a new edge, the others take over their leader's.
 * 4. Collect the facets of each edge (count, scan, fill).
 */
#include "Mesh/EdgeTable.h"

#include <algorithm>

namespace remesh
{
namespace
{
struct HalfEdge
{
  Index lower;
  Index upper;
};

HalfEdge halfEdgeOf(const std::vector<Triple>& facetPoints, std::size_t halfEdge)
{
  const Triple& facet = facetPoints[halfEdge / 3];
  const auto [low, high] = std::minmax(facet[halfEdge % 3], facet[(halfEdge + 1) % 3]);
  return { low, high };
}

/** Turns counts, stored one place later, into the beginnings of the buckets. */
void scan(std::vector<Offset>& begins)
{
  for (std::size_t i = 1; i < begins.size(); ++i)
  {
    begins[i] += begins[i - 1];
  }
}

/** Buckets of half-edges by lower point; an entry holds the upper point above the half-edge. */
struct HalfEdgeBuckets
{
  std::vector<Offset> begins;
  std::vector<std::uint64_t> entries;

  explicit HalfEdgeBuckets(const std::vector<Triple>& facetPoints);
  static Index upper(std::uint64_t entry) { return static_cast<Index>(entry >> 32); }
  static std::size_t halfEdge(std::uint64_t entry) { return entry & 0xFFFFFFFF; }
};

HalfEdgeBuckets::HalfEdgeBuckets(const std::vector<Triple>& facetPoints)
  : entries(3 * facetPoints.size())
{
  Index highest = noIndex;
  for (const Triple& facet : facetPoints)
  {
    highest = std::max({ highest, facet[0], facet[1], facet[2] });
  }
  this->begins.assign(static_cast<std::size_t>(highest) + 2, 0);
  for (std::size_t h = 0; h < this->entries.size(); ++h)
  {
    ++this->begins[halfEdgeOf(facetPoints, h).lower + 1];
  }
  scan(this->begins);
  std::vector<Offset> next(this->begins);
  for (std::size_t h = 0; h < this->entries.size(); ++h)
  {
    const HalfEdge ends = halfEdgeOf(facetPoints, h);
    this->entries[next[ends.lower]++] = static_cast<std::uint64_t>(ends.upper) << 32 | h;
  }
  for (std::size_t point = 0; point + 1 < this->begins.size(); ++point)
  {
    std::sort(
      this->entries.begin() + this->begins[point], this->entries.begin() + this->begins[point + 1]);
  }
}

/** Writes the leader of each half-edge into `facetEdges`. */
void findLeaders(const HalfEdgeBuckets& buckets, std::vector<Triple>& facetEdges)
{
  for (std::size_t point = 0; point + 1 < buckets.begins.size(); ++point)
  {
    std::uint64_t leader = 0;
    for (Offset i = buckets.begins[point]; i < buckets.begins[point + 1]; ++i)
    {
      const std::uint64_t entry = buckets.entries[i];
      if (i == buckets.begins[point] ||
        HalfEdgeBuckets::upper(entry) != HalfEdgeBuckets::upper(leader))
      {
        leader = entry;
      }
      const std::size_t h = HalfEdgeBuckets::halfEdge(entry);
      facetEdges[h / 3][h % 3] = static_cast<Index>(HalfEdgeBuckets::halfEdge(leader));
    }
  }
}
}

EdgeTable buildEdgeTable(const std::vector<Triple>& facetPoints)
{
  EdgeTable table;
  table.facetEdges.resize(facetPoints.size());
  table.edgeFacetsBegin.push_back(0);
  findLeaders(HalfEdgeBuckets(facetPoints), table.facetEdges);

  const std::size_t numberOfHalfEdges = 3 * facetPoints.size();
  for (std::size_t h = 0; h < numberOfHalfEdges; ++h)
  {
    Index& edge = table.facetEdges[h / 3][h % 3];
    const auto leader = static_cast<std::size_t>(edge);
    if (leader == h)
    {
      edge = table.numberOfEdges();
      table.edgeFacetsBegin.push_back(0);
    }
    else
    {
      edge = table.facetEdges[leader / 3][leader % 3];
    }
    ++table.edgeFacetsBegin[edge + 1];
  }
  scan(table.edgeFacetsBegin);

  table.edgeFacets.resize(numberOfHalfEdges);
  std::vector<Offset> next(table.edgeFacetsBegin);
  for (std::size_t h = 0; h < numberOfHalfEdges; ++h)
  {
    table.edgeFacets[next[table.facetEdges[h / 3][h % 3]]++] = static_cast<Index>(h / 3);
  }
  return table;
}
}
