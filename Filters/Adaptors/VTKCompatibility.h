/**
 * @file VTKCompatibility.h
 * @brief Differences between the releases of VTK that the library builds with (9.1 to 9.6).
 */
#ifndef remesh_VTKCompatibility_h
#define remesh_VTKCompatibility_h

#include "vtkAlgorithm.h"
#include "vtkPolygon.h"
#include "vtkVersionMacros.h"

namespace remesh
{
/**
 * Whether the user asked a filter, or since VTK 9.2 one upstream, to stop. Only for the thread that
 * executes it.
 */
inline bool abortRequested(vtkAlgorithm* algorithm)
{
#if VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 2
  // CheckAbort does not see a flag that was set without its time.
  const bool asked = algorithm->GetAbortExecute() != 0 || algorithm->CheckAbort();
  if (asked)
  {
    algorithm->SetAbortOutput(true);
  }
  return asked;
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}

/** Triangles of a polygon, by its corners 0, 1, ...; 0 where there are none. */
inline int triangulate(vtkPolygon* polygon, vtkIdList* corners)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240101) // between 9.3 and 9.4
  return polygon->TriangulateLocalIds(0, corners);
#else
  return polygon->Triangulate(corners);
#endif
}
}

#endif
