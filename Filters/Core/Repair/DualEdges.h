/**
 * @file DualEdges.h
 * @brief Flips edges of a repaired mesh back to those of the dual, where that inverts nothing.
 */
#ifndef remesh_DualEdges_h
#define remesh_DualEdges_h

#include "Repair/RepairedMesh.h"
#include "Run/PlacedVertices.h"

#include <vector>

namespace remesh
{
/**
 * Looks at the edges that the dual does not have. Flips such an edge if the new one is an edge of
 * the dual, and no triangle is inverted by it. Goes on until no edge can be flipped: one flip may
 * make room for another.
 *
 * @param dual T, the triangles before the repairs.
 * @param edits `flippedEdges` and `inverted` become what they are afterwards.
 * Cost: O(T), and some steps for each triangle that has changed.
 */
void flipBack(const std::vector<Triple>& dual, RepairedMesh& mesh, MeshEdits& edits);
}

#endif
