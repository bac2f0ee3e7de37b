/**
 * @file Duplicates.cxx
 *
 * 1. Put the facets into one bucket per lowest point.
 * 2. Sort each bucket by the other two points, then by facet: repetitions follow their original.
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

  bool operator<(const BucketEntry& other) const
  {
    return this->points != other.points ? this->points < other.points : this->facet < other.facet;
  }
};

Triple sorted(Triple facet)
{
  std::sort(facet.begin(), facet.end());
  return facet;
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
          const Triple points = sorted(facetPoints[buckets.items[k]]);
          entries.push_back({ { points[1], points[2] }, buckets.items[k] });
        }
        std::sort(entries.begin(), entries.end());
        for (std::size_t k = 1; k < entries.size(); ++k)
        {
          duplicate[entries[k].facet] = entries[k].points == entries[k - 1].points;
        }
      }
    });
  return done ? duplicate : std::vector<unsigned char>(facetPoints.size(), 0);
}
}
