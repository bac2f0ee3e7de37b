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
constexpr double largestWidth = 3.2e-3; // of the diagonal, about
constexpr double smallestWidth = 1e-12; // which is rounding
constexpr int stepsOfDecade = 2;        // of widths, each a root of ten times the next
// Of the border's sides:
constexpr double maxVanishingNear = 0.1; // over ten times a width: those at the poles of a sphere
constexpr double maxVanishing = 0.01;    // over the width
constexpr double minPaired = 0.75;       // the rest is a border of the surface

/** In units of the diagonal. */
double widthOf(std::size_t step)
{
  return largestWidth * std::pow(10.0, -static_cast<double>(step) / stepsOfDecade);
}

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

/** What becomes of the border when its points are merged. */
struct MergedBorder
{
  Offset points = 0;      ///< that become another one's
  double vanishing = 0.0; ///< the share of the sides that lose their length
  double paired = 0.0;    ///< the share of those that become the same as one other
};

MergedBorder mergeOver(double distance, const Border& border, const RunControl& control)
{
  const std::vector<Index> lowest = weldNearPoints(border.points, distance, control);
  std::vector<std::pair<Index, Index>> sides;
  for (const auto& [a, b] : border.sides)
  {
    if (lowest[a] != lowest[b])
    {
      sides.push_back(std::minmax(lowest[a], lowest[b]));
    }
  }
  std::sort(sides.begin(), sides.end());
  std::size_t paired = 0;
  for (auto begin = sides.begin(); begin != sides.end();)
  {
    const auto end = std::upper_bound(begin, sides.end(), *begin);
    paired += end - begin == 2 ? 2 : 0;
    begin = end;
  }
  const auto all = static_cast<double>(border.sides.size());
  return { countMerged(lowest), 1.0 - static_cast<double>(sides.size()) / all,
    static_cast<double>(paired) / all };
}

/**
 * The border merged over decreasing widths, until none of its points merge.
 *
 * Entry k is for `largestWidth` by k steps.
 */
std::vector<MergedBorder> mergeOverWidths(
  const Border& border, double diagonal, const RunControl& control)
{
  std::vector<MergedBorder> merged;
  for (std::size_t k = 0; widthOf(k) > smallestWidth && !border.points.empty(); ++k)
  {
    merged.push_back(mergeOver(widthOf(k) * diagonal, border, control));
    if (merged.back().points == 0 || control.cancelled())
    {
      break;
    }
  }
  return merged;
}

/** The smallest width that merges all that is much nearer than sides are long. */
BorderGaps gapsByPlateau(const std::vector<MergedBorder>& merged)
{
  BorderGaps gaps;
  for (std::size_t k = stepsOfDecade; k < merged.size(); ++k)
  {
    const Offset now = merged[k].points;
    if (now == 0 || (gaps.points > 0 && now < gaps.points))
    {
      break;
    }
    if (merged[k - stepsOfDecade].vanishing <= maxVanishingNear && now == merged[k - 1].points)
    {
      gaps = { now, widthOf(k) };
    }
  }
  return gaps;
}

/** The width that closes most, where nearly all of the border is slits. */
BorderGaps gapsByPairs(const std::vector<MergedBorder>& merged)
{
  BorderGaps gaps;
  double paired = minPaired;
  for (std::size_t k = 0; k < merged.size(); ++k)
  {
    if (merged[k].vanishing <= maxVanishing && merged[k].paired >= paired)
    {
      paired = merged[k].paired;
      gaps = { merged[k].points, widthOf(k) };
    }
  }
  return gaps;
}
}

BorderGaps findBorderGaps(const std::vector<Point3>& points, const std::vector<Triple>& facets,
  const EdgeTable& edges, const RunControl& control)
{
  const Border border = findBorder(points, facets, edges);
  const double diagonal = boundingBoxDiagonal(points);
  const std::vector<MergedBorder> merged = mergeOverWidths(border, diagonal, control);
  BorderGaps gaps = gapsByPlateau(merged);
  gaps = gaps.points > 0 ? gaps : gapsByPairs(merged);
  const bool isSlit = gaps.points > 0 &&
    countMerged(weldNearPoints(usedPoints(points, facets), gaps.width * diagonal, control)) ==
      gaps.points;
  return isSlit ? gaps : BorderGaps(); // else one sheet is over another one
}
}
