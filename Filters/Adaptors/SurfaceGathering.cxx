#include "Adaptors/SurfaceGathering.h"

#include "Adaptors/ProcessRanks.h"
#include "Adaptors/SurfaceBlocks.h"
#include "Adaptors/SurfacePieces.h"
#include "Run/RankWork.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTypes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <map>

namespace remesh
{
namespace
{
constexpr int firstProcess = 0;
constexpr int tag = 20120; ///< of all messages

using Path = std::vector<unsigned int>;

/** How a leaf is sent: not at all, or as a type alone, of which there are no pieces. */
enum LeafKind
{
  None = -1,
  TypeAlone,
  Data
};

/** The leaves of composite data, or the data themselves. */
std::vector<SurfaceBlock> leavesOf(vtkDataObject* data)
{
  if (hasBlocks(data))
  {
    return findBlocks(data);
  }
  SurfaceBlock leaf;
  leaf.input = data;
  return { leaf };
}

bool hasPieces(vtkDataObject* leaf)
{
  return vtkPolyData::SafeDownCast(leaf) || vtkUnstructuredGrid::SafeDownCast(leaf);
}

/** What is put together; of data of which only points count, these, if there are others, too. */
vtkSmartPointer<vtkDataObject> pieceOf(vtkDataObject* leaf, bool takesPoints)
{
  auto* set = vtkPointSet::SafeDownCast(leaf);
  if (!takesPoints || !set || hasPieces(leaf))
  {
    return withoutGhosts(leaf);
  }
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(set->GetPoints());
  points->GetPointData()->ShallowCopy(set->GetPointData());
  points->GetFieldData()->ShallowCopy(set->GetFieldData());
  return points;
}

void sendLeaf(vtkMultiProcessController* controller, int to, const Path& path, vtkDataObject* leaf)
{
  const int type = leaf ? leaf->GetDataObjectType() : 0;
  const int kind = !leaf ? None : (hasPieces(leaf) ? Data : TypeAlone);
  const int head[3] = { static_cast<int>(path.size()), kind, type };
  controller->Send(head, 3, to, tag);
  if (!path.empty())
  {
    controller->Send(path.data(), static_cast<vtkIdType>(path.size()), to, tag);
  }
  if (kind == Data)
  {
    controller->Send(leaf, to, tag);
  }
}

vtkSmartPointer<vtkDataObject> receiveLeaf(
  vtkMultiProcessController* controller, int from, Path& path)
{
  int head[3] = { 0, None, 0 };
  controller->Receive(head, 3, from, tag);
  path.assign(static_cast<std::size_t>(head[0]), 0);
  if (!path.empty())
  {
    controller->Receive(path.data(), head[0], from, tag);
  }
  vtkSmartPointer<vtkDataObject> leaf;
  if (head[1] == Data)
  {
    leaf.TakeReference(controller->ReceiveDataObject(from, tag));
  }
  else if (head[1] == TypeAlone)
  {
    leaf.TakeReference(vtkDataObjectTypes::NewDataObject(head[2]));
  }
  return leaf;
}

void sendLeaves(
  vtkMultiProcessController* controller, int to, const std::vector<SurfaceBlock>& leaves)
{
  const int count = static_cast<int>(leaves.size());
  controller->Send(&count, 1, to, tag);
  for (const SurfaceBlock& leaf : leaves)
  {
    sendLeaf(controller, to, leaf.path, leaf.input);
  }
}

/** Calls `take(path, leaf)` for each. */
template <class Take>
void receiveLeaves(vtkMultiProcessController* controller, int from, const Take& take)
{
  int count = 0;
  controller->Receive(&count, 1, from, tag);
  for (; count > 0; --count)
  {
    Path path;
    const vtkSmartPointer<vtkDataObject> leaf = receiveLeaf(controller, from, path);
    take(path, leaf);
  }
}

/** The data of all processes, in the structure of this one's. */
vtkSmartPointer<vtkDataObject> assemble(
  vtkDataObject* own, const std::map<Path, std::vector<vtkSmartPointer<vtkDataObject>>>& pieces)
{
  auto* composite = hasBlocks(own) ? vtkCompositeDataSet::SafeDownCast(own) : nullptr;
  if (!composite)
  {
    const auto found = pieces.find(Path()); // of one leaf, this process's at least
    return joinPieces(found->second);
  }
  vtkSmartPointer<vtkCompositeDataSet> whole;
  whole.TakeReference(composite->NewInstance());
  whole->CopyStructure(composite);
  whole->GetFieldData()->ShallowCopy(own->GetFieldData());
  for (const auto& [path, leaves] : pieces)
  {
    SurfaceBlock place;
    place.path = path;
    setBlock(whole, place, joinPieces(leaves));
  }
  return whole;
}
}

SurfaceGathering::SurfaceGathering(vtkInformationVector** inputs, int numberOfInputs)
  : Inputs(inputs)
  , NumberOfInputs(static_cast<std::size_t>(numberOfInputs))
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  vtkInformation* port = inputs[0]->GetInformationObject(0);
  if (controller && controller->GetNumberOfProcesses() > 1 && port &&
    port->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) && port->Has(Pipeline::UPDATE_PIECE_NUMBER()) &&
    port->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) == controller->GetNumberOfProcesses() &&
    port->Get(Pipeline::UPDATE_PIECE_NUMBER()) == controller->GetLocalProcessId())
  {
    this->Controller = controller;
    this->Processes = std::make_unique<ProcessRanks>(controller);
  }
}

SurfaceGathering::~SurfaceGathering() = default;

Ranks* SurfaceGathering::ranks() const
{
  return this->Processes.get();
}

Status SurfaceGathering::work(const std::function<void()>& own) const
{
  if (!this->worksHere())
  {
    workForFirst(*this->Processes);
    return Status::success();
  }
  own();
  try
  {
    if (this->Processes)
    {
      dismissOthers(*this->Processes);
    }
    return Status::success();
  }
  catch (const std::runtime_error& error)
  {
    return Status::invalid(error.what());
  }
}

bool SurfaceGathering::worksHere() const
{
  return !this->Controller || this->Controller->GetLocalProcessId() == firstProcess;
}

int SurfaceGathering::agree(bool ready) const
{
  int missing = ready ? 0 : 1;
  if (!this->Controller)
  {
    return missing;
  }
  if (!this->worksHere())
  {
    this->Controller->Send(&missing, 1, firstProcess, tag);
    awaitMessage(this->Controller, firstProcess, tag);
    this->Controller->Receive(&missing, 1, firstProcess, tag);
    return missing;
  }
  const int processes = this->Controller->GetNumberOfProcesses();
  for (int process = 1; process < processes; ++process)
  {
    int other = 0;
    this->Controller->Receive(&other, 1, process, tag);
    missing += other;
  }
  for (int process = 1; process < processes; ++process)
  {
    this->Controller->Send(&missing, 1, process, tag);
  }
  return missing;
}

void SurfaceGathering::gather(const std::vector<bool>& takesPoints)
{
  if (this->Controller)
  {
    this->worksHere() ? this->ReceiveInputs(takesPoints) : this->SendInputs(takesPoints);
  }
}

void SurfaceGathering::SendInputs(const std::vector<bool>& takesPoints)
{
  for (std::size_t port = 0; port < this->NumberOfInputs; ++port)
  {
    std::vector<SurfaceBlock> leaves = leavesOf(vtkDataObject::GetData(this->Inputs[port]));
    for (SurfaceBlock& leaf : leaves)
    {
      leaf.input = pieceOf(leaf.input, takesPoints[port]);
    }
    sendLeaves(this->Controller, firstProcess, leaves);
  }
}

void SurfaceGathering::ReceiveInputs(const std::vector<bool>& takesPoints)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (std::size_t port = 0; port < this->NumberOfInputs; ++port)
  {
    vtkDataObject* own = vtkDataObject::GetData(this->Inputs[port]);
    std::map<Path, std::vector<vtkSmartPointer<vtkDataObject>>> pieces;
    for (const SurfaceBlock& leaf : leavesOf(own))
    {
      pieces[leaf.path].push_back(pieceOf(leaf.input, takesPoints[port]));
    }
    for (int process = 1; process < this->Controller->GetNumberOfProcesses(); ++process)
    {
      receiveLeaves(this->Controller, process,
        [&](const Path& path, const vtkSmartPointer<vtkDataObject>& leaf)
        { pieces[path].push_back(leaf); });
    }
    this->Gathered.push_back(vtkSmartPointer<vtkInformationVector>::New());
    this->GatheredPointers.push_back(this->Gathered.back());
    if (vtkInformation* connection = this->Inputs[port]->GetInformationObject(0))
    {
      vtkNew<vtkInformation> info;
      info->Copy(connection);
      info->Set(vtkDataObject::DATA_OBJECT(), assemble(own, pieces));
      info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
      info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      this->Gathered.back()->Append(info);
    }
  }
  this->Inputs = this->GatheredPointers.data();
}

int SurfaceGathering::finish(int done, vtkInformationVector* outputs, bool spreads)
{
  if (!this->Controller)
  {
    return done;
  }
  int words[2] = { done, spreads }; // the first process has the say
  if (!this->worksHere())
  {
    awaitMessage(this->Controller, firstProcess, tag);
    this->Controller->Receive(words, 2, firstProcess, tag);
    if (words[0] && words[1])
    {
      this->ReceiveParts(outputs);
    }
    return words[0];
  }
  for (int process = 1; process < this->Controller->GetNumberOfProcesses(); ++process)
  {
    this->Controller->Send(words, 2, process, tag);
  }
  if (done && spreads)
  {
    this->SendParts(outputs);
  }
  return done;
}

void SurfaceGathering::SendParts(vtkInformationVector* outputs)
{
  const int processes = this->Controller->GetNumberOfProcesses();
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject* output = vtkDataObject::GetData(outputs, port);
    const std::vector<SurfaceBlock> leaves = leavesOf(output);
    for (int process = processes - 1; process >= 0; --process) // the first keeps its part at last
    {
      std::vector<SurfaceBlock> parts;
      for (const SurfaceBlock& leaf : leaves)
      {
        if (auto* surface = vtkPolyData::SafeDownCast(leaf.input))
        {
          parts.push_back(leaf);
          parts.back().input = cutPart(surface, process, processes);
        }
      }
      if (process != firstProcess)
      {
        sendLeaves(this->Controller, process, parts);
        continue;
      }
      for (const SurfaceBlock& part : parts)
      {
        hasBlocks(output) ? setBlock(output, part, part.input) : output->ShallowCopy(part.input);
      }
    }
  }
}

void SurfaceGathering::ReceiveParts(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject* output = vtkDataObject::GetData(outputs, port);
    receiveLeaves(this->Controller, firstProcess,
      [&](const Path& path, const vtkSmartPointer<vtkDataObject>& leaf)
      {
        SurfaceBlock place;
        place.path = path;
        hasBlocks(output) ? setBlock(output, place, leaf) : output->ShallowCopy(leaf);
      });
  }
}
}
