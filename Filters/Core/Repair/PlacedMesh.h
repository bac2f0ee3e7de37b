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
 * Improves the mesh (Improve.h) by a table of three rows, each with its turn:
 *
 * 1. Inverted triangles are turned back (MeshRepair.h).
 * 2. Strays are turned back, too, if they are few (StrayTriangles.h).
 * 3. Triangles that go through each other are parted, if they are few (CrossingRepair.h).
 *
 * What makes the verdict no better is undone: a stray less is not worth an inverted triangle more.
 *
 * @param problem of its diagram only the pieces' facets are read.
 * @param way how the vertices were placed.
 * @param locations K, points of the surface closest to the centroids. Replaced by those closest to
 *        the vertices, among the facets of a vertex's cell and of the cells around it.
 * @param triangles T, those of `problem.triangles`; a few may change.
 * @param placed the positions of the vertices, of which a few may change; the rest is filled in.
 *        `crossings` counts to one more than `maxStrays` (StrayTriangles.h).
 * @return Cancelled, or success.
 * Deterministic. Cost where nothing is wrong: that of one search for each of the three
 * (PlacedCandidate::count), and O(K).
 */
Status repairPlacedMesh(const PlacementProblem& problem, VertexPlacement way,
  const RunControl& control, std::vector<SurfaceLocation>& locations,
  std::vector<Triple>& triangles, PlacedVertices& placed);
}

#endif
