/**
 * @file TestUnitShare.h
 * @brief How many edges of a mesh have the length that a metric wants.
 */
#ifndef TestUnitShare_h
#define TestUnitShare_h

#include "TestHelpers.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace remesh::test
{
using Tensor = std::function<Eigen::Matrix3d(const Point3&)>;

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
