/**
 * @file SeamPoints.h
 * @brief A point of the mesh for each side of a seam, as the input has them.
 */
#ifndef remesh_SeamPoints_h
#define remesh_SeamPoints_h

#include "Adaptors/MeshBlocks.h"

namespace remesh
{
/**
 * Splits the points of vertices on seams (PreparedSurface::charts), so that each side has its own,
 * located on that side. O(F + T), and the triangles around the seams.
 *
 * @param mesh the points so far; `pointBlocks` may be empty.
 */
void splitAlongSeams(const DiagramSource& source, MeshBlocks& mesh);
}

#endif
