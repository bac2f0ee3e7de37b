#include "Metric/TangentFrame.h"

#include <Eigen/Geometry>

#include <cmath>

namespace remesh
{
TangentFrame TangentFrame::across(const Point3& normal)
{
  const Point3 x = normal.unitOrthogonal();
  return { x, normal.cross(x), normal };
}

TangentFrame TangentFrame::of(const SurfaceMesh& mesh, std::size_t facet)
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

TangentFrame TangentFrame::turnedTo(const Point3& other) const
{
  constexpr double cosineOfCrease = 0.766;
  const double cosine = this->normal.dot(other);
  if (!(std::abs(cosine) > cosineOfCrease))
  {
    return *this;
  }
  const Point3 goal = cosine < 0.0 ? Point3(-other) : other; // sides do not matter
  const Point3 sum = this->normal + goal;
  const double scale = 1.0 / (1.0 + std::abs(cosine));
  return { this->x - scale * this->x.dot(goal) * sum, this->y - scale * this->y.dot(goal) * sum,
    goal };
}

Tensor2 TangentFrame::within(const Eigen::Matrix3d& tensor) const
{
  return { this->x.dot(tensor * this->x), this->x.dot(tensor * this->y),
    this->y.dot(tensor * this->y) };
}

Eigen::Matrix3d TangentFrame::tensorOf(const Tensor2& tensor, double across) const
{
  const Eigen::Matrix3d mixed = this->x * this->y.transpose();
  return tensor.xx * this->x * this->x.transpose() + tensor.yy * this->y * this->y.transpose() +
    tensor.xy * (mixed + mixed.transpose()) + across * this->normal * this->normal.transpose();
}
}
