/**
 * @file CavityRepair.h
 * @brief Gives an inverted triangle and some around it other edges, several at once.
 *
 * Where all corners are on features, nothing can move, and often no edge flips alone without
 * flipping another triangle.
 */
#ifndef remesh_CavityRepair_h
#define remesh_CavityRepair_h

#include "Repair/RepairedMesh.h"
#include "Repair/StarRepair.h"
#include "Run/PlacedVertices.h"

namespace remesh
{
/**
 * Takes the triangle out, and as few more around it as help, and fills the polygon that they leave
 * anew (CavityFilling.h), such that fewer triangles are inverted; of polygons with as many
 * triangles the one where the cost falls most. Vertices, their places and the topology stay.
 *
 * Strays (StrayTriangles.h) with a corner that may move are left: their own facets agree with them,
 * and there are many beside thin sheets, where the mesh would not be the dual any more.
 *
 * @return whether that helps. Cost: some hundreds of polygons of a few triangles, or fewer that are
 *         larger, where the surface is narrow.
 */
bool refillAround(
  const RepairContext& context, Index triangle, RepairedMesh& mesh, MeshEdits& edits);
}

#endif
