/**
 * @file Normals.h
 * @brief Unit normals at the corners of a surface: estimated and smoothed, or given.
 */
#ifndef remesh_Normals_h
#define remesh_Normals_h

#include "Mesh/SurfaceMesh.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

namespace remesh
{
/** A facet, and a normal for it. */
struct FacetNormal
{
  Index facet;
  Point3 normal;
};

/** The normal that a facet borrows (`borrowed` is ascending), or else that of its plane. */
Point3 normalOf(
  const SurfaceMesh& mesh, const std::vector<FacetNormal>& borrowed, std::size_t facet);

/** V, whether a point of the surface was cut into several corners. */
std::vector<char> findCutPoints(const SurfaceMesh& mesh);

/**
 * Angle-weighted means of the facet normals, smoothed by uniform 1-ring averaging.
 *
 * @param passes smoothing passes, >= 0. Parallel.
 * @param control reports the passes; when it cancels, the passes done so far are returned.
 * @param borrowed normals of facets to take in place of their own, ascending.
 * @return C unit vectors; a corner without direction (facets that cancel out) gets the normal of
 *         its first facet.
 * Cost: O(F) per pass. Deterministic.
 */
std::vector<Point3> estimateCornerNormals(const SurfaceMesh& mesh, int passes,
  const RunControl& control = RunControl(), const std::vector<FacetNormal>& borrowed = {});

/**
 * The caller's normals: at each corner the normalised mean of the distinct input points merged
 * into it (an input point counts once, whatever its number of facets). Never smoothed. An input
 * point whose facets lie in several fans, on both sides of a crease, does not count; a corner that
 * has no other gets its fan's estimated, unsmoothed normal.
 *
 * @param inputNormals 3 x P values, one per input point, any length: only directions count.
 * @return InvalidInput for a used point without normal or with a non-finite one. A zero mean falls
 *         back to the estimated, unsmoothed normal of that corner.
 * Cost: O(F). Deterministic.
 */
Status givenCornerNormals(
  const SurfaceMesh& mesh, const std::vector<Point3>& inputNormals, std::vector<Point3>& normals);
}

#endif
