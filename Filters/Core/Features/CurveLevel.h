/**
 * @file CurveLevel.h
 * @brief Places on two curves that meet in a corner, as far from it as each other.
 *
 * Such places keep each other off. Each the foot of the last one on the other curve, they would
 * come ever closer to the corner.
 */
#ifndef remesh_CurveLevel_h
#define remesh_CurveLevel_h

#include "Features/FeatureSites.h"

namespace remesh
{
/** Of the copies of a feature point, the one nearest to a place in R^d: its side's. */
Index nearestCopy(const FeatureSites& sites, Index point, const Eigen::VectorXd& place);

/** The foot of a site on a curve. */
struct CurveFoot
{
  Index curve;
  Station station;
  Eigen::VectorXd place; ///< d, in R^d, on the side in question
};

/**
 * The place of a curve that is as far, in R^d, from a corner as a site on a feature is: from the
 * one that is nearest to the site, of those at an end of both curves. If there is none, the foot.
 */
Station levelWith(
  const FeaturedSurface& featured, const FeatureSites& sites, Index site, const CurveFoot& foot);
}

#endif
