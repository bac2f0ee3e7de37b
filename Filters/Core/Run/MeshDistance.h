/**
 * @file MeshDistance.h
 * @brief How far a mesh and the surface it was made from are from each other.
 */
#ifndef remesh_MeshDistance_h
#define remesh_MeshDistance_h

#include "Comparison/SurfaceDistance.h"
#include "Mesh/TriangleTree.h"
#include "Run/RemeshResult.h"

namespace remesh
{
/** The surface after intake, as it is compared. */
Triangles trianglesOf(const SurfaceMesh& mesh);

/** The mesh, as it is compared. Valid as long as the result. */
Triangles trianglesOf(const RemeshResult& result);

/**
 * Sets `result.distance` (unit of the points) from places on up to 100 000 triangles of each
 * surface, without a bound: `maximum` is the largest distance found. Leaves it unset where one of
 * the surfaces has no area.
 *
 * @return Cancelled, or success.
 * Cost: O(F + T) for two trees, one after the other, of 32 bytes a triangle.
 */
Status findDistance(const SurfaceMesh& mesh, const RunControl& control, RemeshResult& result);
}

#endif
