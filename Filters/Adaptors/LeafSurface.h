/**
 * @file LeafSurface.h
 * @brief One data object that is no composite as a surface, or why it is none.
 */
#ifndef remesh_LeafSurface_h
#define remesh_LeafSurface_h

#include "Support/Status.h"

#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkCellData;
class vtkDataObject;

namespace remesh
{
struct LeafSurface
{
  /** Points, point data, polygons and strips. Nothing is copied that can be shared. */
  vtkSmartPointer<vtkPolyData> surface;
  /** Of all cells of the leaf. */
  vtkSmartPointer<vtkCellData> cellData;
  vtkIdType numberOfCells = 0; ///< of the leaf, also those that are left out
  /** The leaf's id of each polygon, then of each strip; nullptr: 0, 1 and so on. */
  vtkSmartPointer<vtkIdTypeArray> cellIds;
};

/**
 * Takes vtkPolyData, and vtkUnstructuredGrid with triangles, quadrilaterals, pixels, polygons and
 * triangle strips alone. Vertices and lines are left out.
 *
 * @param subject what it is called in messages, as "The input".
 * @return InvalidInput for all else, and tells how to get a surface of it.
 * Cost: none for vtkPolyData, O(cells) for grids.
 */
Status readLeaf(vtkDataObject* leaf, const std::string& subject, LeafSurface& result);
}

#endif
