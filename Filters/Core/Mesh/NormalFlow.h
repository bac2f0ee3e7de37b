/**
 * @file NormalFlow.h
 * @brief Smooths normals, or a surface itself, over a distance, whatever the sizes of the facets.
 */
#ifndef remesh_NormalFlow_h
#define remesh_NormalFlow_h

#include "Mesh/SurfaceMesh.h"
#include "Support/RunControl.h"

namespace remesh
{
/**
 * Lets the normals flow like heat for the time that spreads a point's normal over `radius`: the
 * bends that are smaller fade, those that are larger stay.
 *
 * Normals flow along facets, in corner space: not across creases. What a facet larger than the
 * radius passes on is little, so coarse meshes stay as they are.
 *
 * @param radius root mean square distance, in the unit of the points; 0 or less changes nothing.
 * @param normals C unit vectors, replaced; a corner around which they all but cancel
 *        keeps its own, as on a small closed part of the surface.
 * @param control reports the steps; when it cancels, normals are as the last whole step left them.
 * Cost: O(F k), k the steps of the solver, about radius over edge length and at most 400.
 * Parallel. Deterministic.
 */
void smoothNormalsOver(
  const SurfaceMesh& mesh, double radius, const RunControl& control, std::vector<Point3>& normals);

/**
 * The same, and where the corners (C) come to if their places flow like that: bends smaller than
 * `radius` are smoothed away, and ends and thin parts shrink. The sides of a cut come apart. Of no
 * use when cancelled. Cost as above.
 */
std::vector<Point3> smoothNormalsAndPlacesOver(
  const SurfaceMesh& mesh, double radius, const RunControl& control, std::vector<Point3>& normals);

/** The mean spacing of so many points on a surface, sqrt(area / sites). 0 without points. */
double meanSpacing(const SurfaceMesh& mesh, Offset sites);

/**
 * The distance over which estimated normals are smoothed before a surface is given `sites` points:
 * 1.5 times their mean spacing. Finer bends cannot be meshed and would only wrinkle the surface in
 * R^d.
 */
double smoothingRadius(const SurfaceMesh& mesh, Offset sites);
}

#endif
