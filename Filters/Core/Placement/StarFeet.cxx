#include "Placement/StarFeet.h"

#include "Mesh/ClosestPoint.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace remesh
{
namespace
{
void setLane(double (&columns)[3][lanes], std::size_t lane, const Point3& value)
{
  for (int k = 0; k < 3; ++k)
  {
    columns[k][lane] = value[k];
  }
}

/** The place of a vertex in its triangle. */
int placeOf(Index vertex, const Triple& triangle)
{
  return triangle[0] == vertex ? 0 : triangle[1] == vertex ? 1 : 2;
}
}

void StarFeet::enter(Index vertex)
{
  m_center = vertex;
  m_triangles.clear();
  m_groups.clear();
  for (Offset k = m_stars.begin(vertex); k < m_stars.end(vertex); ++k)
  {
    const Index t = m_stars.triangles[k];
    if (m_normals[t].isZero(0.0))
    {
      continue;
    }
    const std::size_t lane = m_triangles.size() % lanes;
    if (lane == 0)
    {
      m_groups.push_back({});
    }
    m_triangles.push_back(t);
    const Triple& corners = m_problem.triangles[t];
    const int at = placeOf(vertex, corners);
    const Point3 u = m_positions[corners[(at + 1) % 3]] - m_positions[vertex];
    const Point3 v = m_positions[corners[(at + 2) % 3]] - m_positions[vertex];
    const double uu = u.squaredNorm();
    const double uv = u.dot(v);
    const double vv = v.squaredNorm();
    const double determinant = uu * vv - uv * uv;
    if (determinant > 0.0)
    {
      setLane(m_groups.back().first, lane, (vv * u - uv * v) / determinant);
      setLane(m_groups.back().second, lane, (uu * v - uv * u) / determinant);
      setLane(m_groups.back().normal, lane, m_normals[t]);
    }
  }
  m_squared.resize(m_groups.size() * lanes);
}

Foot StarFeet::find(const Point3& point, const Point3& normal)
{
  const Point3 way = point - m_positions[m_center];
  m_evaluate({ m_groups, way.data(), normal.data(), m_squared.data() });
  const auto nearest = std::min_element(m_squared.begin(), m_squared.end());
  return nearest != m_squared.end() && *nearest < std::numeric_limits<double>::infinity()
    ? this->footOn(static_cast<std::size_t>(nearest - m_squared.begin()), way)
    : this->findClosest(point, normal);
}

Foot StarFeet::footOn(std::size_t triangle, const Point3& way) const
{
  const StarGroup& group = m_groups[triangle / lanes];
  const std::size_t lane = triangle % lanes;
  double first = 0.0;
  double second = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    first += group.first[k][lane] * way[k];
    second += group.second[k][lane] * way[k];
  }
  Foot foot;
  foot.triangle = m_triangles[triangle];
  const int at = placeOf(m_center, m_problem.triangles[foot.triangle]);
  foot.b[at] = 1.0 - first - second;
  foot.b[(at + 1) % 3] = first;
  foot.b[(at + 2) % 3] = second;
  return foot;
}

Foot StarFeet::findClosest(const Point3& point, const Point3& normal) const
{
  Foot foot;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Index triangle : m_triangles)
  {
    if (!(m_normals[triangle].dot(normal) > 0.0))
    {
      continue;
    }
    const auto& [i, j, l] = m_problem.triangles[triangle];
    const ClosestPoint closest =
      closestOnTriangle(point, m_positions[i], m_positions[j], m_positions[l]);
    if (closest.squared < nearest)
    {
      nearest = closest.squared;
      foot.triangle = triangle;
      std::copy_n(closest.b, 3, foot.b);
    }
  }
  return foot;
}
}
