#include "Features/CurveLevel.h"

#include "Features/CurveStations.h"
#include "Features/CurveStretches.h"

#include <limits>

namespace remesh
{
Index nearestCopy(const FeatureSites& sites, Index point, const Eigen::VectorXd& place)
{
  const Index end =
    point + 1 < sites.numberOfPoints() ? sites.firstCopy[point + 1] : sites.sites.count();
  Index nearest = sites.firstCopy[point];
  for (Index copy = nearest + 1; copy < end; ++copy)
  {
    if ((coordinatesOf(sites, copy) - place).squaredNorm() <
      (coordinatesOf(sites, nearest) - place).squaredNorm())
    {
      nearest = copy;
    }
  }
  return nearest;
}

Station levelWith(
  const FeaturedSurface& featured, const FeatureSites& sites, Index site, const CurveFoot& foot)
{
  const auto& [curve, station, place] = foot;
  const SurfaceMesh& mesh = featured.mesh;
  const FeaturePoint& point = sites.points[sites.pointOfSite[site]];
  if (point.isCorner || point.curve == curve)
  {
    return station;
  }
  const FeatureCurve& own = featured.features.curves[curve];
  const FeatureCurve& other = featured.features.curves[point.curve];
  const Point3& from = mesh.points[own.points[station.segment]];
  const Point3 at = from + station.t * (mesh.points[own.points[station.segment + 1]] - from);
  Station level = station;
  double nearest = std::numeric_limits<double>::infinity();
  for (const bool front : { true, false })
  {
    const Index end = front ? own.points.front() : own.points.back();
    if (!own.hasCorners || (end != other.points.front() && end != other.points.back()))
    {
      continue;
    }
    const std::vector<Index>& points = sites.curvePoints[curve];
    const Coordinates corner =
      coordinatesOf(sites, nearestCopy(sites, front ? points.front() : points.back(), place));
    const double theirs = (coordinatesOf(sites, site) - corner).norm();
    const double ours = (place - corner).norm();
    if (theirs < nearest && ours > 0.0)
    {
      nearest = theirs;
      const double radius = (at - mesh.points[end]).norm() * theirs / ours;
      level = stationAtRadius(mesh, own, front, radius);
    }
  }
  return level;
}
}
