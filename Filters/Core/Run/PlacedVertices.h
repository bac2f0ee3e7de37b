/**
 * @file PlacedVertices.h
 * @brief Where the vertices of a mesh are, and what repairs did to them.
 */
#ifndef remesh_PlacedVertices_h
#define remesh_PlacedVertices_h

#include "Support/Types.h"

#include <vector>

namespace remesh
{
/** How many steps repairs of a placed mesh took, and what they left. */
struct MeshEdits
{
  Offset inverted = 0; ///< triangles that are left
  Offset movedVertices = 0;
  Offset flippedEdges = 0; ///< in the place of the dual's, as many
  Offset refilled = 0; ///< triangles turned back by CavityRepair.h, at most: again, if they invert
};

/** Where the vertices are, and what is wrong with the triangles then. */
struct PlacedVertices
{
  std::vector<Point3> positions; ///< K, R^3, the unit of the points
  MeshEdits edits;               ///< and the triangles that are inverted
  Offset strays = 0;             ///< triangles that face a closer part of the surface the wrong way
};
}

#endif
