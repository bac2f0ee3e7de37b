/**
 * @file WholeData.h
 * @brief The data of all ports of a filter, each as one plain data object.
 */
#ifndef remesh_WholeData_h
#define remesh_WholeData_h

#include "Adaptors/SurfaceBlocks.h"

#include "vtkDataObject.h"

#include <vector>

class vtkAlgorithm;

namespace remesh
{
struct WholeData
{
  /** What is at each input port; nullptr: nothing. vtkPolyData, or vtkPointSet for sites. */
  std::vector<vtkSmartPointer<vtkDataObject>> inputs;
  /** Of each input port: the blocks of composite data, which the arrays of BlockNames.h number. */
  std::vector<std::vector<SurfaceBlock>> blocks;
  /** What is made for each output port, in place: vtkPolyData or vtkTable, empty at first. */
  std::vector<vtkSmartPointer<vtkDataObject>> outputs;
  /** Whether this process does the work. */
  bool worksHere = true;
};

/**
 * The place where the pieces of all processes come together: called after this process's inputs
 * became plain data, and before the work.
 *
 * @param status of this process's inputs; an error on one process is to be one on all.
 */
Status gatherInputs(vtkAlgorithm* filter, const Status& status, WholeData& data);

/**
 * The place where the result goes to the processes: called on all of them after the work, and
 * before the outputs are split.
 *
 * @param done what RequestData is to return, known where the work was done. @return the same on
 * all.
 */
int spreadOutputs(vtkAlgorithm* filter, int done, WholeData& data);
}

#endif
