/**
 * @file FacetGeometry.h
 * @brief Area and normal of one triangle in R^3, at any scale and for any sliver.
 *
 * All take the cross product at the corner opposite to the longest edge: there both factors are
 * as short as they can be, and the rounding error is least.
 */
#ifndef remesh_FacetGeometry_h
#define remesh_FacetGeometry_h

#include "Mesh/SurfaceMesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace remesh
{
/** The two shorter edges, from their common corner, in the triangle's sense of rotation. */
struct ShortEdges
{
  Point3 first;
  Point3 second;
};

inline ShortEdges shortEdges(const Point3& a, const Point3& b, const Point3& c)
{
  const Point3 ab = b - a;
  const Point3 bc = c - b;
  const Point3 ca = a - c;
  const double ab2 = ab.squaredNorm();
  const double bc2 = bc.squaredNorm();
  const double ca2 = ca.squaredNorm();
  if (bc2 >= ab2 && bc2 >= ca2)
  {
    return { ab, -ca };
  }
  if (ca2 >= ab2)
  {
    return { bc, -ab };
  }
  return { ca, -bc };
}

/** Normal whose length is twice the area. */
inline Point3 doubleAreaVector(const Point3& a, const Point3& b, const Point3& c)
{
  const ShortEdges edges = shortEdges(a, b, c);
  return edges.first.cross(edges.second);
}

/** Of a vector of any size. */
inline double lengthOf(const Point3& v)
{
  const double squared = v.squaredNorm();
  return squared > 1e-290 && squared < 1e290 ? std::sqrt(squared) : v.stableNorm();
}

inline double facetArea(const Point3& a, const Point3& b, const Point3& c)
{
  return 0.5 * lengthOf(doubleAreaVector(a, b, c));
}

inline double facetArea(const SurfaceMesh& mesh, Index facet)
{
  const auto& [a, b, c] = mesh.facetPoints[facet];
  return facetArea(mesh.points[a], mesh.points[b], mesh.points[c]);
}

/** Unit normal; zero if the points are collinear: the sine of the angle is below 1e-150. */
inline Point3 facetNormal(const Point3& a, const Point3& b, const Point3& c)
{
  const ShortEdges edges = shortEdges(a, b, c);
  const double first = edges.first.cwiseAbs().maxCoeff();
  const double second = edges.second.cwiseAbs().maxCoeff();
  if (!(std::min(first, second) > 0.0))
  {
    return Point3::Zero();
  }
  const Point3 normal = (edges.first / first).cross(edges.second / second);
  const double squared = normal.squaredNorm();
  return squared > 1e-300 ? Point3(normal / std::sqrt(squared)) : Point3(Point3::Zero());
}

/**
 * False if the triangle has no area that doubles can tell from none: the sine of its widest angle
 * is not above the rounding error of a cross product (the corners are collinear), or its width is
 * below 1e-30 of its length. A sliver with any width above that has area, even if it is only one
 * unit in the last place wide.
 */
inline bool hasArea(const Point3& a, const Point3& b, const Point3& c)
{
  constexpr double roundingOfSine = 1e-15; // 4.5 units in the last place of 1
  constexpr double minWidth = 1e-30;       // squares of areas stay normal numbers
  const ShortEdges edges = shortEdges(a, b, c);
  const double first = lengthOf(edges.first);
  const double second = lengthOf(edges.second);
  if (!(std::min(first, second) > minWidth * std::max(first, second)))
  {
    return false;
  }
  return (edges.first / first).cross(edges.second / second).norm() > roundingOfSine;
}
}

#endif
