#include "Metric/MetricField.h"

#include "Mesh/FacetGeometry.h"
#include "Support/Grouping.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace remesh
{
namespace
{
constexpr double cosineOfCrease = 0.766; // 40 degrees, above which tangent planes are not turned

/** Two orthonormal vectors of a facet's plane, the first along its first edge. */
struct Basis
{
  Point3 x;
  Point3 y;
  Point3 normal;
};

/** The tensor within a plane, which is that of the basis turned so that its normal is `normal`. */
Tensor2 within(const Eigen::Matrix3d& tensor, const Basis& basis, const Point3& normal)
{
  Point3 x = basis.x;
  Point3 y = basis.y;
  if (basis.normal.dot(normal) > cosineOfCrease)
  {
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(basis.normal, normal);
    x = turn * x;
    y = turn * y;
  }
  return { x.dot(tensor * x), x.dot(tensor * y), y.dot(tensor * y) };
}

/** The largest factor between the lengths of a vector in two metrics. */
double largestFactor(const Tensor2& a, const Tensor2& b)
{
  // Eigenvalues of a^-1 b: squares of such factors.
  const double determinant = a.determinant();
  const double half = 0.5 * (a.yy * b.xx - 2.0 * a.xy * b.xy + a.xx * b.yy) / determinant;
  const double product = b.determinant() / determinant;
  const double large = half + std::sqrt(std::max(half * half - product, 0.0));
  return std::sqrt(std::max(large, large / product));
}

TargetShape shapeOf(const SurfaceMesh& mesh, const MetricField& metric, std::size_t facet)
{
  const Triple& points = mesh.facetPoints[facet];
  const Point3 first = mesh.points[points[1]] - mesh.points[points[0]];
  const Point3 second = mesh.points[points[2]] - mesh.points[points[0]];
  Basis basis;
  basis.normal = first.cross(second).stableNormalized();
  basis.x = first.stableNormalized();
  basis.y = basis.normal.cross(basis.x);
  Tensor2 own[3];
  for (int k = 0; k < 3; ++k)
  {
    own[k] = within(metric.tensors[points[k]], basis, metric.normals[points[k]]);
  }
  const Tensor2 mean = (own[0] + own[1] + own[2]) * (1.0 / 3.0);
  // Both edges in the plane: (u, 0) and (v, w).
  const double u = first.norm();
  const double v = second.dot(basis.x);
  const double w = second.dot(basis.y);
  TargetShape shape;
  shape.variation = std::max({ largestFactor(own[0], own[1]), largestFactor(own[1], own[2]),
    largestFactor(own[2], own[0]) });
  shape.a = u * std::sqrt(mean.xx);
  shape.b = u * (mean.xx * v + mean.xy * w) / shape.a;
  shape.c = u * w * std::sqrt(mean.determinant()) / shape.a;
  return shape;
}
}

Status findTargetShapes(const SurfaceMesh& mesh, const MetricField& metric,
  const RunControl& control, std::vector<TargetShape>& shapes)
{
  shapes.resize(mesh.facetPoints.size());
  const auto count = static_cast<Offset>(shapes.size());
  const auto find = [&](Offset f)
  { shapes[f] = shapeOf(mesh, metric, static_cast<std::size_t>(f)); };
  if (!forEachItem(count, control, find))
  {
    return Status::cancelled();
  }
  Offset first = std::numeric_limits<Offset>::max(); // of the caller's cells
  for (std::size_t f = 0; f < shapes.size(); ++f)
  {
    const double area = shapes[f].area();
    if (!(area > 0.0) || !std::isfinite(area) || !std::isfinite(shapes[f].b))
    {
      first = std::min(first, mesh.facetInputCells[f]);
    }
  }
  return first == std::numeric_limits<Offset>::max()
    ? Status::success()
    : Status::invalid("Cell " + std::to_string(first) +
        " has no area in the metric: sizes differ by more than numbers can tell.");
}
}
