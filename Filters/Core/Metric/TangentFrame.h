/**
 * @file TangentFrame.h
 * @brief Planes that touch a surface, and tensors within them.
 */
#ifndef remesh_TangentFrame_h
#define remesh_TangentFrame_h

#include "Mesh/SurfaceMesh.h"
#include "Metric/Tensor2.h"

#include <Eigen/Geometry>

namespace remesh
{
/** Two orthonormal vectors of a plane, and its normal. */
struct TangentFrame
{
  Point3 x;
  Point3 y;
  Point3 normal;

  /** Some frame across a unit normal. */
  static TangentFrame across(const Point3& normal)
  {
    const Point3 x = normal.unitOrthogonal();
    return { x, normal.cross(x), normal };
  }

  /** A facet's, the first vector along its first edge. */
  static TangentFrame of(const SurfaceMesh& mesh, std::size_t facet)
  {
    const Triple& points = mesh.facetPoints[facet];
    const Point3 first = mesh.points[points[1]] - mesh.points[points[0]];
    const Point3 second = mesh.points[points[2]] - mesh.points[points[0]];
    TangentFrame frame;
    frame.normal = first.cross(second).stableNormalized();
    frame.x = first.stableNormalized();
    frame.y = frame.normal.cross(frame.x);
    return frame;
  }

  /** This frame turned on the shortest way so that its normal is another one; as it is where both
   * are farther apart than 40 degrees, as at a crease. */
  TangentFrame turnedTo(const Point3& other) const
  {
    constexpr double cosineOfCrease = 0.766;
    const double cosine = this->normal.dot(other);
    if (!(std::abs(cosine) > cosineOfCrease))
    {
      return *this;
    }
    const Point3 goal = cosine < 0.0 ? Point3(-other) : other; // sides do not matter
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(this->normal, goal);
    return { turn * this->x, turn * this->y, goal };
  }

  Tensor2 within(const Eigen::Matrix3d& tensor) const
  {
    return { this->x.dot(tensor * this->x), this->x.dot(tensor * this->y),
      this->y.dot(tensor * this->y) };
  }

  /** A tensor of R^3 that is `tensor` within the plane, and `across` along the normal. */
  Eigen::Matrix3d tensorOf(const Tensor2& tensor, double across) const
  {
    const Eigen::Matrix3d mixed = this->x * this->y.transpose();
    return tensor.xx * this->x * this->x.transpose() + tensor.yy * this->y * this->y.transpose() +
      tensor.xy * (mixed + mixed.transpose()) + across * this->normal * this->normal.transpose();
  }
};
}

#endif
