/**
 * @file MeshPoints.h
 * @brief The points of the output: as a rule the mesh's vertices, or several for one of them.
 */
#ifndef remesh_MeshPoints_h
#define remesh_MeshPoints_h

#include "Adaptors/DiagramOutput.h"

namespace remesh
{
struct MeshPoints
{
  std::vector<Index> vertices;            ///< P: those of the mesh in their order, then copies
  std::vector<SurfaceLocation> locations; ///< P
  std::vector<Triple> triangles;          ///< T, as in the mesh, of points
};
}

#endif
