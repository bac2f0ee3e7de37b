/**
 * @file Wrinkles.h
 * @brief How much of a surface in R^6 are bends that smoothed normals do not have.
 */
#ifndef remesh_Wrinkles_h
#define remesh_Wrinkles_h

#include "Mesh/SurfaceMesh.h"
#include "Support/RunControl.h"

namespace remesh
{
/**
 * The area that normals cover on a sphere of radius `s`, less what smoothed ones cover, as a share
 * of the surface's area in R^6 with the smoothed ones.
 *
 * Wrinkles bend in all directions, so that their normals cover an area, and points are spent on
 * them. The normals of a bend along one direction, as of a rounded edge, cover a curve alone,
 * however narrow it is: long triangles follow it, and smoothing only hides it from them.
 *
 * @param normals, smoothed C unit vectors each.
 * @param s length given to a unit normal, in the unit of the points.
 * @return below 0 where smoothed normals cover more. Of no use when cancelled.
 * Cost: O(F), parallel. Deterministic.
 */
double wrinkledShare(const SurfaceMesh& mesh, const std::vector<Point3>& normals,
  const std::vector<Point3>& smoothed, double s, const RunControl& control);
}

#endif
