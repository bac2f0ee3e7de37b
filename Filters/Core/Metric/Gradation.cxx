#include "Metric/Gradation.h"

#include "Support/Grouping.h"

#include <atomic>
#include <cmath>

namespace remesh
{
namespace
{
constexpr int maxRounds = 60;
constexpr double slack = 1.01; // of squares of sizes: what is nearer to its limit is left alone

/** The tensor of a point, and what its neighbours limit it to; 1 where they do. */
bool limitAt(const SurfaceMesh& mesh, const MetricField& metric, const GradationLimits& limits,
  Index point, Index other, Tensor2& own)
{
  const TangentFrame frame = TangentFrame::across(metric.normals[point]);
  const Tensor2 there = frame.turnedTo(metric.normals[other]).within(metric.tensors[other]);
  const Point3 edge = mesh.points[other] - mesh.points[point];
  const double x = edge.dot(frame.x);
  const double y = edge.dot(frame.y);
  // The longer of both: neighbours are near, and what is short here is not what limits.
  const double length = std::sqrt(std::max(own.squared(x, y), there.squared(x, y))) / limits.unit;
  const Tensor2 grown = there * std::pow(limits.growth, -2.0 * length);
  if (!(relativeSizes(own, grown).max > slack))
  {
    return false;
  }
  own = intersection(own, grown);
  return true;
}
}

bool limitGrowth(const SurfaceMesh& mesh, const EdgeTable& edges, const GradationLimits& limits,
  const RunControl& control, MetricField& metric)
{
  std::vector<std::pair<Index, Index>> ends(static_cast<std::size_t>(edges.numberOfEdges()));
  for (std::size_t f = 0; f < edges.facetEdges.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      ends[edges.facetEdges[f][k]] = { mesh.facetPoints[f][k], mesh.facetPoints[f][(k + 1) % 3] };
    }
  }
  const auto count = static_cast<Offset>(ends.size());
  const auto pointOf = [&](Offset item)
  { return item % 2 == 0 ? ends[item / 2].first : ends[item / 2].second; };
  Groups around; // of each point: 2 edge + which end it is
  bool done = groupByKey(2 * count, mesh.numberOfPoints(), control, pointOf, around);
  std::atomic<bool> any = true;
  std::vector<Eigen::Matrix3d> next = metric.tensors;
  std::vector<char> wasLimited(mesh.points.size(), 1);
  std::vector<char> isLimited(mesh.points.size(), 0);
  const auto limit = [&](Offset point)
  {
    const TangentFrame frame = TangentFrame::across(metric.normals[point]);
    Tensor2 own = frame.within(metric.tensors[point]);
    bool changes = false;
    for (Offset i = around.begins[point]; i < around.begins[point + 1]; ++i)
    {
      const auto& [first, second] = ends[around.items[i] / 2];
      const Index other = around.items[i] % 2 == 0 ? second : first;
      changes |=
        wasLimited[other] && limitAt(mesh, metric, limits, static_cast<Index>(point), other, own);
    }
    isLimited[point] = changes;
    next[point] = changes ? frame.tensorOf(own, 0.5 * (own.xx + own.yy)) : metric.tensors[point];
    if (changes)
    {
      any.store(true, std::memory_order_relaxed);
    }
  };
  for (int round = 0; round < maxRounds && any && done; ++round)
  {
    any = false;
    done = forEachItem(mesh.numberOfPoints(), control, limit);
    metric.tensors.swap(next);
    wasLimited.swap(isLimited);
  }
  return done;
}
}
