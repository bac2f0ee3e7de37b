/**
 * @file DualEdges.h
 * @brief Gives a repaired mesh the edges of the dual again, where it has no need of others.
 */
#ifndef remesh_TurnedEdges_h
#define remesh_TurnedEdges_h

#include "Repair/RepairedMesh.h"
#include "Run/PlacedVertices.h"

#include <vector>

namespace remesh
{
/**
 * Turns edges that the dual does not have back to such that it has, where no triangle is inverted
 * by that; again and again, as one may wait for another.
 *
 * @param dual T, the triangles before edges were turned.
 * @param edits its counts follow.
 * Cost: O(T), and some steps for each triangle that has changed.
 */
void turnBack(const std::vector<Triple>& dual, RepairedMesh& mesh, MeshEdits& edits);
}

#endif
