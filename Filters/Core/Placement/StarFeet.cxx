#include "Placement/StarFeet.h"

#include "Mesh/ClosestPoint.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
void StarFeet::enter(Index vertex)
{
  m_star.clear();
  for (Offset k = m_stars.begin(vertex); k < m_stars.end(vertex); ++k)
  {
    const Index t = m_stars.triangles[k];
    const auto& [i, j, l] = m_problem.triangles[t];
    const Point3 u = m_positions[j] - m_positions[i];
    const Point3 v = m_positions[l] - m_positions[i];
    const double uu = u.squaredNorm();
    const double uv = u.dot(v);
    const double vv = v.squaredNorm();
    const double determinant = uu * vv - uv * uv;
    if (!m_normals[t].isZero(0.0))
    {
      m_star.push_back({ t, m_positions[i], (vv * u - uv * v) / determinant,
        (uu * v - uv * u) / determinant, m_normals[t] });
    }
  }
}

Foot StarFeet::find(const Point3& point, const Point3& normal) const
{
  Foot foot;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Prepared& own : m_star)
  {
    const Point3 w = point - own.corner;
    const double b1 = own.first.dot(w);
    const double b2 = own.second.dot(w);
    const bool above = b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0;
    if (const double height = std::abs(own.normal.dot(w));
        above && height < nearest && own.normal.dot(normal) > 0.0)
    {
      nearest = height;
      foot = { own.triangle, { 1.0 - b1 - b2, b1, b2 } };
    }
  }
  return foot.triangle == noIndex ? this->findClosest(point, normal) : foot;
}

Foot StarFeet::findClosest(const Point3& point, const Point3& normal) const
{
  Foot foot;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Prepared& own : m_star)
  {
    if (!(own.normal.dot(normal) > 0.0))
    {
      continue;
    }
    const auto& [i, j, l] = m_problem.triangles[own.triangle];
    const ClosestPoint closest =
      closestOnTriangle(point, m_positions[i], m_positions[j], m_positions[l]);
    if (closest.squared < nearest)
    {
      nearest = closest.squared;
      foot.triangle = own.triangle;
      std::copy_n(closest.b, 3, foot.b);
    }
  }
  return foot;
}
}
