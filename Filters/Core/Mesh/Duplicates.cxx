/**
 * @file Duplicates.cxx
 *
 * 1. Put the facets into one bucket per lowest point.
 * 2. Sort each bucket by the other two points, then by facet: repetitions follow their original.
 * 3. Flaps: parts of folded facets, and what else is at their edges.
 */
#include "Mesh/Duplicates.h"

#include "Mesh/EdgeTable.h"
#include "Support/DisjointSets.h"
#include "Support/Grouping.h"

namespace remesh
{
namespace
{
/** A facet without its lowest point. */
struct BucketEntry
{
  std::array<Index, 2> points; ///< ascending
  Index facet;
  bool turned; ///< the points follow each other the other way round

  bool operator<(const BucketEntry& other) const
  {
    return this->points != other.points ? this->points < other.points : this->facet < other.facet;
  }
};

BucketEntry entryOf(Triple facet, Index number)
{
  std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
  const bool turned = facet[1] > facet[2];
  return { { std::min(facet[1], facet[2]), std::max(facet[1], facet[2]) }, number, turned };
}

/** Marks what a bucket, sorted, has more than once. */
void markRepeats(const std::vector<BucketEntry>& entries, Duplicates& duplicates)
{
  std::size_t first = 0;
  for (std::size_t k = 1; k < entries.size(); ++k)
  {
    if (entries[k].points != entries[first].points)
    {
      first = k;
      continue;
    }
    duplicates.repeats[entries[k].facet] = 1;
    if (entries[k].turned != entries[first].turned)
    {
      duplicates.folded[entries[first].facet] = 1;
    }
  }
}
}

Duplicates findDuplicates(const std::vector<Triple>& facetPoints, const RunControl& control)
{
  const auto lowest = [&](Offset facet)
  { return *std::min_element(facetPoints[facet].begin(), facetPoints[facet].end()); };
  const auto count = static_cast<Offset>(facetPoints.size());
  const std::vector<unsigned char> none(facetPoints.size(), 0);
  Duplicates duplicates{ none, none };
  Index highest = noIndex;
  for (Offset f = 0; f < count; ++f)
  {
    highest = std::max(highest, lowest(f));
  }
  Groups buckets;
  if (!groupByKey(count, highest + 1, control.silent(), lowest, buckets))
  {
    return duplicates;
  }
  const bool done = forEachRange(longBlocks(highest + 1), control.silent(),
    [&](Offset begin, Offset end)
    {
      std::vector<BucketEntry> entries;
      for (Offset point = begin; point < end; ++point)
      {
        entries.clear();
        for (Offset k = buckets.begins[point]; k < buckets.begins[point + 1]; ++k)
        {
          entries.push_back(entryOf(facetPoints[buckets.items[k]], buckets.items[k]));
        }
        std::sort(entries.begin(), entries.end());
        markRepeats(entries, duplicates);
      }
    });
  return done ? duplicates : Duplicates{ none, none };
}

namespace
{
/** Folded facets that hang together, and how each meets others. */
struct FoldedParts
{
  DisjointSets sets;
  std::vector<unsigned char> hangs;     ///< on an edge with several others
  std::vector<unsigned char> continues; ///< an edge of one other

  explicit FoldedParts(std::size_t facets)
    : sets(facets)
    , hangs(facets, 0)
    , continues(facets, 0)
  {
  }
};

FoldedParts joinFolded(const EdgeTable& edges, const std::vector<unsigned char>& folded)
{
  FoldedParts parts(folded.size());
  for (Index edge = 0; edge < edges.numberOfEdges(); ++edge)
  {
    const auto begin = edges.edgeFacets.begin() + edges.edgeFacetsBegin[edge];
    const auto end = edges.edgeFacets.begin() + edges.edgeFacetsBegin[edge + 1];
    const auto isFolded = [&](Index facet) { return folded[facet] != 0; };
    const auto first = std::find_if(begin, end, isFolded);
    const auto others = std::count_if(begin, end, [&](Index facet) { return !folded[facet]; });
    for (auto facet = first; facet != end; ++facet)
    {
      if (folded[*facet])
      {
        parts.sets.unite(*first, *facet);
        parts.hangs[*facet] |= others > 1;
        parts.continues[*facet] |= others == 1;
      }
    }
  }
  return parts;
}
}

std::vector<unsigned char> findFlaps(const std::vector<Triple>& facetPoints,
  const std::vector<unsigned char>& folded, const RunControl& control)
{
  std::vector<unsigned char> flaps(facetPoints.size(), 0);
  if (std::find(folded.begin(), folded.end(), 1) == folded.end())
  {
    return flaps;
  }
  FoldedParts parts = joinFolded(buildEdgeTable(facetPoints, control), folded);
  const auto partOf = [&](std::size_t f) { return parts.sets.find(static_cast<Index>(f)); };
  std::vector<unsigned char> goes(facetPoints.size(), 0);
  for (std::size_t f = 0; f < folded.size(); ++f)
  {
    goes[partOf(f)] |= parts.hangs[f];
  }
  for (std::size_t f = 0; f < folded.size(); ++f)
  {
    if (parts.continues[f])
    {
      goes[partOf(f)] = 0;
    }
  }
  for (std::size_t f = 0; f < folded.size(); ++f)
  {
    flaps[f] = folded[f] && goes[partOf(f)];
  }
  return flaps;
}
}
