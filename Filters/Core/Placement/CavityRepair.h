/**
 * @file CavityRepair.h
 * @brief Gives a flipped triangle and some around it other edges, several at once.
 *
 * Where all corners are on features, nothing can move, and often no edge turns alone without
 * flipping another triangle.
 */
#ifndef remesh_CavityRepair_h
#define remesh_CavityRepair_h

#include "Placement/FlipRepair.h"
#include "Placement/RepairedMesh.h"
#include "Placement/StarRepair.h"

namespace remesh
{
/**
 * Takes the triangle out, and as few more around it as help, and fills the polygon that they leave
 * anew (CavityFilling.h), such that fewer triangles are flipped; of polygons with as many triangles
 * the one where the cost falls most. At the last effort, where none does that, one where as many
 * are flipped and the cost falls by half of what a step in this pass has to gain: something may
 * help then. Vertices, their places and the topology stay.
 *
 * @return whether any triangles have changed. Cost: some hundreds of polygons of a few triangles,
 *         or fewer that are larger, where the surface is narrow.
 */
bool refillAround(const RepairContext& context, Index triangle, Effort effort, RepairedMesh& mesh,
  FlipRepair& repair);
}

#endif
