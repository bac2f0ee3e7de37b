/**
 * @file Extent.h
 * @brief How large a surface is, and the least length that means anything at that size.
 */
#ifndef remesh_Extent_h
#define remesh_Extent_h

#include "Mesh/SurfaceMesh.h"

#include <Eigen/Geometry>

namespace remesh
{
/** Length of the diagonal of the points' bounding box; 0 without points. */
inline double boundingBoxDiagonal(const std::vector<Point3>& points)
{
  Eigen::AlignedBox3d box;
  for (const Point3& point : points)
  {
    box.extend(point);
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

inline double boundingBoxDiagonal(const SurfaceMesh& mesh)
{
  return boundingBoxDiagonal(mesh.points);
}

/**
 * Points nearer than this differ by no more than the rounding of what computed them, like those on
 * the seam of a closed parametric surface.
 */
inline double roundingOfPoints(const std::vector<Point3>& points)
{
  return 1e-12 * boundingBoxDiagonal(points);
}

/** A triangle less high than this has no normal: coordinates in single precision cannot tell it. */
inline double minHeight(const SurfaceMesh& mesh)
{
  constexpr double resolution = 1e-6; // of the diagonal
  return resolution * boundingBoxDiagonal(mesh);
}
}

#endif
