/**
 * @file DistanceLimit.h
 * @brief Whether a surface is within a limit of another one, and where it is not.
 */
#ifndef remesh_DistanceLimit_h
#define remesh_DistanceLimit_h

#include "Mesh/TriangleTree.h"
#include "Support/Status.h"

namespace remesh
{
/** A place of the first surface that is far from the second one. */
struct FarPlace
{
  Index triangle; ///< of the first surface
  Point3 place;
  double distance; ///< at the place, in the unit of the points
};

/**
 * At most one place for each triangle of `from`, ascending: none means that no point of the surface
 * is further than `limit` from the other one (up to rounding).
 *
 * Bounds are those of MaximumBound.h, but each triangle is examined by itself, against the limit.
 * Parts are cut along a side of the triangle that is closest to their centroid, or into four
 * (SurfaceParts.h). That goes on until all bounds are below the limit, or a distance that is found
 * at the centroid of a part is above 95 % of it: then the worst part of that step is the triangle's
 * place. So a triangle within 95 % of the limit is never told, one
 * beyond the limit always. Triangles that take more than a million parts are told, too.
 *
 * @param to has triangles.
 * @param limit above 0, in the unit of the points.
 * @return Cancelled, or success.
 * Cost: a search in the tree for each part at most, in parallel: none for those that are within the
 * limit of the triangle along which they were cut. Deterministic.
 */
Status findPlacesBeyond(const Triangles& from, const TriangleTree& to, double limit,
  const RunControl& control, std::vector<FarPlace>& places);
}

#endif
