/**
 * @file StepLimit.h
 * @brief How far vertices may go towards their goals before a triangle turns or collapses.
 */
#ifndef remesh_StepLimit_h
#define remesh_StepLimit_h

#include "Placement/PlacementProblem.h"
#include "Support/RunControl.h"

namespace remesh
{
/** What a triangle is held against. */
struct ShapeReference
{
  const std::vector<Point3>& positions; ///< K, whose triangles have the shapes to keep
  const std::vector<Point3>& normals; ///< T, along the surface's normal, zero where it is unknown;
                                      ///< or empty: all are
  const std::vector<Point3>& before;  ///< K, where the steps start
};

/**
 * Moves every vertex towards its goal by the largest of 1, 1/2, 1/4, 1/8 and 0 of the way for which
 * no triangle around it gets worse than allowed:
 *
 * - its normal makes at most 60 degrees with the surface's, or no more than before;
 * - against the reference's, its shape is stretched no more in one direction than 6 times as in the
 *   other, or no more than before. (Not against equilateral ones: the triangles are anisotropic.)
 *
 * Where a triangle gets worse, its three vertices fall back together, until none does: a vertex
 * falls at most four times, and with all its vertices back a triangle is what it was.
 *
 * @param goals K; replaced by the places reached.
 * @return false when cancelled.
 * Cost: O(T) per round; a few rounds. Parallel, deterministic.
 */
[[nodiscard]] bool limitSteps(const PlacementProblem& problem, const VertexStars& stars,
  const ShapeReference& reference, const RunControl& control, std::vector<Point3>& goals);
}

#endif
