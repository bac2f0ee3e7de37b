/**
 * @file CavityRepair.h
 * @brief Gives a flipped triangle and some around it other diagonals.
 *
 * Where all corners are on features, nothing can move, and often no edge turns alone without
 * flipping another triangle: several have to change at once.
 */
#ifndef remesh_CavityRepair_h
#define remesh_CavityRepair_h

#include "Placement/FlipRepair.h"
#include "Placement/RepairedMesh.h"
#include "Placement/StarRepair.h"

namespace remesh
{
/**
 * Takes out the triangle and as few others as help, that hang together with it and have neither a
 * vertex nor a feature between them, and fills their polygon with the triangles of the least cost
 * (G. T. Klincsek: "Minimal triangulations of polygonal domains", 1980); of polygons with as many
 * triangles, the one where that helps most. Failing that, the same from all flipped triangles on
 * that hang together with it. The topology stays, and so do vertices and their places.
 *
 * @return whether that lowers the cost by as much as the context wants. Cost: some hundreds of
 *         polygons, of up to some forty triangles only where few hang together; for each a step for
 *         each three corners, and once for each such triangle a look for the closest facet.
 */
bool refillAround(
  const RepairContext& context, Index triangle, RepairedMesh& mesh, FlipRepair& repair);
}

#endif
