/**
 * @file PassedPoints.h
 * @brief Finds points on features that the chords of curves pass on their wrong side.
 *
 * A chord of a curve that bends towards another feature may reach beyond the other one's points.
 * Then triangles of these points and the chord are inverted, wherever else there are points.
 */
#ifndef remesh_PassedPoints_h
#define remesh_PassedPoints_h

#include "Features/FeatureSites.h"
#include "Support/RunControl.h"

namespace remesh
{
/**
 * A feature point between a section of a curve and its chord: in the ball over the point's foot on
 * the curve and the chord's point that is nearest to this foot.
 */
struct PassedPoint
{
  Index point;
  Index curve;
  Index section; ///< of the curve, after this station
  Station foot;  ///< of the curve, the nearest one in R^3
};

/**
 * @param points feature points; those to look for.
 * @return by curve and section; of no use when cancelled, which is asked curve by curve.
 * Cost: O(V) for V points on curves; for each section that bends, the points that are as far along
 * an axis as it reaches.
 */
std::vector<PassedPoint> findPassedPoints(const FeaturedSurface& featured,
  const FeatureSites& featureSites, const std::vector<Index>& points,
  const RunControl& control = RunControl());
}

#endif
