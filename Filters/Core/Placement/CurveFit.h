/**
 * @file CurveFit.h
 * @brief Where the vertices on features go, so that the edges between them are closest to these.
 *
 * With its ends on an arc, an edge is on one side of it all along. Moved out by two thirds of the
 * arc's rise, a sixth of the mean squared distance is left.
 */
#ifndef remesh_CurveFit_h
#define remesh_CurveFit_h

#include "Features/FeatureSites.h"
#include "Support/RunControl.h"

namespace remesh
{
/**
 * Along each curve, the places p that minimise the integral over the curve of the squared distance
 * from its points to the edge of their section, across the edge: each place has a block for itself
 * and one for either neighbour, which sweeps of Gauss and Seidel's method solve. Corners stay, and
 * so does what is straight.
 *
 * @param places of each feature point, in R^3; false when cancelled: asked curve by curve.
 * Cost: O(V + places) for V points on curves.
 */
[[nodiscard]] bool fitCurves(const FeaturedSurface& featured, const FeatureSites& featureSites,
  const RunControl& control, std::vector<Point3>& places);
}

#endif
