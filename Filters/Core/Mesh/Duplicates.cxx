/**
 * @file Duplicates.cxx
 *
 * 1. Put the facets into one bucket per lowest point (count, scan, fill).
 * 2. Sort each bucket by the other two points, then by facet: repetitions follow their original.
 */
#include "Mesh/Duplicates.h"

#include <algorithm>

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

std::vector<unsigned char> findDuplicates(const std::vector<Triple>& facetPoints)
{
  Index highest = noIndex;
  for (const Triple& facet : facetPoints)
  {
    highest = std::max(highest, *std::min_element(facet.begin(), facet.end()));
  }
  std::vector<Offset> begins(static_cast<std::size_t>(highest) + 2, 0);
  for (const Triple& facet : facetPoints)
  {
    ++begins[*std::min_element(facet.begin(), facet.end()) + 1];
  }
  for (std::size_t i = 1; i < begins.size(); ++i)
  {
    begins[i] += begins[i - 1];
  }
  std::vector<BucketEntry> entries(facetPoints.size());
  std::vector<Offset> next(begins);
  for (std::size_t f = 0; f < facetPoints.size(); ++f)
  {
    const Triple points = sorted(facetPoints[f]);
    entries[next[points[0]]++] = { { points[1], points[2] }, static_cast<Index>(f) };
  }

  std::vector<unsigned char> duplicate(facetPoints.size(), 0);
  for (std::size_t point = 0; point + 1 < begins.size(); ++point)
  {
    std::sort(entries.begin() + begins[point], entries.begin() + begins[point + 1]);
    for (Offset i = begins[point] + 1; i < begins[point + 1]; ++i)
    {
      duplicate[entries[i].facet] = entries[i].points == entries[i - 1].points;
    }
  }
  return duplicate;
}
}
