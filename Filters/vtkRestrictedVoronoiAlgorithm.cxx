#include "vtkRestrictedVoronoiAlgorithm.h"

#include "vtkEmbeddedSurfaceInternals.h"

#include "Adaptors/DiagramOutput.h"
#include "Adaptors/Distribution.h"
#include "Adaptors/MeshBlocks.h"
#include "Adaptors/ParameterCheck.h"
#include "Adaptors/PointArrays.h"
#include "Adaptors/ProgressAdaptor.h"
#include "Adaptors/ReservedNames.h"
#include "Features/FeatureGraph.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/RunWarnings.h"
#include "Run/Task.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

vtkRestrictedVoronoiAlgorithm::vtkRestrictedVoronoiAlgorithm()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(5);
}

vtkRestrictedVoronoiAlgorithm::~vtkRestrictedVoronoiAlgorithm() = default;

bool vtkRestrictedVoronoiAlgorithm::TakesPoints(int inputPort) const
{
  return inputPort == 1;
}

bool vtkRestrictedVoronoiAlgorithm::MayReorder(int inputPort) const
{
  return inputPort == 0;
}

int vtkRestrictedVoronoiAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port == CONVERGENCE)
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
    return 1;
  }
  return this->Superclass::FillOutputPortInformation(port, info);
}

remesh::Status vtkRestrictedVoronoiAlgorithm::CheckParameters()
{
  remesh::ParameterCheck check;
  check.within("VertexPlacement", this->VertexPlacement, CENTROID, FIT)
    .within("MaximumCellEmbeddingDimension", this->MaximumCellEmbeddingDimension, 0, 100000);
  return check.status().ok() ? this->Superclass::CheckParameters() : check.status();
}

void vtkRestrictedVoronoiAlgorithm::SetDensityArray(const char* name)
{
  this->SetInputArrayToProcess(3, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name ? name : "");
}

vtkPolyData* vtkRestrictedVoronoiAlgorithm::GetVoronoiCellsOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(VORONOI_CELLS));
}

vtkPolyData* vtkRestrictedVoronoiAlgorithm::GetSitesOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(SITES));
}

vtkTable* vtkRestrictedVoronoiAlgorithm::GetConvergenceOutput()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(CONVERGENCE));
}

vtkPolyData* vtkRestrictedVoronoiAlgorithm::GetEdgesOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(EDGES));
}

int vtkRestrictedVoronoiAlgorithm::GetDimension() const
{
  return this->Internals->LastRun.Dimension;
}

int vtkRestrictedVoronoiAlgorithm::GetNumberOfIterations() const
{
  return this->Internals->LastRun.Iterations;
}

int vtkRestrictedVoronoiAlgorithm::GetNumberOfEvaluations() const
{
  return this->Internals->LastRun.Evaluations;
}

double vtkRestrictedVoronoiAlgorithm::GetEnergy() const
{
  return this->Internals->LastRun.Energy;
}

const char* vtkRestrictedVoronoiAlgorithm::GetTopologyReport() const
{
  return this->Internals->LastRun.TopologyReport.c_str();
}

double vtkRestrictedVoronoiAlgorithm::GetPhaseSeconds(const char* phase) const
{
  const auto& seconds = this->Internals->LastRun.Seconds;
  const auto found = seconds.find(phase ? phase : "");
  return found != seconds.end() ? found->second : 0.0;
}

namespace
{
/** Fills the ports one by one; what is in them is of no use when the run was aborted. */
class PortWriter
{
public:
  using Ports = vtkRestrictedVoronoiAlgorithm;

  /** @param filter tells which ports are filled. */
  PortWriter(const remesh::DiagramSource& source, vtkRestrictedVoronoiAlgorithm* filter,
    vtkInformationVector* ports)
    : Source(source)
    , Filter(filter)
    , Outputs(ports)
  {
  }

  remesh::Status Write(remesh::RunControl control, std::vector<std::string>& warnings)
  {
    // The executive passed the input's field data: what it tells of an earlier run is not true.
    for (int port = 0; port < this->Outputs->GetNumberOfInformationObjects(); ++port)
    {
      remesh::removeReserved(
        remesh::meshFactNames, vtkDataObject::GetData(this->Outputs, port)->GetFieldData());
    }
    const std::function<void()> steps[] = {
      [&]() { remesh::writeSurface(this->Source, this->PolyData(Ports::SURFACE), warnings); },
      [&]() { this->NumberPoints(); },
      [&]() { this->WriteCells(); },
      [&]() { this->WriteEdges(); },
      [&]() { this->WriteSites(); },
    };
    control.enterPhase("Output", 0.0, 1.0);
    double done = 0.0;
    for (const std::function<void()>& step : steps)
    {
      step();
      control.report(++done / std::size(steps));
      if (control.cancelled())
      {
        return remesh::Status::cancelled();
      }
    }
    return remesh::Status::success();
  }

private:
  vtkPolyData* PolyData(int port) const { return vtkPolyData::GetData(this->Outputs, port); }

  /** The points of the diagram, for cells and edges. */
  void NumberPoints()
  {
    if (!this->Filter->GetGenerateVoronoiCells() && !this->Filter->GetGenerateEdges())
    {
      return;
    }
    const remesh::PreparedSurface& prepared = this->Source.prepared;
    this->Edges =
      remesh::buildCutEdgeTable(prepared.mesh, prepared.featuresOrNone(), this->Source.control);
    // When one of these is cancelled, so is the run, which is asked about after each step.
    if (!this->Source.control.cancelled())
    {
      static_cast<void>(remesh::numberDiagramPoints(prepared.mesh, this->Edges,
        { this->Source.surface(), this->Source.result.sites, this->Source.result.diagram },
        this->Source.control, this->Points));
    }
  }

  void WriteCells() const
  {
    if (this->Filter->GetGenerateVoronoiCells())
    {
      remesh::writeVoronoiCells(this->Source, this->Points,
        this->Filter->GetMaximumCellEmbeddingDimension(), this->PolyData(Ports::VORONOI_CELLS));
    }
  }

  void WriteEdges() const
  {
    if (this->Filter->GetGenerateEdges())
    {
      remesh::writeEdges(this->Source, this->Edges, this->Points, this->PolyData(Ports::EDGES));
    }
  }

  void WriteSites() const
  {
    remesh::writeSites(this->Source, this->PolyData(Ports::SITES));
    remesh::writeConvergence(this->Source, vtkTable::GetData(this->Outputs, Ports::CONVERGENCE));
  }

  const remesh::DiagramSource& Source;
  vtkRestrictedVoronoiAlgorithm* Filter;
  vtkInformationVector* Outputs;
  remesh::EdgeTable Edges;
  remesh::DiagramPoints Points;
};

/** Wall time by phase, but for that of the outputs. */
std::map<std::string, double> secondsOf(const remesh::RunOutcome& outcome)
{
  const remesh::RemeshResult::Seconds& seconds = outcome.result.seconds;
  return { { "intake", outcome.intakeSeconds }, { "sampling", seconds.sampling },
    { "lloyd", seconds.lloyd }, { "newton", seconds.newton }, { "repair", seconds.repair },
    { "diagram", seconds.diagram }, { "placement", seconds.placement },
    { "distance", seconds.distance } };
}
}

/** What the filter's parameters and the input of the sites add to it. */
void vtkRestrictedVoronoiAlgorithm::CompleteRequest(
  vtkInformationVector** inputVector, remesh::RunRequest& request)
{
  const bool hasCellArrays =
    vtkPolyData::GetData(inputVector[0])->GetCellData()->GetNumberOfArrays() > 0;
  request.sites = remesh::givenSites(vtkPointSet::GetData(inputVector[1]));
  request.options.placement = static_cast<remesh::VertexPlacement>(this->VertexPlacement);
  request.options.keepDiagram = this->GenerateVoronoiCells || this->GenerateEdges || hasCellArrays;
  request.options.ranks = this->GetRanks();
  request.measuresDistance = this->MeasureDistance;
  request.memory = remesh::machineMemory();
  request.preparation.mayLend = true;
  request.preparation.mayRefine = true;
  // Only the cells show the coordinates.
  request.preparation.maxKeptDimensions =
    this->GenerateVoronoiCells ? this->MaximumCellEmbeddingDimension : 0;
}

void vtkRestrictedVoronoiAlgorithm::KeepFacts(
  const remesh::DiagramSource& source, const remesh::RunOutcome& outcome)
{
  auto& facts = this->Internals->LastRun;
  facts.Dimension = source.dimension();
  facts.Iterations = outcome.result.convergence.rows.back().iteration;
  facts.Evaluations = outcome.result.evaluations;
  facts.TopologyReport = outcome.result.topology.describe();
  facts.Energy = outcome.result.sums.totalEnergy * source.energyUnit() * source.densityUnit();
}

int vtkRestrictedVoronoiAlgorithm::ComputeDiagram(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, remesh::RunRequest request)
{
  auto& facts = this->Internals->LastRun;
  const remesh::RunControl control = remesh::makeRunControl(this);
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  this->CompleteRequest(inputVector, request);
  remesh::RunOutcome outcome;
  const remesh::DiagramSource source{ input, outcome.prepared, outcome.result, outcome.given.places,
    static_cast<int>(request.options.seed), control.silent(), remesh::blocksOfCells(input) };
  const auto ended = vtkInternals::Execute(this, outputVector,
    [&]() -> remesh::Status
    {
      remesh::Status status = vtkInternals::MakeRequest(this, inputVector, request.preparation);
      if (status.ok())
      {
        status = remesh::makeMesh(request, control.part(0.0, 0.95), outcome);
        facts.Intake = outcome.prepared.intake;
        facts.Seconds = secondsOf(outcome);
      }
      if (!status.ok())
      {
        return status;
      }
      remesh::Stopwatch watch;
      if (!request.options.keepDiagram)
      {
        outcome.result.diagram = {}; // room for the ports
      }
      status = PortWriter(source, this, outputVector)
                 .Write(control.part(0.95, 1.0), outcome.prepared.warnings);
      facts.Seconds["diagram"] += watch.lap();
      return status;
    });
  if (ended != vtkInternals::Outcome::Done)
  {
    return ended == vtkInternals::Outcome::Nothing;
  }
  std::vector<std::string> warnings = remesh::warningsOf(request, outcome);
  warnings.push_back(remesh::describeDistribution(inputVector[0]));
  remesh::showWarnings(this, warnings);
  this->KeepFacts(source, outcome);
  return 1;
}

void vtkRestrictedVoronoiAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VertexPlacement: " << this->VertexPlacement << "\n";
  os << indent << "GenerateVoronoiCells: " << this->GenerateVoronoiCells << "\n";
  os << indent << "GenerateEdges: " << this->GenerateEdges << "\n";
  os << indent << "MeasureDistance: " << this->MeasureDistance << "\n";
  os << indent << "MaximumCellEmbeddingDimension: " << this->MaximumCellEmbeddingDimension << "\n";
  os << indent << "Dimension: " << this->GetDimension() << "\n";
  os << indent << "NumberOfIterations: " << this->GetNumberOfIterations() << "\n";
  os << indent << "NumberOfEvaluations: " << this->GetNumberOfEvaluations() << "\n";
  os << indent << "Energy: " << this->GetEnergy() << "\n";
  os << indent << "TopologyReport: " << this->GetTopologyReport() << "\n";
}
