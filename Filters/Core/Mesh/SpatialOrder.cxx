/**
 * @file SpatialOrder.cxx
 */
#include "Mesh/SpatialOrder.h"

#include "Support/Grouping.h"
#include "Support/Hilbert.h"
#include "Support/KeyOrder.h"

namespace remesh
{
std::vector<Index> orderAlongHilbertCurve(
  const std::vector<Point3>& points, const RunControl& control)
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
  return done ? orderByKey(keys, control) : std::vector<Index>(points.size());
}
}
