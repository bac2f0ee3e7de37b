/**
 * @file Embedding.h
 * @brief From a surface and its normals or arrays to the surface in R^d.
 */
#ifndef remesh_Embedding_h
#define remesh_Embedding_h

#include "Embedding/EmbeddedSurface.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

namespace remesh
{
/** Phi(x) = (x, y, z) ([Levy12] at s = 0). */
CornerCoordinates positionCoordinates(const SurfaceMesh& mesh);

/**
 * Phi(x) = (x, y, z, s nx, s ny, s nz), [Levy12] 3.2.
 *
 * @param normals C unit vectors.
 * @param s length given to a unit normal, in the unit of the points.
 */
CornerCoordinates gaussMapCoordinates(
  const SurfaceMesh& mesh, const std::vector<Point3>& normals, double s);

/** Appends `scale` times the components of `more` to each corner's coordinates; none is lent. */
void appendCoordinates(CornerCoordinates& coordinates, const CornerCoordinates& more, double scale);

/**
 * Makes room for `more` components, zero so far, after those of each corner. None is lent.
 * Holds the old and the new rows at once.
 */
void widenCoordinates(CornerCoordinates& coordinates, int more);

/**
 * Centres and scales the coordinates and computes the constants of the facets.
 *
 * @param coordinates are scaled in place and become the surface's, unless they are lent (of at
 * least manyDimensions components): then the lent arrays must outlive the surface.
 * @return InvalidInput when a coordinate is not finite, when coordinates span more than a double
 *         can square, or when the surface has no area in R^d.
 */
Status embedSurface(const SurfaceMesh& mesh, CornerCoordinates coordinates,
  const RunControl& control, EmbeddedSurface& surface);

/**
 * Weights the energy, facet by facet: it is the integral of the density times the squared distance
 * to the site. In two dimensions the sites' spacing is then proportional to density^(-1/4), and
 * their number per area to density^(1/2) (A. Gersho, "Asymptotically optimal block quantization",
 * 1979). Densities are scaled by a power of two to about 1 on average; only ratios matter.
 *
 * @param densities F, finite and above 0.
 */
void weightByDensity(const std::vector<double>& densities, EmbeddedSurface& surface);

/**
 * Moves patches so far apart that no site's cell reaches another patch (PatchLattice.h). The
 * surface must hold its corners, and its patches must not have been moved yet.
 *
 * @param facetPatches F, from 0.
 */
void separatePatches(
  const std::vector<Index>& facetPatches, Index numberOfPatches, EmbeddedSurface& surface);

/**
 * Rounds sites to coordinates that `toCaller` and back again, `toScaled`, do not change: the same
 * sites, to the bit, when the caller gives them back.
 *
 * Let x be what y - c is rounded to, for the caller's y and the centre c. If |y| >= |x|, y - c was
 * exact, as all of it lies on y's grid; else |c| <= 2 |x|, and x + c is exact, as all of it lies on
 * x's grid. This needs c on a coarser grid than both, which is how embedSurface chooses it.
 */
void roundToCaller(const EmbeddedSurface& surface, Sites& sites);

/** Area of a triangle in R^d from its Gram determinant, stable for slivers. */
double triangleArea(const double* p1, const double* p2, const double* p3, int dimension);
}

#endif
