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
/** The steps that repairs of a placed mesh took, and the inverted triangles that they left. */
struct MeshEdits
{
  Offset inverted = 0; ///< triangles that are still inverted
  Offset movedVertices = 0;
  Offset flippedEdges = 0; ///< edges that the dual does not have; each replaces one of the dual's
  Offset refilled = 0;     ///< triangles that CavityRepair.h has turned back; an upper bound
};

/** Where the vertices are, and which triangles are wrong with them there. */
struct PlacedVertices
{
  std::vector<Point3> positions; ///< K, R^3, the unit of the points
  MeshEdits edits;               ///< of all repairs; `edits.inverted` is counted with them
  Offset strays = 0;             ///< triangles that face a closer part of the surface the wrong way
  /** Pairs of triangles that go through each other, and could be parted (PartableCrossings.h). */
  Offset crossings = 0;
};
}

#endif
