/**
 * @file MaximumBound.h
 * @brief A bound that the largest distance between two surfaces does not pass.
 */
#ifndef remesh_MaximumBound_h
#define remesh_MaximumBound_h

#include "Comparison/SurfaceDistance.h"

namespace remesh
{
/**
 * Branch and bound over parts of the triangles (M. Guthe, P. Borodin, R. Klein, "Fast and accurate
 * Hausdorff distance calculation between meshes", 2005). A part with corners p_k and centroid c,
 * whose closest triangle is t, is no further away than the lesser of
 *
 * - d(c) + max |p_k - c|, as distances change no faster than the point moves;
 * - max d(p_k, t), as the distance to a convex set is convex.
 *
 * Parts that could be further away than the target, (1 + boundTolerance) times the largest distance
 * found, are cut (SurfaceParts.h), until none is left or `maximumParts` were looked at; where there
 * are too many, those that could be furthest go first. The bound holds at whatever point it ends.
 *
 * @param distance `maximum` is where the search begins; it may grow. `maximumBound` is set, to at
 *        least `maximum`.
 */
Status boundMaximum(const Triangles& from, const TriangleTree& to, const DistanceOptions& options,
  const RunControl& control, OneSidedDistance& distance);
}

#endif
