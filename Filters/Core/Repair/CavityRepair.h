/**
 * @file CavityRepair.h
 * @brief Replaces an inverted triangle and a few around it by other triangles.
 *
 * It is needed where all corners are on features. No vertex can move there, and often a single edge
 * flip would only invert another triangle: several edges have to change at once.
 */
#ifndef remesh_CavityRepair_h
#define remesh_CavityRepair_h

#include "Repair/RepairedMesh.h"
#include "Repair/StarRepair.h"
#include "Run/PlacedVertices.h"

namespace remesh
{
/**
 * Takes out the triangle, and as few around it as it takes. Fills the polygon that they leave with
 * other triangles, so that fewer are inverted (CavityFilling.h). Of polygons of one size, that is
 * taken where the cost falls most. Vertices, their places and the topology stay.
 *
 * A stray (StrayTriangles.h) is left alone if one of its corners may move. Its own facets agree
 * with it. And beside thin sheets there are many strays: with all of them replaced, the mesh would
 * not be the dual any more.
 *
 * @param triangle inverted, or a stray.
 * @return whether fewer triangles are inverted now; if not, nothing has changed.
 * Cost: up to 500 polygons, most of a few triangles.
 */
bool refillAround(
  const RepairContext& context, Index triangle, RepairedMesh& mesh, MeshEdits& edits);
}

#endif
