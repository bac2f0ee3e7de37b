#include "Preparation/MetricInput.h"

#include "Mesh/Extent.h"
#include "Mesh/FacetGeometry.h"
#include "Metric/MetricRefinement.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace remesh
{
namespace
{
constexpr double maxVariation = 2.0;   // of sizes within a facet: above, it is too large for them
constexpr double minShareWithin = 0.9; // of the area, within a factor of sqrt 2, or it is told
constexpr double flatness = 1e-6;      // of the diagonal: what is a plane
constexpr double asymmetry = 1e-6;     // of the largest entry: rounding of single precision

std::string nameOfMetric(const PointArray& array)
{
  return "The metric array \"" + array.name + "\"";
}

/** Where each entry of 9, row by row, is in a tuple; -1: it is 0, -2: it is 1. */
using Places = std::array<int, 9>;

Places placesOf(int components, TensorOrder order)
{
  if (components == 9)
  {
    return { 0, 1, 2, 3, 4, 5, 6, 7, 8 };
  }
  if (components == 6)
  {
    switch (order)
    {
      case TensorOrder::Rows:
        return { 0, 1, 2, 1, 3, 4, 2, 4, 5 };
      case TensorOrder::Sol:
        return { 0, 1, 3, 1, 2, 4, 3, 4, 5 };
      default:
        return { 0, 3, 5, 3, 1, 4, 5, 4, 2 };
    }
  }
  return order == TensorOrder::Vtk ? Places{ 0, 2, -1, 2, 1, -1, -1, -1, -2 }
                                   : Places{ 0, 1, -1, 1, 2, -1, -1, -1, -2 };
}

Eigen::Matrix3d tensorOf(const PointArray& array, const Places& places, Offset point)
{
  std::array<double, 9> values{};
  array.read(point, values.data());
  if (array.dimension == 1)
  {
    const double size = values[0];
    return Eigen::Matrix3d::Identity() * (size > 0.0 ? 1.0 / (size * size) : -1.0);
  }
  Eigen::Matrix3d tensor;
  for (int k = 0; k < 9; ++k)
  {
    const int place = places[k];
    tensor(k / 3, k % 3) = place >= 0 ? values[place] : place == -2 ? 1.0 : 0.0;
  }
  return tensor;
}

/** Whether the part of a tensor in the plane across a normal is positive definite. */
bool isPositive(const Eigen::Matrix3d& tensor, const Point3& normal)
{
  const Point3 x = normal.unitOrthogonal();
  const Point3 y = normal.cross(x);
  const double xx = x.dot(tensor * x);
  const double xy = x.dot(tensor * y);
  const double yy = y.dot(tensor * y);
  return xx > 0.0 && yy > 0.0 && xx * yy > xy * xy;
}

/** What is wrong with a tensor, or nothing. */
std::string faultOf(const Eigen::Matrix3d& tensor, const Point3& normal)
{
  if (!tensor.allFinite())
  {
    return "is not finite";
  }
  if ((tensor - tensor.transpose()).cwiseAbs().maxCoeff() >
    asymmetry * tensor.cwiseAbs().maxCoeff())
  {
    return "is not symmetric";
  }
  return isPositive(tensor, normal) ? "" : "is not positive definite along the surface";
}

Status checkArray(const SurfaceMesh& mesh, const PointArray& array, Offset numberOfInputPoints)
{
  const int components = array.dimension;
  if (array.count != numberOfInputPoints)
  {
    return Status::invalid(nameOfMetric(array) + " has " + std::to_string(array.count) +
      " tuples for " + std::to_string(numberOfInputPoints) + " points.");
  }
  if (components != 1 && components != 3 && components != 6 && components != 9)
  {
    return Status::invalid(nameOfMetric(array) + " has " + std::to_string(components) +
      " components; a metric has 9, 6, 3 (in the plane) or 1 (a size).");
  }
  const auto [low, high] = std::minmax_element(mesh.points.begin(), mesh.points.end(),
    [](const Point3& a, const Point3& b) { return a[2] < b[2]; });
  if (components == 3 && (*high)[2] - (*low)[2] > flatness * boundingBoxDiagonal(mesh))
  {
    return Status::invalid(nameOfMetric(array) +
      " has 3 components, a metric of the plane, but the surface is not in a plane of equal z.");
  }
  return Status::success();
}
}

Status readMetric(const SurfaceMesh& mesh, const PointArray& array, TensorOrder order,
  Offset numberOfInputPoints, MetricField& metric)
{
  if (Status status = checkArray(mesh, array, numberOfInputPoints); !status.ok())
  {
    return status;
  }
  const Places places = placesOf(array.dimension, order);
  metric.normals = pointNormals(mesh);
  metric.tensors.resize(mesh.points.size());
  Offset first = numberOfInputPoints;
  std::string fault;
  for (Index facet = 0; facet < mesh.numberOfFacets(); ++facet)
  {
    const auto inputs = mesh.facetInputPoints[facet];
    for (int k = 0; k < 3; ++k)
    {
      const Index point = mesh.facetPoints[facet][k];
      metric.tensors[point] = tensorOf(array, places, inputs[k]);
      const std::string wrong =
        inputs[k] < first ? faultOf(metric.tensors[point], metric.normals[point]) : "";
      if (!wrong.empty())
      {
        first = inputs[k];
        fault = wrong;
      }
    }
  }
  return fault.empty() ? Status::success()
                       : Status::invalid(nameOfMetric(array) + " " + fault + " at point " +
                           std::to_string(first) + ".");
}

MetricFit fitOf(const MetricSurface& surface)
{
  const std::vector<TargetShape>& shapes = surface.shapes;
  const std::vector<std::array<float, 2>>& stretches = surface.embedding.stretches;
  MetricFit fit;
  double area = 0.0;
  double within = 0.0;
  for (std::size_t f = 0; f < shapes.size(); ++f)
  {
    area += shapes[f].area();
    const bool isNear = shapes[f].variation <= maxVariation && stretches[f][0] >= std::sqrt(0.5) &&
      stretches[f][1] <= std::sqrt(2.0);
    within += isNear ? shapes[f].area() : 0.0;
  }
  fit.within = (area > 0.0 ? within / area : 1.0) * (1.0 - surface.coarseShare);
  fit.unit = surface.unit;
  for (const float limit : surface.limits)
  {
    fit.limit = std::max(fit.limit, static_cast<double>(limit));
  }
  return fit;
}

void tellFit(const MetricFit& fit, std::vector<std::string>& warnings)
{
  if (fit.within < minShareWithin)
  {
    std::ostringstream warning;
    warning.precision(2);
    warning << "The metric is met on " << 100.0 * fit.within
            << " % of the surface only: elsewhere it turns or grows faster than the surface's "
               "triangles, or straight edges, can follow. Smaller triangles of the surface, or a "
               "metric that changes more gradually, help.";
    warnings.push_back(warning.str());
  }
}

std::vector<std::array<double, 2>> stretchQuantiles(
  const MetricSurface& surface, const std::vector<double>& shares)
{
  const double area = metricArea(surface.shapes);
  std::vector<std::array<double, 2>> quantiles(shares.size(), { 1.0, 1.0 });
  std::vector<std::pair<float, double>> values(surface.shapes.size());
  for (int k = 0; k < 2; ++k)
  {
    for (std::size_t f = 0; f < values.size(); ++f)
    {
      values[f] = { surface.embedding.stretches[f][k], surface.shapes[f].area() };
    }
    std::sort(values.begin(), values.end());
    for (std::size_t q = 0; q < shares.size(); ++q)
    {
      double sum = 0.0;
      const auto found = std::find_if(values.begin(), values.end(),
        [&](const auto& value) { return (sum += value.second) >= shares[q] * area; });
      quantiles[q][k] = found == values.end() ? values.back().first : found->first;
    }
  }
  return quantiles;
}

CornerCoordinates metricCoordinates(const SurfaceMesh& mesh, const MetricSurface& surface)
{
  const Rows& places = surface.embedding.places;
  const Offset dimension = places.cols();
  CornerCoordinates coordinates;
  coordinates.dimension = static_cast<int>(dimension);
  coordinates.values.resize(static_cast<std::size_t>(mesh.numberOfCorners() * dimension));
  for (Index corner = 0; corner < mesh.numberOfCorners(); ++corner)
  {
    const double* row = places.row(mesh.cornerPoints[corner]).data();
    std::copy_n(row, dimension, coordinates.values.begin() + Offset(corner) * dimension);
  }
  return coordinates;
}
}
