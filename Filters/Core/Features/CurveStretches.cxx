#include "Features/CurveStretches.h"

namespace remesh
{
bool isNextTo(const FeaturedSurface& featured, const FeatureSites& sites, Index curve,
  std::size_t station, Index point)
{
  const std::vector<Index>& points = sites.curvePoints[curve];
  const std::size_t last = points.size() - 1;
  const bool around = !featured.features.curves[curve].hasCorners;
  return (station > 0 && points[station - 1] == point) ||
    (station < last && points[station + 1] == point) ||
    (around && station == 0 && points[last - 1] == point) ||
    (around && station == last && points[1] == point);
}
}
