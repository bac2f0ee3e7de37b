/**
 * @file CellLabels.h
 * @brief A cell array of the caller's data as labels of the cells.
 */
#ifndef remesh_CellLabels_h
#define remesh_CellLabels_h

#include "Support/Status.h"
#include "Support/Types.h"

#include <vector>

class vtkAbstractArray;
class vtkPolyData;

namespace remesh
{
/**
 * One number per cell, equal where their tuples are: numbers of any type and number
 * of components, or strings, compared as CellOrder.h tells.
 *
 * @return InvalidInput, with the array's name, for a wrong number of tuples or another type.
 */
Status readCellLabels(
  vtkAbstractArray* array, Offset numberOfCells, std::vector<Index>& labels);

/**
 * Where the input has several regions (BlockNames.h), parts labels by them, too: cells keep equal
 * labels only in the same region. Cells without labels get those of their regions.
 */
void addRegions(vtkPolyData* input, std::vector<Index>& labels);
}

#endif
