/**
 * @file EvenTriangles.h
 * @brief Slides vertices along the surface until their triangles are even in a metric.
 *
 * The cells are even in R^d, where edges have the lengths that the metric gives them. Where it
 * varies within a triangle, its shape there is not yet the one that the metric at its centre asks
 * for. With that metric, and as shares of the triangle of equal sides that has the mean area, let d
 * be a triangle's area and s the mean square of its edges. Its energy is
 *
 *   s / d + w (d + 1 / d).
 *
 * The first term is its shape (P. Knupp, "Algebraic mesh quality metrics", 2001), 1 for equal
 * sides, the second its size. Both grow without bound where it collapses.
 *
 * Rounds of:
 * 1. The metric at the centres of the triangles, on the closest facet of their three cells.
 * 2. All at once, each vertex makes a part of Newton's step in the surface's tangent plane.
 * 3. It comes to the closest point of the surface. Where a triangle gets worse, its vertices go
 * half of the way instead, a quarter, an eighth, or stay.
 *
 * The rounds end where one lowers what the energy is above its bound by a small share only; what
 * raises it is taken back.
 */
#ifndef remesh_EvenTriangles_h
#define remesh_EvenTriangles_h

#include "Delaunay/SurfaceLocation.h"
#include "Placement/PlacementProblem.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

#include <vector>

namespace remesh
{
/**
 * @param problem with a metric. Fixed vertices stay, and those of triangles that face against the
 *        surface.
 * @param locations K, where the vertices are on the surface; not read for fixed ones.
 * @param places K, of fixed vertices; the others' are replaced.
 * @return Cancelled, or success.
 * Deterministic. Cost: a round about as much as one of Lloyd's steps.
 */
Status evenOutTriangles(const PlacementProblem& problem, const RunControl& control,
  std::vector<SurfaceLocation> locations, std::vector<Point3>& places);
}

#endif
