/**
 * @file MetricField.h
 * @brief A metric on a surface, and the shapes that it gives to the facets.
 *
 * A metric is a symmetric positive definite tensor M at each point of the surface: an edge e has
 * the length sqrt(e' M e) in it. Only its part along the surface counts.
 */
#ifndef remesh_MetricField_h
#define remesh_MetricField_h

#include "Mesh/SurfaceMesh.h"
#include "Metric/TangentFrame.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

#include <vector>

namespace remesh
{
/** Functions on a surface, d at once: V x d. */
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/** The largest d. */
constexpr int maxEmbeddingDimensions = 16;

struct MetricField
{
  std::vector<Eigen::Matrix3d> tensors; ///< V, of R^3
  std::vector<Point3> normals;          ///< V, unit; of the surface's tangent planes
};

/** The tensors at a facet's corners, each turned into its plane (`TangentFrame::of` it). */
std::array<Tensor2, 3> tensorsOf(
  const SurfaceMesh& mesh, const MetricField& metric, std::size_t facet);

/**
 * Takes vectors to a plane where they have the lengths that their parts along a facet have in the
 * metric at a place of it: the mean of the corners' logarithms.
 *
 * @param b barycentric coordinates of the place.
 */
Eigen::Matrix<double, 2, 3> rulerAt(
  const SurfaceMesh& mesh, const MetricField& metric, Index facet, const double b[3]);

/** Unit normals of points: sums over their facets, each turned to the side of the first one. */
std::vector<Point3> pointNormals(const SurfaceMesh& mesh);

/**
 * A facet as it is in the metric: R'R is the Gram matrix of its edges from the first corner to the
 * second and the third, R = [a b; 0 c].
 */
struct TargetShape
{
  double a = 1.0;
  double b = 0.0;
  double c = 1.0;
  /** The largest factor, from 1, between the sizes at two of its corners, in any direction. */
  double variation = 1.0;

  double area() const { return 0.5 * this->a * this->c; }
  /** Squared length of edge k, from corner k to k + 1. */
  double edge2(int k) const
  {
    const double x = k == 0 ? this->a : k == 1 ? this->b - this->a : this->b;
    const double y = k == 0 ? 0.0 : this->c;
    return x * x + y * y;
  }
};

/** A surface of which nothing is known but how facets are joined, and their shapes. */
struct ShapedFacets
{
  Index points; ///< V
  const std::vector<Triple>& facetPoints;
  const std::vector<TargetShape>& shapes; ///< F
};

/**
 * The metric of each facet: the mean of its corners', each as it is in the corner's tangent plane,
 * turned into that of the facet on the shortest way. Where both are farther apart than 40 degrees,
 * as at a crease, what the tensor is within the facet's own plane.
 *
 * Tensors are added up as they are: where the metric turns within a facet, that makes it less
 * stretched. Means of logarithms do not, and are met less well (torus of IsometricEmbedding.h:
 * edges of 0.874 instead of 0.881).
 *
 * @param metric the tensors are positive definite.
 * @return InvalidInput, which tells the facet, where a shape has no area. O(F), in parallel.
 */
Status findTargetShapes(const SurfaceMesh& mesh, const MetricField& metric,
  const RunControl& control, std::vector<TargetShape>& shapes);
}

#endif
