/**
 * @file SurfacePieces.h
 * @brief Pieces of one data object: put together, and cut off.
 */
#ifndef remesh_SurfacePieces_h
#define remesh_SurfacePieces_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace remesh
{
/**
 * What a process has of a surface or of sites, without ghost and hidden cells and their marks.
 * Nothing is copied where there are none.
 */
vtkSmartPointer<vtkDataObject> withoutGhosts(vtkDataObject* piece);

/**
 * A source of pieces may compute a coordinate of 0 anew for each, as 6e-17 or -1e-16: the pieces
 * would come apart there. What is nothing but rounding of 0 becomes 0.
 *
 * @param surface with points, which are changed.
 */
void roundToZero(vtkDataObject* surface);

/**
 * All pieces as one, points and cells in the order of the pieces, with the arrays that all those
 * with points have. Field data: of the first piece that has an array.
 *
 * @param pieces vtkPolyData or vtkUnstructuredGrid, or nullptr. A single one that is not empty is
 *        the result itself, and so is the first of what is no such data.
 */
vtkSmartPointer<vtkDataObject> joinPieces(
  const std::vector<vtkSmartPointer<vtkDataObject>>& pieces);

/**
 * Cells of a range, or points where there are no cells, as one part of several. Cells and points
 * keep their order.
 */
vtkSmartPointer<vtkPolyData> cutPart(vtkPolyData* whole, int part, int numberOfParts);
}

#endif
