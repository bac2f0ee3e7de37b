/**
 * @file SurfaceFit.h
 * @brief Moves all vertices together so that the triangles come closest to the surface.
 */
#ifndef remesh_SurfaceFit_h
#define remesh_SurfaceFit_h

#include "Placement/CellForms.h"
#include "Support/Status.h"

namespace remesh
{
/** What the fit starts from and keeps, roughly. */
struct HeldShapes
{
  const std::vector<Point3>& positions; ///< K, of the centroids, or where fixed vertices are
  bool held; ///< whether vertices stay near them along the surface, not only shapes as they are
  bool heldFirmly = false; ///< whether they move across the surface alone
};

/**
 * The sparse least squares fit of a mesh to the surface that it is the dual of.
 *
 * Rounds of: tie samples of the surface to their closest points on the mesh; solve for the
 * displacements that minimise the squared distances of those points from the samples' planes, and
 * keep triangles well-shaped in R^d (FitSystem.h); go there, or in all but the last round beyond
 * (over-relaxation, and at first momentum), as far as no triangle turns or collapses (StepLimit.h).
 * In the end, vertices that have gone too far from the surface come back (DistanceBound.h).
 *
 * Vertices on a surface lie on one side of it where it bends; fitted ones share the error out to
 * both sides, which on a convex surface makes it a quarter. Where it bends unevenly, they slide
 * along it to where it bends most, which on scans is worth more than that, at the cost of the
 * triangles' shapes. Where their places along it are what the caller wants, they are held there:
 * they may slide as far as edges and triangles in R^d stay as regular as they are (Regularity.h).
 *
 * @param positions K, R^3; replaced but at fixed vertices.
 * Cost: O(pieces + 40 K) per round at most, and the solver's steps, O(K) each. Parallel,
 * deterministic.
 * Memory: the samples of the first rounds, where they take at most 256 MB (FitSamples.h).
 */
Status fitToSurface(const PlacementProblem& problem, const CellForms& cells,
  const HeldShapes& shapes, const RunControl& control, std::vector<Point3>& positions);
}

#endif
