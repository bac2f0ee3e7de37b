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
 * Turns inverted triangles back (MeshRepair.h), and then those that face other parts of the surface
 * the wrong way, where these are closer than their own, if they are few: keeps nothing that
 * inverts more. Last, triangles that go through each other are parted (CrossingRepair.h).
 *
 * @param problem of its diagram only the pieces' facets are read.
 * @param locations K, the points of the surface closest to the centroids; replaced by those closest
 *        to the places, among the facets of the vertex's cell and those around it.
 * @param triangles of `problem.triangles`; a few may change.
 * @param placed with the chosen places; a few may change.
 * Deterministic. Cost: O(pieces + K).
 */
Status repairPlacedMesh(const PlacementProblem& problem, VertexPlacement way,
  const RunControl& control, std::vector<SurfaceLocation>& locations,
  std::vector<Triple>& triangles, PlacedVertices& placed);
}

#endif
