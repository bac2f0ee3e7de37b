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
inline double boundingBoxDiagonal(const SurfaceMesh& mesh)
{
  Eigen::AlignedBox3d box;
  for (const Point3& point : mesh.points)
  {
    box.extend(point);
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

/** A triangle less high than this has no normal: coordinates in single precision cannot tell it. */
inline double leastHeight(const SurfaceMesh& mesh)
{
  constexpr double resolution = 1e-6; // of the diagonal
  return resolution * boundingBoxDiagonal(mesh);
}
}

#endif
