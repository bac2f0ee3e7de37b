/**
 * @file CornerArrays.h
 * @brief Point arrays of the caller's data, brought to the corners of the surface and back.
 */
#ifndef remesh_CornerArrays_h
#define remesh_CornerArrays_h

#include "Embedding/Embedding.h"
#include "Mesh/SurfaceMesh.h"
#include "Preparation/PointArray.h"
#include "Refinement/RefinedSurface.h"
#include "Support/Status.h"

#include <utility>
#include <vector>

namespace remesh
{
/**
 * Appends `scale` times the array's value at each corner, the mean over the distinct input points
 * merged into it. Holds the old and the new coordinates at once.
 *
 * @param coordinates of the corners so far; of dimension 0 at first.
 * @return InvalidInput, with the array's name, for a wrong number of tuples or a value at a used
 *         point that is not finite.
 */
Status appendCornerArray(const SurfaceMesh& mesh, const PointArray& array, double scale,
  Offset numberOfInputPoints, CornerCoordinates& coordinates);

/**
 * Appends arrays, each times its scale, without copying a value: with the same rows as above.
 *
 * @return false, and nothing was done, where that cannot be: for fewer than `minDimension`
 *         components in all; arrays that are not of doubles or floats one tuple after the other;
 *         merged points with different values; and whatever appendCornerArray calls invalid.
 */
bool lendCornerArrays(const SurfaceMesh& mesh,
  const std::vector<std::pair<PointArray, double>>& arrays, Offset numberOfInputPoints,
  int minDimension, CornerCoordinates& coordinates);

/**
 * The mean over each facet's corners of a point array of one component.
 *
 * @return InvalidInput, with the array's name, for a wrong number of components or tuples, and for
 *         a value at a used point that is not finite, not above 0, or 1e40 times another.
 */
Status readFacetDensities(const SurfaceMesh& mesh, const PointArray& array,
  Offset numberOfInputPoints, std::vector<double>& densities);

/** The same at the middles of the facets of a refined surface, once the array is known to be good.
 */
std::vector<double> densitiesOf(
  const SurfaceMesh& mesh, const FacetOrigins& origins, const PointArray& array);

/** All tuples of a point array of three components, as they are. */
Status readNormals(
  const PointArray& array, Offset numberOfInputPoints, std::vector<Point3>& normals);
}

#endif
