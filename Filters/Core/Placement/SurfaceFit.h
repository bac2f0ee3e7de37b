/**
 * @file SurfaceFit.h
 * @brief Moves all vertices together so that the triangles come closest to the surface.
 */
#ifndef remesh_SurfaceFit_h
#define remesh_SurfaceFit_h

#include "Placement/PlacementProblem.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

namespace remesh
{
/**
 * The sparse least squares fit of a mesh to the surface that it is the dual of.
 *
 * Rounds of: tie samples of the surface to their closest points on the mesh; solve for the
 * displacements that minimise the squared distances of those points from the samples' planes; go
 * there, or in all but the last round beyond (over-relaxation, and at first momentum), as far as no
 * triangle turns or collapses (StepLimit.h). Vertices on a surface lie on one side of it where it
 * bends; fitted ones share the error out to both sides, which on a convex surface makes it a
 * quarter.
 *
 * @param shapes K, the positions whose triangles' shapes are to be kept, roughly.
 * @param positions K, R^3; replaced but at fixed vertices.
 * Cost: O(pieces + 40 K) per round at most, and the solver's steps, O(K) each. Parallel,
 * deterministic.
 * Memory: the samples of the first rounds, where they take at most 256 MB (FitSamples.h).
 */
Status fitToSurface(const PlacementProblem& problem, const std::vector<Point3>& shapes,
  const RunControl& control, std::vector<Point3>& positions);
}

#endif
