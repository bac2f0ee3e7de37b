#include "vtkWholeSurfaceAlgorithm.h"

#include "Adaptors/BlockOutputs.h"
#include "Adaptors/CarriedArrays.h"
#include "Adaptors/ChosenArrays.h"
#include "Adaptors/InputOrder.h"
#include "Adaptors/OutputPorts.h"
#include "Adaptors/SharedInputs.h"
#include "Adaptors/SurfaceGathering.h"
#include "Adaptors/TakenInput.h"
#include "Adaptors/VTKCompatibility.h"
#include "Adaptors/WholePorts.h"

#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

vtkWholeSurfaceAlgorithm::vtkWholeSurfaceAlgorithm()
  : Inputs(std::make_unique<remesh::SharedInputs>())
{
  this->AddObserver(vtkCommand::EndEvent, this, &vtkWholeSurfaceAlgorithm::ForgetAbort);
}

vtkWholeSurfaceAlgorithm::~vtkWholeSurfaceAlgorithm() = default;

/** From VTK 9.2 on, executives leave the flag of an aborted execution, and the next would end. */
void vtkWholeSurfaceAlgorithm::ForgetAbort()
{
  this->SetAbortExecute(0);
}

int vtkWholeSurfaceAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

int vtkWholeSurfaceAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

bool vtkWholeSurfaceAlgorithm::TakesPoints(int) const
{
  return false;
}

int vtkWholeSurfaceAlgorithm::GetStructurePort(int) const
{
  return 0;
}

bool vtkWholeSurfaceAlgorithm::MayReorder(int) const
{
  return false;
}

bool vtkWholeSurfaceAlgorithm::PassesInput(int) const
{
  return false;
}

vtkTypeBool vtkWholeSurfaceAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT())
    ? this->RequestDataObject(request, inputVector, outputVector)
    : this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

namespace
{
vtkSmartPointer<vtkCommand> executionObserver;

/** Tells the process's observer of an execution, as long as this object lives. */
class ObservedExecution
{
public:
  explicit ObservedExecution(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
    , Observer(executionObserver)
  {
    if (this->Observer)
    {
      this->Observer->Execute(algorithm, vtkCommand::StartEvent, nullptr);
      this->Tag = algorithm->AddObserver(vtkCommand::AbortCheckEvent, this->Observer);
    }
  }
  ~ObservedExecution()
  {
    if (this->Observer)
    {
      this->Algorithm->RemoveObserver(this->Tag);
      this->Observer->Execute(this->Algorithm, vtkCommand::EndEvent, nullptr);
    }
  }
  ObservedExecution(const ObservedExecution&) = delete;
  void operator=(const ObservedExecution&) = delete;

private:
  vtkAlgorithm* Algorithm;
  vtkSmartPointer<vtkCommand> Observer;
  unsigned long Tag = 0;
};
}

/** One execution: what is at the ports, and the same as plain data. */
struct vtkWholeSurfaceAlgorithm::vtkWhole
{
  vtkWholeSurfaceAlgorithm* Self;
  vtkInformationVector** InputVector;
  vtkInformationVector* OutputVector;
  remesh::WholeData Data;

  vtkDataObject* InputOf(int outputPort) const
  {
    return vtkDataObject::GetData(this->InputVector[this->Self->GetStructurePort(outputPort)]);
  }

  remesh::Status TakeInputs()
  {
    const auto ports = static_cast<std::size_t>(this->Self->GetNumberOfInputPorts());
    this->Data.inputs.resize(ports);
    this->Data.blocks.resize(ports);
    for (std::size_t port = 0; port < ports; ++port)
    {
      remesh::TakenInput taken;
      remesh::Status status = remesh::takeInput(vtkDataObject::GetData(this->InputVector[port]),
        port == 0 ? "The input" : "The input at port " + std::to_string(port),
        this->Self->TakesPoints(static_cast<int>(port)), taken);
      this->Data.inputs[port] = taken.whole;
      this->Data.blocks[port] = std::move(taken.blocks);
      if (!status.ok())
      {
        return status;
      }
      this->Warn(taken.report);
      if (this->NeedsOrder(port))
      {
        auto* surface = vtkPolyData::SafeDownCast(this->Data.inputs[port]);
        this->Data.inputs[port] = remesh::inOwnOrder(surface);
      }
    }
    return remesh::Status::success();
  }

  /** Whether the order of the input would depend on the number of processes. */
  bool NeedsOrder(std::size_t port) const
  {
    const int number = static_cast<int>(port);
    if (!this->Data.inputs[port] || !this->Self->MayReorder(number))
    {
      return false;
    }
    const auto& blocks = this->Data.blocks[port];
    const auto filled = std::count_if(blocks.begin(), blocks.end(),
      [](const remesh::SurfaceBlock& block)
      { return block.input && block.input->GetNumberOfElements(vtkDataObject::CELL) > 0; });
    return filled > 1 || remesh::comesInPieces(this->Self, number);
  }

  void Warn(const remesh::JoinReport& report) const
  {
    remesh::LostArrays lost;
    lost.unfit = report.unfitArrays;
    if (const std::string text = lost.describe(); !text.empty())
    {
      vtkWarningWithObjectMacro(this->Self, << text);
    }
    if (report.lacksNormals && this->TakesActiveNormals())
    {
      vtkWarningWithObjectMacro(this->Self,
        "Some blocks have active point normals, but not all: the normals are estimated.");
    }
  }

  /** Whether normals are used that nobody asked for. */
  bool TakesActiveNormals() const
  {
    vtkInformation* choice = this->Self->GetInputArrayInformation(0);
    return remesh::isPointAttribute(choice, vtkDataSetAttributes::NORMALS) ||
      (remesh::isChosenByName(choice) &&
        choice->Get(vtkDataObject::FIELD_NAME()) == std::string("Automatic"));
  }

  /** Plain outputs: the filter's own, or others for a while. */
  void MakeOutputs()
  {
    for (int port = 0; port < this->Self->GetNumberOfOutputPorts(); ++port)
    {
      vtkDataObject* output = vtkDataObject::GetData(this->OutputVector, port);
      if (auto* composite = vtkCompositeDataSet::SafeDownCast(output))
      {
        composite->CopyStructure(vtkCompositeDataSet::SafeDownCast(this->InputOf(port)));
      }
      if (!vtkPolyData::SafeDownCast(output) && !vtkTable::SafeDownCast(output))
      {
        vtkNew<vtkPolyData> plain;
        plain->GetFieldData()->PassData(output->GetFieldData());
        this->Data.outputs.emplace_back(plain.Get());
        continue;
      }
      this->Data.outputs.emplace_back(output);
    }
  }

  /** What was made, in the structure of the input. */
  void GiveOutputs()
  {
    for (int port = 0; port < this->Self->GetNumberOfOutputPorts(); ++port)
    {
      vtkDataObject* output = vtkDataObject::GetData(this->OutputVector, port);
      auto* whole = vtkPolyData::SafeDownCast(this->Data.outputs[port]);
      if (output == this->Data.outputs[port])
      {
        continue;
      }
      const int from = this->Self->GetStructurePort(port);
      auto* input = vtkPolyData::SafeDownCast(this->Data.inputs[from]);
      if (!vtkCompositeDataSet::SafeDownCast(output))
      {
        if (input)
        {
          remesh::passLeaf(this->InputOf(port), input, whole, output);
        }
        continue;
      }
      output->GetFieldData()->ShallowCopy(whole->GetFieldData());
      this->GiveBlocks(port, this->Data.blocks[from], input, whole, output);
    }
  }

private:
  void GiveBlocks(int port, const std::vector<remesh::SurfaceBlock>& blocks, vtkPolyData* input,
    vtkPolyData* whole, vtkDataObject* output) const
  {
    if (this->Self->PassesInput(port))
    {
      const auto leaves = remesh::passBlocks(blocks, input, whole);
      for (std::size_t k = 0; k < blocks.size(); ++k)
      {
        remesh::setBlock(output, blocks[k], leaves[k]);
      }
      return;
    }
    const bool hasResult =
      vtkPolyData::SafeDownCast(this->Data.outputs[0])->GetNumberOfPoints() > 0;
    const auto parts = remesh::partByBlock(whole, static_cast<int>(blocks.size()));
    for (std::size_t k = 0; k < blocks.size(); ++k)
    {
      if (blocks[k].input && hasResult)
      {
        remesh::finishBlock(whole, blocks[k].input, parts[k]);
      }
      remesh::setBlock(output, blocks[k], blocks[k].input ? parts[k].Get() : nullptr);
    }
  }
};

void vtkWholeSurfaceAlgorithm::SetExecutionObserver(vtkCommand* observer)
{
  executionObserver = observer;
}

int vtkWholeSurfaceAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    const char* type = this->GetOutputPortInformation(port)->Get(vtkDataObject::DATA_TYPE_NAME());
    if (std::strcmp(type, "vtkDataObject") != 0)
    {
      continue; // a table: the executive makes it
    }
    vtkDataObject* input = vtkDataObject::GetData(inputVector[this->GetStructurePort(port)]);
    vtkSmartPointer<vtkDataObject> made;
    if (remesh::hasBlocks(input) ||
      (this->PassesInput(port) && vtkUnstructuredGrid::SafeDownCast(input)))
    {
      made.TakeReference(input->NewInstance());
    }
    else
    {
      made = vtkSmartPointer<vtkPolyData>::New();
    }
    vtkDataObject* output = vtkDataObject::GetData(outputVector, port);
    if (!output || std::strcmp(output->GetClassName(), made->GetClassName()) != 0)
    {
      outputVector->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(), made);
    }
  }
  return 1;
}

int vtkWholeSurfaceAlgorithm::ModifyRequest(vtkInformation* request, int when)
{
  if (when == vtkExecutive::BeforeForward && request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return this->Inputs->update(this, request);
  }
  return this->Superclass::ModifyRequest(request, when);
}

int vtkWholeSurfaceAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->ForgetLastRun();
  const int ports = this->GetNumberOfInputPorts();
  std::vector<bool> takesPoints;
  for (int port = 0; port < ports; ++port)
  {
    takesPoints.push_back(this->TakesPoints(port));
  }
  remesh::SurfaceGathering gathering(inputVector, ports);
  gathering.gather(takesPoints);
  vtkWhole whole{ this, gathering.inputs(), outputVector, {} };
  whole.MakeOutputs();
  int done = 1;
  this->WaitingRanks = gathering.ranks();
  const remesh::Status dismissed = gathering.work(
    [&]
    {
      const ObservedExecution observed(this);
      done = this->WorkOnWhole(whole);
    });
  this->WaitingRanks = nullptr;
  if (done && !dismissed.ok()) // else an error is told already
  {
    vtkErrorMacro(<< dismissed.message);
    remesh::emptyPorts(outputVector);
    done = 0;
  }
  done = gathering.finish(done, outputVector, this->DistributeOutputs);
  if (remesh::abortRequested(this))
  {
    remesh::markNotGenerated(outputVector);
  }
  return done;
}

int vtkWholeSurfaceAlgorithm::WorkOnWhole(vtkWhole& whole)
{
  const remesh::Status status = whole.TakeInputs();
  remesh::WholePorts ports(
    whole.Data, whole.InputVector, this->GetNumberOfInputPorts(), whole.OutputVector);
  int done = 0;
  if (status.ok())
  {
    done = this->RequestWhole(ports.inputs(), ports.outputs());
  }
  else
  {
    vtkErrorMacro(<< status.message);
  }
  if (!done)
  {
    remesh::emptyPorts(ports.outputs());
  }
  whole.GiveOutputs();
  return done;
}

void vtkWholeSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DistributeOutputs: " << this->DistributeOutputs << "\n";
}
