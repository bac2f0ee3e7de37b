/**
 * @file MetricInput.h
 * @brief From a point array of tensors to a metric on the surface, and to its embedding.
 */
#ifndef remesh_MetricInput_h
#define remesh_MetricInput_h

#include "Embedding/CornerCoordinates.h"
#include "Metric/MetricSurface.h"
#include "Preparation/PointArray.h"

namespace remesh
{
/** Which component of an array of 6 (or 3) components is which entry of the tensor. */
enum class TensorOrder
{
  Vtk = 0,  ///< XX YY ZZ XY YZ XZ; in the plane XX YY XY
  Rows = 1, ///< XX XY XZ YY YZ ZZ; in the plane XX XY YY
  Sol = 2   ///< XX XY YY XZ YZ ZZ, as in .sol files; in the plane XX XY YY
};

/**
 * Reads a metric: 9 components (row by row), 6, 3 (of a surface in a plane z = constant), or 1 (a
 * size h: an edge of length h has the length 1).
 *
 * @param array one tuple for each of the caller's points.
 * @return InvalidInput, with the array's name and the first such point, where a tensor is not
 *         finite, not symmetric, or not positive definite along the surface; and for other numbers
 *         of components or tuples.
 */
Status readMetric(const SurfaceMesh& mesh, const PointArray& array, TensorOrder order,
  Offset numberOfInputPoints, MetricField& metric);

/** How well an embedding has the metric's lengths. */
struct MetricFit
{
  double within = 1.0; ///< share of the area stretched by 1/sqrt 2 to sqrt 2 in all directions,
                       ///< where sizes vary within facets by no more than a factor of 2, and
                       ///< from one given point to the next by no more than 4
  double limit = 1.0;  ///< the largest factor by which a size was made smaller
  double unit = 1.0;   ///< the length of edges in the metric, for the number of sites
};

MetricFit fitOf(const MetricSurface& surface);

/** A warning where the metric is not met on a tenth of the surface. */
void tellFit(const MetricFit& fit, std::vector<std::string>& warnings);

/**
 * Quantiles by area in the metric of the least stretch of a facet, and of the largest one: on that
 * share of the area they are smaller.
 */
std::vector<std::array<double, 2>> stretchQuantiles(
  const MetricSurface& surface, const std::vector<double>& shares);

/**
 * The corners' places in R^d: the points' in an isometric embedding of the metric, the same on all
 * sides of creases.
 */
CornerCoordinates metricCoordinates(const SurfaceMesh& mesh, const MetricSurface& surface);
}

#endif
