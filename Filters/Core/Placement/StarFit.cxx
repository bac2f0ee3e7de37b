#include "Placement/StarFit.h"

#include "Mesh/ClosestPoint.h"
#include "Mesh/FacetGeometry.h"

#include <Eigen/Core>

#include <algorithm>
#include <limits>

namespace remesh
{
namespace
{
constexpr std::size_t trianglesOfVertex = 3; // of a block, at most as a rule

void setRow(const Point3& from, double (&to)[3])
{
  std::copy_n(from.data(), 3, to);
}

Point3 inLane(const float (&columns)[3][lanes], int lane)
{
  return { columns[0][lane], columns[1][lane], columns[2][lane] };
}

int cornerOf(Index vertex, const Triple& triangle)
{
  return triangle[0] == vertex ? 0 : triangle[1] == vertex ? 1 : 2;
}
}

void StarFit::sum(FitSamples& samples, Offset number, StarBlock& block)
{
  for (const Index triangle : m_entered) // of the last block
  {
    m_slots[triangle] = noIndex;
  }
  m_entered.clear();
  m_normals.clear();
  block.triangles.clear();
  block.sums.clear();
  const SampleBlock& sampled = samples.of(number, m_scratch);
  block.triangles.reserve(trianglesOfVertex * sampled.counts.size());
  block.sums.reserve(trianglesOfVertex * sampled.counts.size());
  const auto first = static_cast<Index>(samples.blocks().begin(number));
  for (std::size_t v = 0; v < sampled.counts.size(); ++v)
  {
    this->enter(first + static_cast<Index>(v), block);
    const SampleGroup* groups = sampled.groups.data() + sampled.begins[v];
    m_others.resize(static_cast<std::size_t>(sampled.counts[v]));
    const Point3 shift = m_problem.components.centroids[m_center] - m_positions[m_center];
    const Index others = m_sum({ m_star, groups, samples.unit(), sampled.counts[v], shift.data(),
      block.sums.data(), m_others.data() });
    for (Index k = 0; k < others; ++k)
    {
      this->addClosest(groups[m_others[k] / lanes], m_others[k] % lanes, samples.unit(), block);
    }
  }
}

/** The triangle's slot in the block; noIndex without area. */
Index StarFit::slotOf(Index triangle, StarBlock& block)
{
  if (m_slots[triangle] != noIndex)
  {
    return m_slots[triangle];
  }
  const auto& [i, j, k] = m_problem.triangles[triangle];
  const Point3 normal = facetNormal(m_positions[i], m_positions[j], m_positions[k]);
  if (normal.isZero(0.0))
  {
    return noIndex;
  }
  m_entered.push_back(triangle); // first, in case that memory runs out
  m_normals.push_back(normal);
  block.triangles.push_back(triangle);
  block.sums.emplace_back();
  m_slots[triangle] = static_cast<Index>(block.sums.size() - 1);
  return m_slots[triangle];
}

void StarFit::enter(Index vertex, StarBlock& block)
{
  m_center = vertex;
  m_star.clear();
  for (Offset k = m_stars.begin(vertex); k < m_stars.end(vertex); ++k)
  {
    const Index t = m_stars.triangles[k];
    const Index slot = this->slotOf(t, block);
    if (slot == noIndex)
    {
      continue;
    }
    const Triple& corners = m_problem.triangles[t];
    StarTriangle& triangle = m_star.emplace_back(StarTriangle{});
    triangle.sums = slot;
    triangle.corner = cornerOf(vertex, corners);
    const Point3 u = m_positions[corners[(triangle.corner + 1) % 3]] - m_positions[vertex];
    const Point3 v = m_positions[corners[(triangle.corner + 2) % 3]] - m_positions[vertex];
    const double uu = u.squaredNorm();
    const double uv = u.dot(v);
    const double vv = v.squaredNorm();
    const double determinant = uu * vv - uv * uv;
    if (determinant > 0.0)
    {
      setRow((vv * u - uv * v) / determinant, triangle.first);
      setRow((uu * v - uv * u) / determinant, triangle.second);
      setRow(m_normals[slot], triangle.normal);
    }
  }
}

void StarFit::addClosest(const SampleGroup& group, int lane, double unit, StarBlock& block) const
{
  const Point3 point = m_problem.components.centroids[m_center] + unit * inLane(group.offset, lane);
  const Point3 normal = inLane(group.normal, lane);
  double nearest = std::numeric_limits<double>::infinity();
  ClosestPoint foot{};
  Index at = noIndex;
  for (const StarTriangle& star : m_star)
  {
    const Index t = block.triangles[star.sums];
    if (!(m_normals[star.sums].dot(normal) > 0.0))
    {
      continue;
    }
    const auto& [i, j, k] = m_problem.triangles[t];
    const ClosestPoint closest =
      closestOnTriangle(point, m_positions[i], m_positions[j], m_positions[k]);
    if (closest.squared < nearest)
    {
      nearest = closest.squared;
      foot = closest;
      at = star.sums;
    }
  }
  if (at != noIndex)
  {
    const auto& [i, j, k] = m_problem.triangles[block.triangles[at]];
    const Point3 place =
      foot.b[0] * m_positions[i] + foot.b[1] * m_positions[j] + foot.b[2] * m_positions[k];
    addSample(normal.data(), group.weight[lane], foot.b, normal.dot(point - place), block.sums[at]);
  }
}
}
