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
/** The largest factor between the lengths of a vector in two metrics. */
double largestFactor(const Tensor2& a, const Tensor2& b)
{
  const RelativeSizes sizes = relativeSizes(a, b);
  return std::sqrt(std::max(sizes.max, 1.0 / sizes.min));
}

TargetShape shapeOf(const SurfaceMesh& mesh, const MetricField& metric, std::size_t facet)
{
  const Triple& points = mesh.facetPoints[facet];
  const Point3 first = mesh.points[points[1]] - mesh.points[points[0]];
  const Point3 second = mesh.points[points[2]] - mesh.points[points[0]];
  const TangentFrame frame = TangentFrame::of(mesh, facet);
  const std::array<Tensor2, 3> own = tensorsOf(mesh, metric, facet);
  const Tensor2 mean = (own[0] + own[1] + own[2]) * (1.0 / 3.0);
  // Both edges in the plane: (u, 0) and (v, w).
  const double u = first.norm();
  const double v = second.dot(frame.x);
  const double w = second.dot(frame.y);
  TargetShape shape;
  shape.variation = std::max({ largestFactor(own[0], own[1]), largestFactor(own[1], own[2]),
    largestFactor(own[2], own[0]) });
  shape.a = u * std::sqrt(mean.xx);
  shape.b = u * (mean.xx * v + mean.xy * w) / shape.a;
  shape.c = u * w * std::sqrt(mean.determinant()) / shape.a;
  return shape;
}
}

std::vector<Point3> pointNormals(const SurfaceMesh& mesh)
{
  std::vector<Point3> normals(mesh.points.size(), Point3::Zero());
  for (const Triple& points : mesh.facetPoints)
  {
    const Point3& first = mesh.points[points[0]];
    const Point3 normal = (mesh.points[points[1]] - first).cross(mesh.points[points[2]] - first);
    for (const Index point : points)
    {
      normals[point] += normals[point].dot(normal) < 0.0 ? Point3(-normal) : normal;
    }
  }
  for (Point3& normal : normals)
  {
    normal.stableNormalize();
  }
  return normals;
}

std::array<Tensor2, 3> tensorsOf(
  const SurfaceMesh& mesh, const MetricField& metric, std::size_t facet)
{
  const TangentFrame frame = TangentFrame::of(mesh, facet);
  std::array<Tensor2, 3> own;
  for (int k = 0; k < 3; ++k)
  {
    const Index point = mesh.facetPoints[facet][k];
    own[k] = frame.turnedTo(metric.normals[point]).within(metric.tensors[point]);
  }
  return own;
}

Eigen::Matrix<double, 2, 3> rulerAt(
  const SurfaceMesh& mesh, const MetricField& metric, Index facet, const double b[3])
{
  const std::array<Tensor2, 3> own = tensorsOf(mesh, metric, static_cast<std::size_t>(facet));
  const Tensor2 mean =
    logarithm(own[0]) * b[0] + logarithm(own[1]) * b[1] + logarithm(own[2]) * b[2];
  const Tensor2 root = exponential(mean * 0.5);
  const TangentFrame frame = TangentFrame::of(mesh, static_cast<std::size_t>(facet));
  Eigen::Matrix<double, 2, 3> ruler;
  ruler.row(0) = (root.xx * frame.x + root.xy * frame.y).transpose();
  ruler.row(1) = (root.xy * frame.x + root.yy * frame.y).transpose();
  return ruler;
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
