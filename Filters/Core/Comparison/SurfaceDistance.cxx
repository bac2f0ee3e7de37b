#include "Comparison/SurfaceDistance.h"

#include "Comparison/DistanceSums.h"
#include "Comparison/MaximumBound.h"

#include <cmath>
#include <limits>

namespace remesh
{
double TwoSidedDistance::rms() const
{
  return std::sqrt(
    0.5 * (this->forward.rms * this->forward.rms + this->backward.rms * this->backward.rms));
}

OneSidedDistance distanceOf(const std::vector<DistanceSums>& blocks)
{
  DistanceSums sums;
  for (const DistanceSums& block : blocks)
  {
    sums += block;
  }
  OneSidedDistance distance;
  distance.area = sums.area;
  distance.mean = sums.distance / sums.area;
  distance.rms = std::sqrt(sums.squared / sums.area);
  distance.maximum = std::sqrt(sums.largestSquared);
  distance.maximumBound = std::numeric_limits<double>::infinity();
  return distance;
}

Status measureSamples(const SampledTriangles& from, const TriangleTree& to,
  const RunControl& control, OneSidedDistance& distance)
{
  distance = {};
  if (!from.hasArea())
  {
    return Status::invalid("The surface has no triangle with a finite area above 0.");
  }
  std::vector<DistanceSums> sums;
  Status status = sumDistances(from, to, sampledBlocks(from.triangles.count()), control, sums);
  if (status.ok())
  {
    distance = distanceOf(sums);
  }
  return status;
}

Status measureOneSidedDistance(const Triangles& from, const TriangleTree& to,
  const DistanceOptions& options, const RunControl& control, OneSidedDistance& distance)
{
  const bool bounded = options.boundTolerance >= 0.0;
  Status status = measureSamples(sampledTriangles(from, options.numberOfSamples), to,
    control.step(0, bounded ? 2 : 1), distance);
  return status.ok() && bounded ? boundMaximum(from, to, options, control.step(1, 2), distance)
                                : status;
}

Status measureTwoSidedDistance(const Triangles& first, const Triangles& second,
  const DistanceOptions& options, const RunControl& control, TwoSidedDistance& distance)
{
  distance = {};
  const TriangleTree firstTree(first, control);
  const TriangleTree secondTree(second, control);
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  if (firstTree.empty() || secondTree.empty())
  {
    return Status::invalid("A surface has no triangle with an area above 0.");
  }
  Status status =
    measureOneSidedDistance(first, secondTree, options, control.step(0, 2), distance.forward);
  if (status.ok())
  {
    status =
      measureOneSidedDistance(second, firstTree, options, control.step(1, 2), distance.backward);
  }
  return status;
}
}
