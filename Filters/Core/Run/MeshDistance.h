/**
 * @file MeshDistance.h
 * @brief How far a mesh and the surface it was made from are from each other.
 */
#ifndef remesh_MeshDistance_h
#define remesh_MeshDistance_h

#include "Comparison/SurfaceDistance.h"
#include "Mesh/TriangleTree.h"
#include "Run/RemeshResult.h"
#include "Support/Ranks.h"

namespace remesh
{
/** The surface after intake, for the functions of Comparison/. Valid as long as the mesh. */
Triangles trianglesOf(const SurfaceMesh& mesh);

/** The mesh that was made, likewise. Valid as long as the result. */
Triangles trianglesOf(const RemeshResult& result);

/**
 * Sets `result.distance`, in the unit of the points, from samples on up to 100 000 triangles of
 * mesh and surface each. No bound is proven: `maximum` is the largest distance that was found. If
 * the mesh or the surface has no area, the distance stays unset.
 *
 * @param ranks share the work if there are several: the first measures how far the mesh is from the
 *        surface, the others how far the surface is from the mesh (SharedDistance.h). Where one of
 *        these is short of memory, the first measures both. nullptr: there is no other rank.
 * @return Cancelled, success, or what else fails on another rank. The others cannot be cancelled:
 *         it returns when all have done their parts.
 * Cost: O(F + T) for two trees of 32 bytes a triangle, of which one is held at a time.
 */
Status findDistance(
  const SurfaceMesh& mesh, Ranks* ranks, const RunControl& control, RemeshResult& result);
}

#endif
