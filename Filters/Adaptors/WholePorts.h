/**
 * @file WholePorts.h
 * @brief A filter's ports with other data than its own.
 */
#ifndef remesh_WholePorts_h
#define remesh_WholePorts_h

#include "Adaptors/WholeData.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"

#include <vector>

namespace remesh
{
/** The ports with other data: the filter's own are left as they are. */
class WholePorts
{
public:
  WholePorts(const remesh::WholeData& data, vtkInformationVector** inputs, int numberOfInputs,
    vtkInformationVector* outputs)
    : Inputs(static_cast<std::size_t>(numberOfInputs))
  {
    for (int port = 0; port < numberOfInputs; ++port)
    {
      this->Inputs[port] = vtkSmartPointer<vtkInformationVector>::New();
      if (vtkInformation* connection = inputs[port]->GetInformationObject(0))
      {
        append(connection, data.inputs[port], this->Inputs[port]);
      }
      this->InputPointers.push_back(this->Inputs[port]);
    }
    for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
    {
      append(outputs->GetInformationObject(port), data.outputs[port], this->Outputs);
    }
  }

  vtkInformationVector** inputs() { return this->InputPointers.data(); }
  vtkInformationVector* outputs() { return this->Outputs; }

private:
  static void append(vtkInformation* like, vtkDataObject* data, vtkInformationVector* ports)
  {
    vtkNew<vtkInformation> info;
    info->Copy(like);
    info->Set(vtkDataObject::DATA_OBJECT(), data);
    ports->Append(info);
  }

  std::vector<vtkSmartPointer<vtkInformationVector>> Inputs;
  std::vector<vtkInformationVector*> InputPointers;
  vtkNew<vtkInformationVector> Outputs;
};
}

#endif
