/**
 * @file TriangleShape.h
 * @brief How much a triangle's shape has changed.
 */
#ifndef remesh_TriangleShape_h
#define remesh_TriangleShape_h

#include "Mesh/FacetGeometry.h"
#include "Support/Types.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace remesh
{
using Corners = std::array<Point3, 3>;

/** A triangle laid into the plane: first edge along x. Zero where the corners are collinear. */
struct FlatTriangle
{
  double x1 = 0.0, x2 = 0.0, y2 = 0.0;

  explicit FlatTriangle(const Corners& p)
  {
    const Point3 u = p[1] - p[0];
    const Point3 v = p[2] - p[0];
    this->x1 = u.norm();
    if (this->x1 > 0.0)
    {
      this->x2 = u.dot(v) / this->x1;
      this->y2 = u.cross(v).norm() / this->x1;
    }
  }
};

/** Ratio of the largest to the least stretch of the map between two triangles; 1: similar. */
inline double stretchRatio(const Corners& from, const Corners& to)
{
  const FlatTriangle a(from);
  const FlatTriangle b(to);
  const double determinant = b.x1 * b.y2 / (a.x1 * a.y2);
  if (!(determinant > 0.0) || !std::isfinite(determinant))
  {
    return std::numeric_limits<double>::infinity();
  }
  const double j00 = b.x1 / a.x1;
  const double j01 = (b.x2 - j00 * a.x2) / a.y2;
  const double j11 = b.y2 / a.y2;
  const double mean = (j00 * j00 + j01 * j01 + j11 * j11) / (2.0 * determinant); // (q + 1/q) / 2
  return mean + std::sqrt(std::max(0.0, mean * mean - 1.0));
}

inline Corners cornersOf(const Triple& triangle, const std::vector<Point3>& positions)
{
  return { positions[triangle[0]], positions[triangle[1]], positions[triangle[2]] };
}

inline Eigen::AlignedBox3d boxAround(const Corners& p)
{
  return Eigen::AlignedBox3d(p[0]).extend(p[1]).extend(p[2]);
}

/** T, of length 1; zero without area. */
inline std::vector<Point3> normalsOf(
  const std::vector<Triple>& triangles, const std::vector<Point3>& positions)
{
  std::vector<Point3> normals;
  normals.reserve(triangles.size());
  for (const Triple& triangle : triangles)
  {
    const auto [a, b, c] = cornersOf(triangle, positions);
    normals.push_back(facetNormal(a, b, c));
  }
  return normals;
}
}

#endif
