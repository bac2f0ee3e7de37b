/**
 * @file TestIntersections.h
 * @brief Pairs of a mesh's triangles that cut each other.
 */
#ifndef TestIntersections_h
#define TestIntersections_h

#include "TestMeasures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace remesh::test
{
using Corners = std::array<Point3, 3>;

/** Six times the volume of a tetrahedron. */
inline double volumeBetween(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  return (b - a).cross(c - a).dot(d - a);
}

/** Whether a segment passes through the inside of a triangle, and not within its plane. */
inline bool pierces(const Point3& p, const Point3& q, const Corners& t)
{
  constexpr double rounding = 1e-14; // of volumes on surfaces of about unit size
  const double above = volumeBetween(t[0], t[1], t[2], p);
  const double below = volumeBetween(t[0], t[1], t[2], q);
  if (!(above * below < 0.0) || std::min(std::abs(above), std::abs(below)) < rounding)
  {
    return false;
  }
  const double u = volumeBetween(p, q, t[0], t[1]);
  const double v = volumeBetween(p, q, t[1], t[2]);
  const double w = volumeBetween(p, q, t[2], t[0]);
  return (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
}

/** Whether an edge of one triangle that does not end in a common point pierces the other. */
inline bool cuts(const std::vector<vtkIdType>& a, const Corners& of,
  const std::vector<vtkIdType>& b, const Corners& other)
{
  const auto isCommon = [&](vtkIdType id) { return std::find(b.begin(), b.end(), id) != b.end(); };
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    if (!isCommon(a[k]) && !isCommon(a[next]) && pierces(of[k], of[next], other))
    {
      return true;
    }
  }
  return false;
}

/** Pairs of triangles of which one is pierced by the other. O(T^2). */
inline vtkIdType numberOfSelfIntersections(vtkPolyData* mesh)
{
  std::vector<std::vector<vtkIdType>> triangles;
  std::vector<Corners> corners;
  std::vector<Eigen::AlignedBox3d> boxes;
  forEachPolygon(mesh,
    [&](vtkIdType, const std::vector<vtkIdType>& ids)
    {
      triangles.push_back(ids);
      corners.push_back({ pointOf(mesh, ids[0]), pointOf(mesh, ids[1]), pointOf(mesh, ids[2]) });
      boxes.emplace_back(corners.back()[0]);
      boxes.back().extend(corners.back()[1]).extend(corners.back()[2]);
    });
  vtkIdType count = 0;
  for (std::size_t a = 0; a < triangles.size(); ++a)
  {
    for (std::size_t b = a + 1; b < triangles.size(); ++b)
    {
      count += boxes[a].intersects(boxes[b]) &&
        (cuts(triangles[a], corners[a], triangles[b], corners[b]) ||
          cuts(triangles[b], corners[b], triangles[a], corners[a]));
    }
  }
  return count;
}
}

#endif
