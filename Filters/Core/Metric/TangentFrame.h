/**
 * @file TangentFrame.h
 * @brief Planes that touch a surface, and tensors within them.
 */
#ifndef remesh_TangentFrame_h
#define remesh_TangentFrame_h

#include "Mesh/SurfaceMesh.h"
#include "Metric/Tensor2.h"

#include <cstddef>

namespace remesh
{
/** Two orthonormal vectors of a plane, and its normal. */
struct TangentFrame
{
  Point3 x;
  Point3 y;
  Point3 normal;

  /** Some frame across a unit normal. */
  static TangentFrame across(const Point3& normal);

  /** A facet's, the first vector along its first edge. */
  static TangentFrame of(const SurfaceMesh& mesh, std::size_t facet);

  /** This frame turned on the shortest way so that its normal is another one; as it is where both
   * are farther apart than 40 degrees, as at a crease. */
  TangentFrame turnedTo(const Point3& other) const;

  /** The part of a tensor of R^3 along the plane. */
  Tensor2 within(const Eigen::Matrix3d& tensor) const;

  /** A tensor of R^3 that is `tensor` within the plane, and `across` along the normal. */
  Eigen::Matrix3d tensorOf(const Tensor2& tensor, double across) const;
};
}

#endif
