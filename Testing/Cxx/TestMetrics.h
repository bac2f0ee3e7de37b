/**
 * @file TestMetrics.h
 * @brief Surfaces with a metric, and how many edges of a mesh have the length that it wants.
 */
#ifndef TestMetrics_h
#define TestMetrics_h

#include "TestBytes.h"

#include "vtkMetricEmbedding.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace remesh::test
{
/** The tensor at a place. */
using Tensor = std::function<Eigen::Matrix3d(const Point3&)>;

/** Adds the tensors as 9 components. */
inline void addMetric(vtkPolyData* input, const Tensor& tensor, const char* name = "Metric")
{
  addPointArray<vtkDoubleArray>(input, name, 9,
    [&](const Point3& p, int component) { return tensor(p)(component / 3, component % 3); });
}

/** A tube of radius 1 and height 2, open, of so many quadrilaterals around and along. */
inline vtkSmartPointer<vtkPolyData> tube(int around, int along)
{
  TriangleSoup soup = gridPatch(around, along);
  for (Point3& p : soup.points)
  {
    const double angle = 2.0 * pi * (p[0] == 1.0 ? 0.0 : p[0]);
    p = { std::cos(angle), std::sin(angle), 2.0 * p[1] };
  }
  return polyDataOf(soup);
}

inline vtkSmartPointer<vtkMetricEmbedding> embeddingOf(vtkDataObject* input, vtkIdType points)
{
  auto filter = vtkSmartPointer<vtkMetricEmbedding>::New();
  filter->SetInputDataObject(input);
  filter->SetMetricArray("Metric");
  filter->SetNumberOfPoints(points);
  return filter;
}

/** The share of edges whose length in the metric is within a factor of sqrt 2 of the mean. */
inline double unitShare(vtkPolyData* mesh, const Tensor& tensor)
{
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  forEachSide(mesh, [&](vtkIdType p, vtkIdType q) { edges.insert(std::minmax(p, q)); });
  std::vector<double> logarithms;
  double sum = 0.0;
  for (const auto& [p, q] : edges)
  {
    const Point3 start = pointOf(mesh, p);
    const Point3 edge = pointOf(mesh, q) - start;
    double length = 0.0;
    constexpr int steps = 8;
    for (int k = 0; k < steps; ++k)
    {
      const Point3 middle = start + (k + 0.5) / steps * edge;
      length += std::sqrt(edge.dot(tensor(middle) * edge)) / steps;
    }
    logarithms.push_back(std::log(length));
    sum += logarithms.back();
  }
  const double mean = sum / static_cast<double>(edges.size());
  const auto within = std::count_if(logarithms.begin(), logarithms.end(),
    [&](double length) { return std::abs(length - mean) < 0.5 * std::log(2.0); });
  return static_cast<double>(within) / static_cast<double>(edges.size());
}
}

#endif
