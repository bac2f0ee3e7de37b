/**
 * @file VTKCompatibility.h
 * @brief Differences between the releases of VTK that the library builds with (9.1 to 9.6).
 */
#ifndef remesh_VTKCompatibility_h
#define remesh_VTKCompatibility_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

namespace remesh
{
/** Whether the user asked a filter to stop. Only for the thread that executes it. */
inline bool abortRequested(vtkAlgorithm* algorithm)
{
#if VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 2
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}
}

#endif
