#include "Preparation/CornerArrays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace remesh
{
namespace
{
std::string nameOf(const PointArray& array)
{
  return "The point array \"" + array.name + "\"";
}

Status checkTuples(const PointArray& array, Offset numberOfInputPoints)
{
  if (array.count == numberOfInputPoints)
  {
    return Status::success();
  }
  return Status::invalid(nameOf(array) + " has " + std::to_string(array.count) + " tuples for " +
    std::to_string(numberOfInputPoints) + " points.");
}

bool isFinite(double value)
{
  return std::isfinite(value);
}

/** The distinct pairs (corner, input point), sorted. */
std::vector<std::pair<Index, Offset>> inputPointsOfCorners(const SurfaceMesh& mesh)
{
  std::vector<std::pair<Index, Offset>> pairs;
  pairs.reserve(3 * mesh.facetCorners.size());
  for (std::size_t f = 0; f < mesh.facetCorners.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      pairs.emplace_back(mesh.facetCorners[f][k], mesh.facetInputPoints[f][k]);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/** Columns of zeros, behind those that there are. */
void addColumns(std::size_t corners, int count, CornerCoordinates& coordinates)
{
  if (coordinates.dimension > 0)
  {
    widenCoordinates(coordinates, count);
    return;
  }
  coordinates.dimension = count;
  coordinates.values.assign(corners * static_cast<std::size_t>(count), 0.0);
}
}

Status appendCornerArray(const SurfaceMesh& mesh, const PointArray& array, double scale,
  Offset numberOfInputPoints, CornerCoordinates& coordinates)
{
  if (Status status = checkTuples(array, numberOfInputPoints); !status.ok())
  {
    return status;
  }
  const int size = array.dimension;
  const int before = coordinates.dimension;
  const auto corners = static_cast<std::size_t>(mesh.numberOfCorners());
  addColumns(corners, size, coordinates);
  const auto rowOf = [&](std::size_t corner)
  {
    return coordinates.values.data() + corner * static_cast<std::size_t>(coordinates.dimension) +
      before;
  };
  std::vector<double> tuple(static_cast<std::size_t>(size));
  std::vector<Index> counts(corners, 0);
  for (const auto& [corner, point] : inputPointsOfCorners(mesh))
  {
    array.read(point, tuple.data());
    ++counts[corner];
    double* mean = rowOf(static_cast<std::size_t>(corner));
    for (int c = 0; c < size; ++c)
    {
      if (!std::isfinite(tuple[c]))
      {
        return Status::invalid(nameOf(array) +
          " has a value that is not a finite number at point " + std::to_string(point) + ".");
      }
      // A running mean: exact where all values are equal.
      mean[c] += (tuple[c] - mean[c]) / counts[corner];
    }
  }
  for (std::size_t corner = 0; corner < corners; ++corner)
  {
    double* row = rowOf(corner);
    std::transform(row, row + size, row, [scale](double value) { return scale * value; });
  }
  return Status::success();
}

bool lendCornerArrays(const SurfaceMesh& mesh,
  const std::vector<std::pair<PointArray, double>>& arrays, Offset numberOfInputPoints,
  int minDimension, CornerCoordinates& coordinates)
{
  std::vector<LentArray> lent;
  int total = coordinates.dimension;
  for (const auto& [array, scale] : arrays)
  {
    if (!(array.doubles || array.floats) || array.count != numberOfInputPoints)
    {
      return false;
    }
    lent.push_back({ array.doubles, array.floats, array.dimension, scale });
    total += array.dimension;
  }
  if (lent.empty() || total < minDimension)
  {
    return false;
  }
  std::vector<Offset> rows(static_cast<std::size_t>(mesh.numberOfCorners()), -1);
  std::vector<double> values;
  std::vector<double> others;
  for (const auto& [corner, point] : inputPointsOfCorners(mesh))
  {
    rows[corner] = rows[corner] < 0 ? point : rows[corner];
    for (const auto& each : arrays)
    {
      const PointArray& array = each.first;
      values.resize(static_cast<std::size_t>(array.dimension));
      others.resize(values.size());
      array.read(point, values.data());
      array.read(rows[corner], others.data());
      if (values != others || !std::all_of(values.begin(), values.end(), isFinite))
      {
        return false;
      }
    }
  }
  coordinates.dimension = total;
  coordinates.lent = std::move(lent);
  coordinates.rows = std::move(rows);
  return true;
}

Status readFacetDensities(const SurfaceMesh& mesh, const PointArray& array,
  Offset numberOfInputPoints, std::vector<double>& densities)
{
  constexpr double largestRatio = 1e40; // of spacings: 1e10
  if (Status status = checkTuples(array, numberOfInputPoints); !status.ok())
  {
    return status;
  }
  if (array.dimension != 1)
  {
    return Status::invalid(
      nameOf(array) + " has " + std::to_string(array.dimension) + " components; a density has 1.");
  }
  double least = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  densities.assign(mesh.facetInputPoints.size(), 0.0);
  for (std::size_t f = 0; f < densities.size(); ++f)
  {
    for (const Offset point : mesh.facetInputPoints[f])
    {
      const double density = array.value(point);
      if (!(density > 0.0) || !std::isfinite(density))
      {
        return Status::invalid(nameOf(array) + ", chosen as the density, has a value at point " +
          std::to_string(point) + " that is not a finite number above 0.");
      }
      least = std::min(least, density);
      largest = std::max(largest, density);
      densities[f] += density / 3.0;
    }
  }
  return largest / least <= largestRatio
    ? Status::success()
    : Status::invalid(nameOf(array) +
        ", chosen as the density, has values more than 1e40 times "
        "another.");
}

std::vector<double> densitiesOf(
  const SurfaceMesh& mesh, const FacetOrigins& origins, const PointArray& array)
{
  constexpr double middle[3] = { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 };
  std::vector<double> densities;
  densities.reserve(origins.size());
  for (std::size_t f = 0; f < origins.size(); ++f)
  {
    const FacetOrigin origin = origins[f];
    const std::array<double, 3> place = origin.place(middle);
    const std::array<Offset, 3> points = mesh.facetInputPoints[origin.facet];
    double& density = densities.emplace_back(0.0);
    for (int k = 0; k < 3; ++k)
    {
      density += place[k] * array.value(points[k]);
    }
  }
  return densities;
}

Status readNormals(
  const PointArray& array, Offset numberOfInputPoints, std::vector<Point3>& normals)
{
  if (Status status = checkTuples(array, numberOfInputPoints); !status.ok())
  {
    return status;
  }
  if (array.dimension != 3)
  {
    return Status::invalid(
      nameOf(array) + " has " + std::to_string(array.dimension) + " components; normals have 3.");
  }
  normals.resize(static_cast<std::size_t>(numberOfInputPoints));
  for (Offset point = 0; point < numberOfInputPoints; ++point)
  {
    array.read(point, normals[point].data());
  }
  return Status::success();
}
}
