/**
 * @file WholeData.h
 * @brief The data of all ports of a filter, each as one plain data object.
 */
#ifndef remesh_WholeData_h
#define remesh_WholeData_h

#include "Adaptors/SurfaceBlocks.h"

#include "vtkDataObject.h"

#include <vector>

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
};
}

#endif
