#include "Adaptors/SolutionMetricInput.h"

#include "Adaptors/PointArrays.h"
#include "Mesh/Extent.h"

#include "vtkDataArray.h"

#include <cmath>
#include <sstream>

namespace remesh
{
namespace
{
using Tensors = std::vector<Symmetric3<double>>;

/** For 9 components, or 6 or 3 of an order: which entry of Symmetric3 each is; -1: none. */
std::vector<int> entriesOf(int components, TensorOrder order)
{
  if (components == 9)
  {
    return { 0, 1, 2, -1, 3, 4, -1, -1, 5 };
  }
  if (components == 6)
  {
    return order == TensorOrder::Rows ? std::vector<int>{ 0, 1, 2, 3, 4, 5 }
      : order == TensorOrder::Sol     ? std::vector<int>{ 0, 1, 3, 2, 4, 5 }
                                      : std::vector<int>{ 0, 3, 5, 1, 4, 2 };
  }
  if (components == 3)
  {
    return order == TensorOrder::Vtk ? std::vector<int>{ 0, 3, 1 } : std::vector<int>{ 0, 1, 3 };
  }
  return {};
}

Status readSolutions(
  const FieldSurface& surface, const SolutionMetricArrays& arrays, SolutionMetricInput& input)
{
  std::vector<vtkDataArray*> found;
  Offset columns = 0;
  for (const std::string& name : arrays.solutions)
  {
    vtkDataArray* array = nullptr;
    if (Status status = findNamedArray(surface, name, "a solution", array); !status.ok())
    {
      return status;
    }
    found.push_back(array);
    input.components.push_back(array->GetNumberOfComponents());
    columns += array->GetNumberOfComponents();
  }
  input.values.resize(surface.mesh.numberOfPoints(), columns);
  Offset first = 0;
  for (vtkDataArray* array : found)
  {
    Status status = readValues(surface, array,
      [&](Index point, int component, double value)
      { input.values(point, first + component) = value; });
    if (!status.ok())
    {
      return status;
    }
    first += array->GetNumberOfComponents();
  }
  return Status::success();
}

Status readHessian(
  const FieldSurface& surface, const std::string& name, TensorOrder order, Tensors& tensors)
{
  vtkDataArray* array = nullptr;
  if (Status status = findNamedArray(surface, name, "a Hessian", array); !status.ok())
  {
    return status;
  }
  const std::vector<int> entries = entriesOf(array->GetNumberOfComponents(), order);
  if (entries.empty())
  {
    return Status::invalid("The point array \"" + name + "\" has " +
      std::to_string(array->GetNumberOfComponents()) +
      " components; a Hessian has 9, 6 or 3 (in the plane).");
  }
  tensors.assign(surface.mesh.points.size(), Symmetric3<double>::Zero());
  return readValues(surface, array,
    [&](Index point, int component, double value)
    {
      if (entries[component] >= 0)
      {
        tensors[point][entries[component]] = value;
      }
    });
}

Status readMetricToMeet(
  const FieldSurface& surface, const std::string& name, TensorOrder order, Tensors& tensors)
{
  vtkDataArray* array = nullptr;
  if (Status status = findNamedArray(surface, name, "a metric", array); !status.ok())
  {
    return status;
  }
  MetricField field;
  Status status =
    readMetric(surface.mesh, *lentArray(array), order, surface.input->GetNumberOfPoints(), field);
  for (const Eigen::Matrix3d& tensor : field.tensors)
  {
    tensors.push_back(symmetricOf(tensor));
  }
  return status;
}

Status readSizes(
  const FieldSurface& surface, const SolutionMetricArrays& arrays, std::vector<double>& sizes)
{
  if (arrays.distance.empty())
  {
    return Status::success();
  }
  vtkDataArray* array = nullptr;
  if (Status status = findNamedArray(surface, arrays.distance, "the distance", array); !status.ok())
  {
    return status;
  }
  if (array->GetNumberOfComponents() != 1)
  {
    return Status::invalid("The point array \"" + arrays.distance + "\" has " +
      std::to_string(array->GetNumberOfComponents()) + " components; a distance has 1.");
  }
  sizes.resize(surface.mesh.points.size());
  return readValues(surface, array,
    [&](Index point, int, double value)
    { sizes[point] = arrays.distanceSize + arrays.distanceGrowth * std::abs(value); });
}

void warn(const SolutionMetricOptions& options, const SolutionMetric& metric,
  const SolutionMetricArrays& arrays, FieldSurface& surface)
{
  if (arrays.solutions.empty() && arrays.hessians.empty())
  {
    return;
  }
  constexpr double missing = 0.99;
  std::ostringstream text;
  if (metric.isConstant)
  {
    text << "The solutions do not bend anywhere: they ask for no points.";
  }
  else if (metric.minPoints >= options.numberOfPoints)
  {
    text << "Largest size, curvature, metrics and distance ask for "
         << std::llround(metric.minPoints) << " points, of " << std::llround(options.numberOfPoints)
         << " that all may ask for: the solutions get none. More points, or larger sizes, help.";
  }
  else if (metric.points < missing * options.numberOfPoints)
  {
    text << "The metric asks for " << std::llround(metric.points) << " points instead of "
         << std::llround(options.numberOfPoints) << ": the smallest size allows for no more.";
  }
  if (!text.str().empty())
  {
    surface.warnings.push_back(text.str());
  }
}
}

Status readSolutionMetricInput(
  const FieldSurface& surface, const SolutionMetricArrays& arrays, SolutionMetricInput& input)
{
  Status status = readSolutions(surface, arrays, input);
  for (std::size_t k = 0; k < arrays.hessians.size() && status.ok(); ++k)
  {
    status = readHessian(surface, arrays.hessians[k], arrays.order, input.hessians.emplace_back());
  }
  for (std::size_t k = 0; k < arrays.metrics.size() && status.ok(); ++k)
  {
    status =
      readMetricToMeet(surface, arrays.metrics[k], arrays.order, input.metrics.emplace_back());
  }
  return status.ok() ? readSizes(surface, arrays, input.sizes) : status;
}

Status addSolutionMetric(
  FieldSurface& surface, const SolutionMetricArrays& arrays, const SolutionMetricOptions& options)
{
  SolutionMetricInput input;
  SolutionMetric metric;
  Status status = readSolutionMetricInput(surface, arrays, input);
  if (status.ok())
  {
    status = makeSolutionMetric(surface.mesh, input, options, surface.control, metric);
  }
  if (!status.ok())
  {
    return status;
  }
  const double largest =
    options.maximumSize > 0.0 ? options.maximumSize : boundingBoxDiagonal(surface.mesh);
  const double least = 1.0 / (largest * largest);
  Symmetric3<double> loose;
  loose << least, 0.0, 0.0, least, 0.0, least;
  addPointField(surface, "Metric", 6,
    [&](Index point, double* tuple)
    {
      const Symmetric3<double>& m = point == noIndex ? loose : metric.tensors[point];
      const double entries[6] = { m[0], m[3], m[5], m[1], m[4], m[2] };
      std::copy_n(entries, 6, tuple);
    });
  addFact(surface, "MetricPoints", metric.points);
  warn(options, metric, arrays, surface);
  return surface.control.cancelled() ? Status::cancelled() : Status::success();
}
}
