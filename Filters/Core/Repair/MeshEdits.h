/**
 * @file MeshEdits.h
 * @brief How many steps repairs of a placed mesh took, and what they left.
 */
#ifndef remesh_MeshEdits_h
#define remesh_MeshEdits_h

#include "Support/Types.h"

namespace remesh
{
struct MeshEdits
{
  Offset inverted = 0; ///< triangles that are left
  Offset movedVertices = 0;
  Offset flippedEdges = 0; ///< in the place of the dual's, as many
  Offset refilled = 0; ///< triangles turned back by CavityRepair.h, at most: again, if they invert
};
}

#endif
