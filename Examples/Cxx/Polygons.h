/** The polygons of a surface, one after the other. */
#ifndef Polygons_h
#define Polygons_h

#include <vtkCellArray.h>
#include <vtkPolyData.h>

/** Calls `visit(size, ids)` with the corners of each polygon, in their order. */
template <typename Visit>
void ForEachPolygon(vtkPolyData* surface, Visit visit)
{
  vtkCellArray* polygons = surface->GetPolys();
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (polygons->InitTraversal(); polygons->GetNextCell(size, ids) != 0;)
  {
    visit(size, ids);
  }
}

#endif
