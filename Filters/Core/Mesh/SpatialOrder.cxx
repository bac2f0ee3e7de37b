/**
 * @file SpatialOrder.cxx
 */
#include "Mesh/SpatialOrder.h"

#include "Support/Grouping.h"
#include "Support/Hilbert.h"
#include "Support/KeyOrder.h"

#include <algorithm>

namespace remesh
{
namespace
{
/** Sorts the runs of points with equal keys. */
void sortTies(const std::vector<std::uint64_t>& keys,
  const std::function<bool(Index, Index)>& isBefore, const RunControl& control,
  std::vector<Index>& order)
{
  const auto count = static_cast<Offset>(order.size());
  const auto isTied = [&](Offset k) { return keys[order[k]] == keys[order[k + 1]]; };
  const auto opensRun = [&](Offset k) { return isTied(k) && (k == 0 || !isTied(k - 1)); };
  std::vector<Offset> runs;
  static_cast<void>(packItems(
                      count - 1, control.silent(), opensRun,
                      [&](Offset size) { runs.resize(static_cast<std::size_t>(size)); },
                      [&](Offset k, Offset run) { runs[run] = k; }) &&
    forEachItem(static_cast<Offset>(runs.size()), control.silent(),
      [&](Offset run)
      {
        const auto begin = order.begin() + runs[run];
        const std::uint64_t key = keys[*begin];
        const auto end =
          std::find_if(begin, order.end(), [&](Index point) { return keys[point] != key; });
        std::sort(begin, end, isBefore);
      }));
}
}

std::vector<Index> orderAlongHilbertCurve(const std::vector<Point3>& points,
  const RunControl& control, const std::function<bool(Index, Index)>& isBefore)
{
  if (points.empty())
  {
    return {};
  }
  Point3 lower = points.front();
  Point3 upper = lower;
  for (const Point3& point : points)
  {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
  const double extent = (upper - lower).maxCoeff();
  const double inverseExtent = extent > 0.0 ? 1.0 / extent : 0.0;
  std::vector<std::uint64_t> keys(points.size());
  const bool done = forEachItem(static_cast<Offset>(points.size()), control.silent(),
    [&](Offset k) { keys[k] = hilbertKey(points[k], lower, inverseExtent); });
  if (!done)
  {
    return std::vector<Index>(points.size());
  }
  std::vector<Index> order = orderByKey(keys, control);
  if (isBefore)
  {
    sortTies(keys, isBefore, control, order);
  }
  return order;
}
}
