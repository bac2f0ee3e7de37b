/**
 * @file HangingTriangles.h
 * @brief Takes away triangles that hang on an edge of the mesh by one side.
 *
 * Where a cell reaches beyond a thin part of the surface, a small component of it may have just two
 * neighbours there: its vertex has one triangle, on an edge that two others share already. Without
 * it the mesh is a manifold there, and closed.
 */
#ifndef remesh_HangingTriangles_h
#define remesh_HangingTriangles_h

#include "Delaunay/Collar.h"
#include "Mesh/EdgeValences.h"

namespace remesh
{
/**
 * Removes the triangles with two open edges that meet at a vertex without other triangles, and with
 * more than two triangles on the third. The pieces of that vertex go to a vertex of the third edge.
 * Vertices on features stay.
 *
 * @param edges of these triangles.
 * @param repeated triangles that are there already; those of a vertex that goes are no more.
 * @param seams brought up to date, like the others.
 * @return the number of triangles removed. O(T).
 */
Index removeHangingTriangles(const EdgeValences& edges, Components& components,
  std::vector<Triple>& triangles, std::vector<Triple>& repeated, Seams& seams);
}

#endif
