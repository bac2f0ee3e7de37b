#include "Adaptors/CornerArrays.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace remesh
{
namespace
{
std::string nameOf(vtkDataArray* array)
{
  return std::string("The point array \"") + (array->GetName() ? array->GetName() : "") + "\"";
}

Status checkTuples(vtkDataArray* array, Offset numberOfInputPoints)
{
  if (array->GetNumberOfTuples() == numberOfInputPoints)
  {
    return Status::success();
  }
  return Status::invalid(nameOf(array) + " has " + std::to_string(array->GetNumberOfTuples()) +
    " tuples for " + std::to_string(numberOfInputPoints) + " points.");
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
}

Status readCornerArray(const SurfaceMesh& mesh, vtkDataArray* array, Offset numberOfInputPoints,
  CornerCoordinates& values)
{
  if (Status status = checkTuples(array, numberOfInputPoints); !status.ok())
  {
    return status;
  }
  const int size = array->GetNumberOfComponents();
  values.dimension = size;
  values.values.assign(mesh.cornerPoints.size() * static_cast<std::size_t>(size), 0.0);
  std::vector<double> tuple(static_cast<std::size_t>(size));
  std::vector<Index> counts(mesh.cornerPoints.size(), 0);
  for (const auto& [corner, point] : inputPointsOfCorners(mesh))
  {
    array->GetTuple(point, tuple.data());
    ++counts[corner];
    double* mean = values.values.data() + static_cast<std::size_t>(corner) * size;
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
  return Status::success();
}

Status readNormals(vtkDataArray* array, Offset numberOfInputPoints, std::vector<Point3>& normals)
{
  if (Status status = checkTuples(array, numberOfInputPoints); !status.ok())
  {
    return status;
  }
  if (array->GetNumberOfComponents() != 3)
  {
    return Status::invalid(nameOf(array) + " has " +
      std::to_string(array->GetNumberOfComponents()) + " components; normals have 3.");
  }
  normals.resize(static_cast<std::size_t>(numberOfInputPoints));
  for (Offset point = 0; point < numberOfInputPoints; ++point)
  {
    array->GetTuple(point, normals[point].data());
  }
  return Status::success();
}
}
