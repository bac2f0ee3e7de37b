/**
 * @file BlockOutputs.h
 * @brief The outputs for composite input: what was made of the whole, block by block.
 */
#ifndef remesh_BlockOutputs_h
#define remesh_BlockOutputs_h

#include "Adaptors/SurfaceBlocks.h"

namespace remesh
{
/**
 * Cuts the result apart where its cell array `blockName` tells. A point is in each block that has a
 * cell with it, and where the point array of that name puts it; others are dropped. The order of
 * points and cells stays.
 *
 * @param count of blocks. @return one for each, with all arrays but hidden ones.
 * Cost: one pass over points, cells and arrays, whatever the number of blocks.
 */
std::vector<vtkSmartPointer<vtkPolyData>> partByBlock(vtkPolyData* whole, int count);

/**
 * Leaves a block the arrays that its input has, under their names and as active as there, and those
 * of the filter; adds the input's field data, and the facts of the whole.
 */
void finishBlock(vtkPolyData* whole, vtkDataObject* input, vtkPolyData* block);

/**
 * The leaves of the input themselves, each with the new point arrays of the result.
 *
 * @param wholeInput what joinBlocks made of the blocks. @param whole the result: `wholeInput`
 * with more point arrays or fewer, or nothing at all.
 * @return one for each block, nullptr for those that are; without points where there is no result.
 */
std::vector<vtkSmartPointer<vtkDataObject>> passBlocks(
  const std::vector<SurfaceBlock>& blocks, vtkPolyData* wholeInput, vtkPolyData* whole);

/** The same for a leaf that is no composite. */
void passLeaf(
  vtkDataObject* leaf, vtkPolyData* wholeInput, vtkPolyData* whole, vtkDataObject* output);
}

#endif
