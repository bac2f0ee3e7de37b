#include "vtkWholeSurfaceAlgorithm.h"

#include "Adaptors/OutputPorts.h"
#include "Adaptors/WholeData.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"

vtkWholeSurfaceAlgorithm::vtkWholeSurfaceAlgorithm() = default;
vtkWholeSurfaceAlgorithm::~vtkWholeSurfaceAlgorithm() = default;

namespace
{
/** The same connections with the data of the whole: the filter's own are left as they are. */
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

int vtkWholeSurfaceAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  remesh::WholeData whole;
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    whole.inputs.emplace_back(vtkDataObject::GetData(inputVector[port]));
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    whole.outputs.emplace_back(vtkDataObject::GetData(outputVector, port));
  }
  const remesh::Status status = remesh::gatherInputs(this, remesh::Status::success(), whole);
  int done = status.ok() ? 1 : 0;
  if (!status.ok())
  {
    vtkErrorMacro(<< status.message);
  }
  else if (whole.worksHere)
  {
    WholePorts ports(whole, inputVector, this->GetNumberOfInputPorts(), outputVector);
    done = this->RequestWhole(ports.inputs(), ports.outputs());
  }
  done = remesh::spreadOutputs(this, done, whole);
  if (!done)
  {
    remesh::emptyPorts(outputVector);
  }
  return done;
}

void vtkWholeSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
