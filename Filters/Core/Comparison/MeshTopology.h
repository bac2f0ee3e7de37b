/**
 * @file MeshTopology.h
 * @brief What a mesh is, as it is indexed: borders, non-manifold places, parts, Euler
 * characteristic.
 */
#ifndef remesh_MeshTopology_h
#define remesh_MeshTopology_h

#include "Mesh/EdgeTable.h"
#include "Mesh/TriangleTree.h"
#include "Support/Status.h"

namespace remesh
{
struct MeshTopology
{
  Index points = 0;    ///< that triangles use
  Index triangles = 0; ///< all, those without three points, too
  Index edges = 0;
  Index boundaryEdges = 0;     ///< of one triangle
  Index nonManifoldEdges = 0;  ///< of more than two
  Index nonManifoldPoints = 0; ///< whose triangles are not one fan (joined by edges of two)
  Index boundaryLoops = 0;     ///< of the surface cut apart at its non-manifold points
  Index components = 0;        ///< connected through points
  Index eulerCharacteristic = 0;
  Index duplicatePoints = 0;     ///< used points at the coordinates of a lower used one
  Index degenerateTriangles = 0; ///< with fewer than three points, or without area
  Index duplicateTriangles = 0;  ///< on the same three points as an earlier one
  bool oriented = true;          ///< triangles agree across all edges of two
};

/**
 * The mesh's triangles that have three different points; the others count as degenerate only.
 *
 * Chains of boundary edges that end at non-manifold edges count as one loop each.
 *
 * @param mesh finite points.
 * @return Cancelled, or success.
 * Cost: O(T).
 */
Status measureTopology(const Triangles& mesh, const RunControl& control, MeshTopology& topology);

/**
 * The same of triangles that all have three different points, as far as their indices tell:
 * nothing of duplicates and of what is degenerate.
 *
 * @param edges of the triangles.
 */
Status measureConnectivity(const std::vector<Triple>& triangles, const EdgeTable& edges,
  Index numberOfPoints, const RunControl& control, MeshTopology& topology);

/** Whether two surfaces agree in all that tells closed or bordered manifolds apart; as a whole. */
bool haveSameTopology(const MeshTopology& a, const MeshTopology& b);
}

#endif
