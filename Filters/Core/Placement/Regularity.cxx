#include "Placement/Regularity.h"

#include <Eigen/Geometry>

#include <cmath>

namespace remesh
{
namespace
{
constexpr int halvingsOfShare = 5; // of the share

struct Lengths
{
  std::array<double, 3> edges{}; ///< opposite to corner 2, 0, 1; 0 between fixed vertices
  bool isWhole = true;           ///< none is 0
};

Lengths lengthsOf(const PlacementProblem& problem, const CellForms& cells, const Triple& triangle,
  const std::vector<Point3>& positions)
{
  Lengths lengths;
  for (int k = 0; k < 3; ++k)
  {
    Symmetric3<double> metric = Symmetric3<double>::Zero();
    double ends = 0.0;
    for (const Index end : { triangle[k], triangle[(k + 1) % 3] })
    {
      if (!problem.isFixed(static_cast<std::size_t>(end))) // a fixed one's cell bends
      {
        metric += cells.metrics[end];
        ends += 1.0;
      }
    }
    const Point3 edge = positions[triangle[(k + 1) % 3]] - positions[triangle[k]];
    const double squared = ends > 0.0 ? edge.dot(multiply(metric, edge)) / ends : 0.0;
    lengths.edges[k] = std::sqrt(std::max(squared, 0.0));
    lengths.isWhole = lengths.isWhole && squared > 0.0;
  }
  return lengths;
}

/** Twice the inscribed circle's radius over the circumscribed one's; 0: no triangle's lengths. */
double radiusRatio(const std::array<double, 3>& edges)
{
  const auto& [a, b, c] = edges;
  const double product = a * b * c;
  return product > 0.0 ? std::max(0.0, (b + c - a) * (c + a - b) * (a + b - c) / product) : 0.0;
}
}

Regularity regularityOf(
  const PlacementProblem& problem, const CellForms& cells, const std::vector<Point3>& positions)
{
  std::vector<double> all; // inner edges twice
  double length = 0.0;
  double ratios = 0.0;
  double triangles = 0.0;
  for (const Triple& triangle : problem.triangles)
  {
    const Lengths lengths = lengthsOf(problem, cells, triangle, positions);
    for (const double edge : lengths.edges)
    {
      if (edge > 0.0)
      {
        all.push_back(edge);
        length += edge;
      }
    }
    ratios += lengths.isWhole ? radiusRatio(lengths.edges) : 0.0;
    triangles += lengths.isWhole ? 1.0 : 0.0;
  }
  const double mean = length / static_cast<double>(all.size());
  const auto even = std::count_if(all.begin(), all.end(),
    [&](double edge)
    { return 2.0 * edge * edge >= mean * mean && edge * edge <= 2.0 * mean * mean; });
  return { all.empty() ? 1.0 : static_cast<double>(even) / static_cast<double>(all.size()),
    triangles > 0.0 ? ratios / triangles : 1.0 };
}

bool limitSliding(const PlacementProblem& problem, const CellForms& cells, double most,
  const std::vector<Point3>& start, std::vector<Point3>& positions)
{
  const Regularity before = regularityOf(problem, cells, start);
  if (regularityOf(problem, cells, positions).isWithin(most, before))
  {
    return false;
  }
  const std::vector<Point3> goals = positions;
  const auto slideTo = [&](double share)
  {
    for (std::size_t v = 0; v < goals.size(); ++v)
    {
      const Point3 normal = cells.normals[v].stableNormalized();
      const Point3 way = goals[v] - start[v];
      const Point3 across = normal.dot(way) * normal;
      positions[v] = start[v] + across + share * (way - across);
    }
  };
  double reached = 0.0;
  double beyond = 1.0;
  for (int k = 0; k < halvingsOfShare; ++k)
  {
    const double middle = 0.5 * (reached + beyond);
    slideTo(middle);
    const bool isWithin = regularityOf(problem, cells, positions).isWithin(most, before);
    (isWithin ? reached : beyond) = middle;
  }
  slideTo(reached);
  return true;
}
}
