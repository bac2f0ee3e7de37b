/**
 * @file MeshBlocks.h
 * @brief Which blocks of the input the mesh, its points and the sites belong to.
 *
 * For inputs of several blocks (BlockNames.h) alone.
 */
#ifndef remesh_MeshBlocks_h
#define remesh_MeshBlocks_h

#include "Adaptors/MeshPoints.h"

namespace remesh
{
/** The blocks of the cells of a whole surface; nullptr: it has no blocks. */
const int* blocksOfCells(vtkPolyData* input);

/** The mesh, with a point for each block that a vertex is in. */
struct MeshBlocks : MeshPoints
{
  std::vector<int> pointBlocks;    ///< P; each point's location is on its block
  std::vector<int> triangleBlocks; ///< T
};

/**
 * Each triangle is in the block that covers most of it. A vertex whose location is on another block
 * than a triangle of it has one there: the place of that block closest to the vertex.
 *
 * Cost: O(T), and a tree over each block on which vertices have to be located.
 */
MeshBlocks findMeshBlocks(const DiagramSource& source);

/**
 * Of each site the block with the largest part of its cell's area, of equal ones the first; for
 * an empty cell that of the surface's place closest to the site's.
 */
std::vector<int> findSiteBlocks(const DiagramSource& source, const std::vector<Point3>& places);
}

#endif
