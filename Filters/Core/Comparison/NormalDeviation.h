/**
 * @file NormalDeviation.h
 * @brief Whether the triangles of a mesh face as a surface does where they lie.
 */
#ifndef remesh_NormalDeviation_h
#define remesh_NormalDeviation_h

#include "Mesh/TriangleTree.h"
#include "Support/Status.h"

#include <vector>

namespace remesh
{
/**
 * For each triangle the angle in degrees, 0 to 180, between its normal and that of the surface's
 * triangle closest to its centroid: of several that are as close (up to 1e-9 of the distance or
 * 1e-12 of the surface's size), the one that faces most alike. NaN for a triangle without area.
 *
 * By the triangles' own order of points: on a surface that is not consistently oriented, angles
 * above 90 degrees say nothing.
 *
 * @param surface not empty.
 * @param size of the surface, such as its diagonal; in the unit of the points.
 * Cost: a search in the tree for each triangle, in parallel. Deterministic.
 */
Status measureNormalDeviations(const Triangles& mesh, const TriangleTree& surface, double size,
  const RunControl& control, std::vector<double>& degrees);
}

#endif
