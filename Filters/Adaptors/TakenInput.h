/**
 * @file TakenInput.h
 * @brief What is at one input port, as plain data.
 */
#ifndef remesh_TakenInput_h
#define remesh_TakenInput_h

#include "Adaptors/SurfaceBlocks.h"

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace remesh
{
/** One input port as plain data: vtkPolyData, or vtkPointSet for sites. */
struct TakenInput
{
  vtkSmartPointer<vtkDataObject> whole;
  std::vector<SurfaceBlock> blocks; ///< that it was joined from, if it had any
  JoinReport report;
};

/**
 * The surface, or the sites, of one input port.
 *
 * @param input nullptr: nothing is connected.
 * @param subject names it in messages, as in "The input".
 * @param takesPoints whether any points will do: they are sites.
 */
Status takeInput(
  vtkDataObject* input, const std::string& subject, bool takesPoints, TakenInput& taken);
}

#endif
