#include "Adaptors/SharedInputs.h"

#include "Adaptors/SurfaceGathering.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkObject.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace remesh
{
bool SharedInputs::update(vtkAlgorithm* filter, vtkInformation* request)
{
  const SurfaceGathering gathering(
    filter->GetExecutive()->GetInputInformation(), filter->GetNumberOfInputPorts());
  if (!gathering.isShared())
  {
    return true;
  }
  const State state = stateOf(filter);
  if (!forward(filter, request))
  {
    this->Failed = state;
  }
  const int failures = gathering.agree(!(state == this->Failed));
  if (failures > 0 && gathering.worksHere() && !(state == this->Told))
  {
    this->Told = state;
    vtkErrorWithObjectMacro(filter,
      "The input could not be made on "
        << failures << " of the processes: nothing is done. Other messages tell why.");
  }
  return failures == 0;
}

SharedInputs::State SharedInputs::stateOf(vtkAlgorithm* filter)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  State state;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int k = 0; k < filter->GetNumberOfInputConnections(port); ++k)
    {
      if (auto* input = vtkDemandDrivenPipeline::SafeDownCast(filter->GetInputExecutive(port, k)))
      {
        state.age = std::max<vtkMTimeType>(state.age, input->GetPipelineMTime());
      }
      vtkInformation* info = filter->GetInputInformation(port, k);
      if (info && info->Has(Pipeline::UPDATE_TIME_STEP()))
      {
        state.time = info->Get(Pipeline::UPDATE_TIME_STEP());
      }
    }
  }
  return state;
}

bool SharedInputs::forward(vtkAlgorithm* filter, vtkInformation* request)
{
  vtkInformationIntegerKey* from = vtkExecutive::FROM_OUTPUT_PORT();
  const int outputPort = request->Get(from);
  bool succeeds = true;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int k = 0; k < filter->GetNumberOfInputConnections(port); ++k)
    {
      if (vtkExecutive* input = filter->GetInputExecutive(port, k))
      {
        request->Set(from, filter->GetInputConnection(port, k)->GetIndex());
        succeeds &= input->ProcessRequest(
                      request, input->GetInputInformation(), input->GetOutputInformation()) != 0;
      }
    }
  }
  request->Set(from, outputPort);
  return succeeds;
}
}
