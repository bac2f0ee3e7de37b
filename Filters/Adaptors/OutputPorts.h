/**
 * @file OutputPorts.h
 * @brief What is done to all output ports of a filter alike.
 */
#ifndef remesh_OutputPorts_h
#define remesh_OutputPorts_h

#include "vtkDataObject.h"
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
}

#endif
