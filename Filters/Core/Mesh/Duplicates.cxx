/**
 * @file Duplicates.cxx
 *
 * 1. Put the facets into one bucket per lowest point.
 * 2. Sort each bucket by the other two points, then by facet: repetitions follow each other.
 */
#include "Mesh/Duplicates.h"

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
  bool isTurned; ///< against the order lowest point, `points`

  bool operator<(const BucketEntry& other) const
  {
    return this->points != other.points ? this->points < other.points : this->facet < other.facet;
  }
};

BucketEntry makeEntry(Triple facet, Index number)
{
  std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
  const auto [lower, higher] = std::minmax(facet[1], facet[2]);
  return { { lower, higher }, number, facet[1] > facet[2] };
}

using Entries = std::vector<BucketEntry>::const_iterator;

/** Marks all but one of the facets on the same points. */
void markRun(Entries first, Entries end, std::vector<unsigned char>& duplicate)
{
  const auto isLikeFirst = [turned = first->isTurned](const BucketEntry& entry)
  { return entry.isTurned == turned; };
  const bool keepsFirst = 2 * std::count_if(first, end, isLikeFirst) >= end - first;
  const Index kept = keepsFirst ? first->facet : std::find_if_not(first, end, isLikeFirst)->facet;
  for (; first != end; ++first)
  {
    duplicate[first->facet] = first->facet != kept;
  }
}
}

std::vector<unsigned char> findDuplicates(
  const std::vector<Triple>& facetPoints, const RunControl& control)
{
  const auto lowest = [&](Offset facet)
  { return *std::min_element(facetPoints[facet].begin(), facetPoints[facet].end()); };
  const auto count = static_cast<Offset>(facetPoints.size());
  std::vector<unsigned char> duplicate(facetPoints.size(), 0);
  Index highest = noIndex;
  for (Offset f = 0; f < count; ++f)
  {
    highest = std::max(highest, lowest(f));
  }
  Groups buckets;
  if (!groupByKey(count, highest + 1, control.silent(), lowest, buckets))
  {
    return duplicate;
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
          entries.push_back(makeEntry(facetPoints[buckets.items[k]], buckets.items[k]));
        }
        std::sort(entries.begin(), entries.end());
        for (auto first = entries.cbegin(); first != entries.cend();)
        {
          const auto last = std::find_if(first, entries.cend(),
            [&](const BucketEntry& entry) { return entry.points != first->points; });
          if (last - first > 1)
          {
            markRun(first, last, duplicate);
          }
          first = last;
        }
      }
    });
  return done ? duplicate : std::vector<unsigned char>(facetPoints.size(), 0);
}
}
