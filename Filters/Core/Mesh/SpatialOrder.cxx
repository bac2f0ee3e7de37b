/**
 * @file SpatialOrder.cxx
 */
#include "Mesh/SpatialOrder.h"

#include "Support/Hilbert.h"
#include "Support/KeyOrder.h"

#include <algorithm>

namespace remesh
{
std::vector<Index> orderAlongHilbertCurve(const std::vector<Point3>& points)
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
  std::transform(points.begin(), points.end(), keys.begin(),
    [&](const Point3& point) { return hilbertKey(point, lower, inverseExtent); });
  return orderByKey(keys);
}
}
