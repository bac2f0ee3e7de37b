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
/** Of sizes over one unit, where the metric bends more than straight edges can. */
constexpr double growthInBends = 2.0;
constexpr float leastBend = 3.0F;  // that has an effect
constexpr double bendDecay = 2.0;  // of bends over one unit
constexpr double bendSlack = 1.02; // of bends, as of sizes

/** Points that are joined by an edge. */
struct Neighbours
{
  std::vector<std::pair<Index, Index>> ends; ///< E
  Groups around;                             ///< of each point: 2 edge + which end it is

  bool find(const SurfaceMesh& mesh, const EdgeTable& edges, const RunControl& control)
  {
    this->ends.resize(static_cast<std::size_t>(edges.numberOfEdges()));
    for (std::size_t f = 0; f < edges.facetEdges.size(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->ends[edges.facetEdges[f][k]] = { mesh.facetPoints[f][k],
          mesh.facetPoints[f][(k + 1) % 3] };
      }
    }
    const auto pointOf = [&](Offset item)
    { return item % 2 == 0 ? this->ends[item / 2].first : this->ends[item / 2].second; };
    return groupByKey(2 * static_cast<Offset>(this->ends.size()), mesh.numberOfPoints(), control,
      pointOf, this->around);
  }

  Index other(Offset item) const
  {
    const auto& [first, second] = this->ends[item / 2];
    return item % 2 == 0 ? second : first;
  }
};

/** What is limited at a point. */
struct State
{
  Tensor2 tensor;
  float bend = 1.0F;
  bool isLimited = false; ///< in this round
};

class Rounds
{
public:
  Rounds(const SurfaceMesh& mesh, const GradationLimits& limits, MetricField& metric)
    : m_mesh(mesh)
    , m_limits(limits)
    , m_metric(metric)
    , m_next(metric.tensors)
    , m_bends(limits.bends)
    , m_wasLimited(mesh.points.size(), 1)
    , m_isLimited(mesh.points.size(), 0)
  {
    m_bends.resize(mesh.points.size(), 1.0F);
    for (float& bend : m_bends)
    {
      bend = bend < leastBend ? 1.0F : bend;
    }
    m_nextBends = m_bends;
  }

  bool run(const Neighbours& neighbours, const RunControl& control)
  {
    const auto limit = [&](Offset point)
    { this->limitPoint(neighbours, static_cast<Index>(point)); };
    bool done = true;
    for (int round = 0; round < maxRounds && m_any && done; ++round)
    {
      m_any = false;
      done = forEachItem(m_mesh.numberOfPoints(), control, limit);
      m_metric.tensors.swap(m_next);
      m_bends.swap(m_nextBends);
      m_wasLimited.swap(m_isLimited);
    }
    return done;
  }

private:
  void limitPoint(const Neighbours& neighbours, Index point)
  {
    const TangentFrame frame = TangentFrame::across(m_metric.normals[point]);
    State own{ frame.within(m_metric.tensors[point]), m_bends[point] };
    bool changes = false;
    for (Offset i = neighbours.around.begins[point]; i < neighbours.around.begins[point + 1]; ++i)
    {
      const Index other = neighbours.other(neighbours.around.items[i]);
      if (m_wasLimited[other])
      {
        changes |= this->limitBy(point, other, frame, own);
      }
    }
    const Tensor2& tensor = own.tensor;
    m_next[point] = own.isLimited ? frame.tensorOf(tensor, 0.5 * (tensor.xx + tensor.yy))
                                  : m_metric.tensors[point];
    m_nextBends[point] = own.bend;
    m_isLimited[point] = changes;
    if (changes)
    {
      m_any.store(true, std::memory_order_relaxed);
    }
  }

  /** What one neighbour limits; whether it does. */
  bool limitBy(Index point, Index other, const TangentFrame& frame, State& own) const
  {
    const Tensor2 there = frame.turnedTo(m_metric.normals[other]).within(m_metric.tensors[other]);
    const Point3 edge = m_mesh.points[other] - m_mesh.points[point];
    const double x = edge.dot(frame.x);
    const double y = edge.dot(frame.y);
    // The longer of both: neighbours are near, and what is short here is not what limits.
    const double length =
      std::sqrt(std::max(own.tensor.squared(x, y), there.squared(x, y))) / m_limits.unit;
    const double bend = m_bends[other] * std::pow(bendDecay, -length);
    const bool bends = bend > bendSlack * own.bend;
    own.bend = bends ? static_cast<float>(bend) : own.bend;
    const Tensor2 grown = there * std::pow(this->growthAt(other), -2.0 * length);
    if (!(relativeSizes(own.tensor, grown).max > slack))
    {
      return bends;
    }
    own.tensor = intersection(own.tensor, grown);
    own.isLimited = true;
    return true;
  }

  double growthAt(Index point) const
  {
    const double bend = m_bends[point];
    return growthInBends < m_limits.growth
      ? growthInBends + (m_limits.growth - growthInBends) / (bend * bend)
      : m_limits.growth;
  }

  const SurfaceMesh& m_mesh;
  const GradationLimits& m_limits;
  MetricField& m_metric;
  std::vector<Eigen::Matrix3d> m_next;
  std::vector<float> m_bends;
  std::vector<float> m_nextBends;
  std::vector<char> m_wasLimited;
  std::vector<char> m_isLimited;
  std::atomic<bool> m_any = true;
};
}

bool limitGrowth(const SurfaceMesh& mesh, const EdgeTable& edges, const GradationLimits& limits,
  const RunControl& control, MetricField& metric)
{
  Neighbours neighbours;
  return neighbours.find(mesh, edges, control) &&
    Rounds(mesh, limits, metric).run(neighbours, control);
}
}
