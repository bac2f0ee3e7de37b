/**
 * @file SurfaceBlocks.h
 * @brief The blocks of composite data, and how they become one surface.
 *
 * 1. `findBlocks` lists the leaves, in order.
 * 2. `joinBlocks` appends their points and cells. Nothing is merged: intake does that, as for any
 *    other surface.
 * 3. After the work, BlockOutputs.h takes the result apart again.
 *
 * Composite data are vtkMultiBlockDataSet, vtkPartitionedDataSetCollection and
 * vtkPartitionedDataSet (and vtkMultiPieceDataSet), within each other to any depth.
 */
#ifndef remesh_SurfaceBlocks_h
#define remesh_SurfaceBlocks_h

#include "Adaptors/LeafSurface.h"

#include <string>
#include <vector>

namespace remesh
{
struct SurfaceBlock
{
  /** Indices from the root; empty: the root itself. */
  std::vector<unsigned int> path;
  /** For messages, as `Block "wing" (1/0)`. */
  std::string subject;
  /** The same for all partitions of one data set. */
  int region = 0;
  /** The leaf; nullptr: there is none. */
  vtkSmartPointer<vtkDataObject> input;
};

/** Whether data are composite in a way that is understood here. */
bool hasBlocks(vtkDataObject* data);

/** All leaves, null ones, too. */
std::vector<SurfaceBlock> findBlocks(vtkDataObject* root);

/** Puts a leaf in its place; the structure is there (vtkCompositeDataSet::CopyStructure). */
void setBlock(vtkDataObject* root, const SurfaceBlock& block, vtkDataObject* leaf);

/** What joining could not keep. */
struct JoinReport
{
  std::vector<std::string> unfitArrays; ///< without one tuple for each point or cell
  bool lacksNormals = false;            ///< some blocks have active normals, but not all
};

/**
 * All blocks as one vtkPolyData of polygons and strips, with the arrays of BlockNames.h: blocks are
 * numbered as they come. Points have the precision of the blocks, double where these differ. An
 * array is active as, say, normals where it is so in all blocks. Blocks without points have no say.
 *
 * @param whole is replaced; has no field data.
 * @return as readLeaf. Cost: O(points + cells) of all blocks.
 */
Status joinBlocks(const std::vector<SurfaceBlock>& blocks, vtkPolyData* whole, JoinReport& report);

/** The points of all blocks, with the arrays that all have; for sites. */
Status joinPoints(const std::vector<SurfaceBlock>& blocks, vtkPolyData* whole);

/**
 * A leaf that is no composite and has cells to leave out or put in another order: as joinBlocks,
 * but without blocks.
 */
void joinLeaf(const LeafSurface& leaf, vtkPolyData* whole, JoinReport& report);
}

#endif
