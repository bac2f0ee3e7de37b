/**
 * @file EdgeTable.cxx
 *
 * Half-edge 3 f + k is edge k of facet f.
 * 1. Put the half-edges into one bucket per lower end point.
 * 2. Sort each bucket by upper end point, then by half-edge: the half-edges of an edge become
 *    consecutive, a run, and the first of them leads the others.
 * 3. Number the edges in the order of their leaders, and scan the lengths of their runs.
 * 4. Tell the half-edges of each run their edge, and the edge its facets.
 */
#include "Mesh/EdgeTable.h"

#include "Support/Grouping.h"

namespace remesh
{
namespace
{
using Ends = std::pair<Index, Index>;

Ends endsOf(const std::vector<Triple>& facetPoints, Offset halfEdge)
{
  const Triple& facet = facetPoints[halfEdge / 3];
  return std::minmax(facet[halfEdge % 3], facet[(halfEdge + 1) % 3]);
}

/** A half-edge as it stands in its bucket: the leader of a run is below zero. */
constexpr Index marked(Index leader)
{
  return -1 - leader; // and back again
}

/** Sorts a bucket, marks the leaders, and writes the length of each leader's run. */
void sortBucket(const std::vector<Triple>& facetPoints, Index* begin, Index* end,
  std::vector<std::uint64_t>& entries, std::vector<Index>& lengths)
{
  entries.clear();
  for (const Index* item = begin; item != end; ++item)
  {
    const auto upper = static_cast<std::uint64_t>(endsOf(facetPoints, *item).second);
    entries.push_back(upper << 32 | static_cast<std::uint64_t>(*item));
  }
  std::sort(entries.begin(), entries.end());
  Index leader = noIndex;
  for (std::size_t k = 0; k < entries.size(); ++k)
  {
    const auto halfEdge = static_cast<Index>(entries[k] & 0xFFFFFFFF);
    const bool leads = k == 0 || entries[k] >> 32 != entries[k - 1] >> 32;
    leader = leads ? halfEdge : leader;
    ++lengths[leader];
    begin[k] = leads ? marked(halfEdge) : halfEdge;
  }
}

/** Steps 1 and 2. */
bool findRuns(const std::vector<Triple>& facetPoints, const RunControl& control,
  std::vector<Index>& halfEdges, std::vector<Index>& lengths)
{
  Index highest = noIndex;
  for (const Triple& facet : facetPoints)
  {
    highest = std::max({ highest, facet[0], facet[1], facet[2] });
  }
  const auto count = 3 * static_cast<Offset>(facetPoints.size());
  const auto lower = [&](Offset halfEdge) { return endsOf(facetPoints, halfEdge).first; };
  Groups buckets;
  if (!groupByKey(count, highest + 1, control, lower, buckets))
  {
    return false;
  }
  lengths.resize(static_cast<std::size_t>(count), 0);
  halfEdges = std::move(buckets.items);
  return forEachRange(longBlocks(highest + 1), control,
    [&](Offset begin, Offset end)
    {
      std::vector<std::uint64_t> entries;
      for (Offset point = begin; point < end; ++point)
      {
        sortBucket(facetPoints, halfEdges.data() + buckets.begins[point],
          halfEdges.data() + buckets.begins[point + 1], entries, lengths);
      }
    });
}

/** Step 3: gives each leader its edge, and each edge the beginning of its facets. */
bool numberEdges(const std::vector<Index>& lengths, const RunControl& control, EdgeTable& table)
{
  table.facetEdges.resize(lengths.size() / 3);
  return packItems(
    static_cast<Offset>(lengths.size()), control, [&](Offset h) { return lengths[h] > 0; },
    [&](Offset edges) { table.edgeFacetsBegin.assign(static_cast<std::size_t>(edges) + 1, 0); },
    [&](Offset h, Offset edge)
    {
      table.facetEdges[h / 3][h % 3] = static_cast<Index>(edge);
      table.edgeFacetsBegin[edge] = lengths[h];
    });
}

/** Step 4, for the runs that start in [begin, end). */
void fillRuns(const std::vector<Index>& halfEdges, Offset begin, Offset end, EdgeTable& table)
{
  const auto size = static_cast<Offset>(halfEdges.size());
  while (begin < end && halfEdges[begin] >= 0)
  {
    ++begin; // of a run that started before
  }
  Index edge = noIndex;
  Index place = 0;
  for (Offset k = begin; k < size && (k < end || halfEdges[k] >= 0); ++k)
  {
    const bool leads = halfEdges[k] < 0;
    const Index halfEdge = leads ? marked(halfEdges[k]) : halfEdges[k];
    if (leads)
    {
      edge = table.facetEdges[halfEdge / 3][halfEdge % 3];
      place = table.edgeFacetsBegin[edge];
    }
    table.facetEdges[halfEdge / 3][halfEdge % 3] = edge;
    table.edgeFacets[place++] = halfEdge / 3;
  }
}

bool build(const std::vector<Triple>& facetPoints, const RunControl& control, EdgeTable& table)
{
  std::vector<Index> halfEdges;
  {
    std::vector<Index> lengths;
    if (!findRuns(facetPoints, control, halfEdges, lengths) ||
      !numberEdges(lengths, control, table))
    {
      return false;
    }
  }
  table.edgeFacets.resize(static_cast<std::size_t>(scanCounts(table.edgeFacetsBegin)));
  return forEachRange(longBlocks(static_cast<Offset>(halfEdges.size())), control,
    [&](Offset begin, Offset end) { fillRuns(halfEdges, begin, end, table); });
}
}

EdgeTable buildEdgeTable(const std::vector<Triple>& facetPoints, const RunControl& control)
{
  EdgeTable table;
  return build(facetPoints, control.silent(), table) ? table : EdgeTable{};
}
}
