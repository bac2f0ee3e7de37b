/**
 * @file PlacedMesh.h
 * @brief The repair of a mesh whose vertices have been placed.
 */
#ifndef remesh_PlacedMesh_h
#define remesh_PlacedMesh_h

#include "Placement/Placement.h"
#include "Run/PlacedVertices.h"

#include <vector>

namespace remesh
{
/**
 * Repairs the mesh in three steps:
 *
 * 1. Inverted triangles are turned back (MeshRepair.h).
 * 2. Strays are turned back, too, if they are few (StrayTriangles.h). It is done in a copy, which
 *    is kept if its verdict is better: a stray less is not worth an inverted triangle more.
 * 3. Triangles that go through each other are parted, if they are few (CrossingRepair.h).
 *
 * @param problem of its diagram only the pieces' facets are read.
 * @param way how the vertices were placed.
 * @param locations K, points of the surface closest to the centroids. Replaced by those closest to
 *        the vertices, among the facets of a vertex's cell and of the cells around it.
 * @param triangles T, those of `problem.triangles`; a few may change.
 * @param placed the positions of the vertices, of which a few may change; the rest is filled in.
 * @return Cancelled, or success.
 * Deterministic. Cost: O(pieces + K) where nothing is wrong.
 */
Status repairPlacedMesh(const PlacementProblem& problem, VertexPlacement way,
  const RunControl& control, std::vector<SurfaceLocation>& locations,
  std::vector<Triple>& triangles, PlacedVertices& placed);
}

#endif
