/**
 * @file OutputPorts.h
 * @brief What is done to all output ports of a filter alike.
 */
#ifndef remesh_OutputPorts_h
#define remesh_OutputPorts_h

#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

namespace remesh
{
/** Leaves nothing on any port, not even the input's field data, which the executive passes. */
inline void emptyPorts(vtkInformationVector* ports)
{
  for (int port = 0; port < ports->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* output = vtkDataObject::GetData(ports, port))
    {
      output->Initialize();
    }
  }
}

/** So that they count as old, and the next Update() executes again. */
inline void markNotGenerated(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    outputs->GetInformationObject(port)->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
  }
}
}

#endif
