#include "Mesh/BorderGaps.h"

#include "Mesh/Extent.h"
#include "Mesh/Weld.h"
#include "Support/SortUnique.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr double largestWidth = 3.2e-3;     // of the diagonal, about
constexpr double smallestWidth = 1e-12;     // which is rounding
constexpr int stepsOfDecade = 2;            // of widths, each a root of ten times the next
constexpr std::size_t vanishingSides = 100; // of so many, one may vanish

/** The border's points, and its sides as pairs of their numbers. */
struct Border
{
  std::vector<Point3> points;
  std::vector<std::pair<Index, Index>> sides;
};

std::vector<Point3> pointsOf(const std::vector<Point3>& points, const std::vector<Index>& ids)
{
  std::vector<Point3> some(ids.size());
  std::transform(ids.begin(), ids.end(), some.begin(), [&](Index id) { return points[id]; });
  return some;
}

Border findBorder(
  const std::vector<Point3>& points, const std::vector<Triple>& facets, const EdgeTable& edges)
{
  Border border;
  std::vector<Index> ids;
  for (Index edge = 0; edge < edges.numberOfEdges(); ++edge)
  {
    if (edges.valence(edge) == 1)
    {
      const Index facet = edges.edgeFacets[edges.edgeFacetsBegin[edge]];
      const int k = edges.sideOf(facet, edge);
      border.sides.emplace_back(facets[facet][k], facets[facet][(k + 1) % 3]);
      ids.insert(ids.end(), { border.sides.back().first, border.sides.back().second });
    }
  }
  sortUnique(ids);
  const auto numberOf = [&](Index id)
  { return static_cast<Index>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin()); };
  for (auto& [a, b] : border.sides)
  {
    a = numberOf(a);
    b = numberOf(b);
  }
  border.points = pointsOf(points, ids);
  return border;
}

std::vector<Point3> usedPoints(const std::vector<Point3>& points, const std::vector<Triple>& facets)
{
  std::vector<Index> ids;
  for (const Triple& facet : facets)
  {
    ids.insert(ids.end(), facet.begin(), facet.end());
  }
  sortUnique(ids);
  return pointsOf(points, ids);
}

/** How many points became another one's. */
Offset countMerged(const std::vector<Index>& lowest)
{
  Offset merged = 0;
  for (std::size_t k = 0; k < lowest.size(); ++k)
  {
    merged += lowest[k] != static_cast<Index>(k);
  }
  return merged;
}

/** How many points of the border become another one's over a distance; -1 if it is too large. */
Offset countMerged(const Border& border, double distance, const RunControl& control)
{
  const std::vector<Index> lowest = weldNearPoints(border.points, distance, control);
  const auto vanished = std::count_if(border.sides.begin(), border.sides.end(),
    [&](const auto& side) { return lowest[side.first] == lowest[side.second]; });
  if (static_cast<std::size_t>(vanished) > border.sides.size() / vanishingSides)
  {
    return -1;
  }
  return countMerged(lowest);
}
}

BorderGaps findBorderGaps(const std::vector<Point3>& points, const std::vector<Triple>& facets,
  const EdgeTable& edges, const RunControl& control)
{
  BorderGaps gaps;
  const Border border = findBorder(points, facets, edges);
  const double diagonal = boundingBoxDiagonal(points);
  std::vector<Offset> merged; // over each width so far
  const double step = std::pow(10.0, 1.0 / stepsOfDecade);
  for (double width = largestWidth; width > smallestWidth && !border.points.empty(); width /= step)
  {
    merged.push_back(countMerged(border, width * diagonal, control));
    const Offset now = merged.back();
    if (now == 0 || control.cancelled() || (gaps.points > 0 && now < gaps.points))
    {
      break;
    }
    const std::size_t steps = merged.size() - 1;
    if (now > 0 && steps >= stepsOfDecade && now == merged[steps - stepsOfDecade])
    {
      gaps = { now, width };
    }
  }
  const bool isSlit = gaps.points > 0 &&
    countMerged(weldNearPoints(usedPoints(points, facets), gaps.width * diagonal, control)) ==
      gaps.points;
  return isSlit ? gaps : BorderGaps(); // else one sheet is over another one
}
}
