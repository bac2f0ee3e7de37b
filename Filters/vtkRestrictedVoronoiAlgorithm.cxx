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
struct PortChoice
{
  bool VoronoiCells;
  bool Edges;
  int LargestDimension; ///< of the array `Embedding` of port 1
};

/** Fills the ports one by one; what is in them is of no use when the run was aborted. */
remesh::Status writePorts(const remesh::DiagramSource& source, const PortChoice& choice,
  remesh::RunControl control, vtkInformationVector* ports, std::vector<std::string>& warnings)
{
  using Ports = vtkRestrictedVoronoiAlgorithm;
  remesh::DiagramPoints points;
  remesh::EdgeTable edges;
  // The executive passed the input's field data: what it tells of an earlier run is not true here.
  for (int port = 0; port < ports->GetNumberOfInformationObjects(); ++port)
  {
    remesh::removeReserved(
      remesh::meshFactNames, vtkDataObject::GetData(ports, port)->GetFieldData());
  }
  const std::function<void()> steps[] = {
    [&]() { remesh::writeSurface(source, vtkPolyData::GetData(ports, Ports::SURFACE), warnings); },
    [&]()
    {
      if (choice.VoronoiCells || choice.Edges)
      {
        edges = remesh::buildCutEdgeTable(
          source.prepared.mesh, source.prepared.featuresOrNone(), source.control);
        // When one of these is cancelled, so is the run, which is asked about after each step.
        if (!source.control.cancelled())
        {
          static_cast<void>(remesh::numberDiagramPoints(source.prepared.mesh, edges,
            { source.surface(), source.result.sites, source.result.diagram }, source.control,
            points));
        }
      }
    },
    [&]()
    {
      if (choice.VoronoiCells)
      {
        remesh::writeVoronoiCells(source, points, choice.LargestDimension,
          vtkPolyData::GetData(ports, Ports::VORONOI_CELLS));
      }
    },
    [&]()
    {
      if (choice.Edges)
      {
        remesh::writeEdges(source, edges, points, vtkPolyData::GetData(ports, Ports::EDGES));
      }
    },
    [&]()
    {
      remesh::writeSites(source, vtkPolyData::GetData(ports, Ports::SITES));
      remesh::writeConvergence(source, vtkTable::GetData(ports, Ports::CONVERGENCE));
    },
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

int vtkRestrictedVoronoiAlgorithm::ComputeDiagram(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, remesh::RunRequest request)
{
  auto& facts = this->Internals->LastRun;
  const remesh::RunControl control = remesh::makeRunControl(this);
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  const PortChoice choice{ this->GenerateVoronoiCells, this->GenerateEdges,
    this->MaximumCellEmbeddingDimension };
  const bool writesDiagram =
    choice.VoronoiCells || choice.Edges || input->GetCellData()->GetNumberOfArrays() > 0;
  request.sites = remesh::givenSites(vtkPointSet::GetData(inputVector[1]));
  request.options.placement = static_cast<remesh::VertexPlacement>(this->VertexPlacement);
  request.options.keepDiagram = writesDiagram;
  request.options.ranks = this->GetRanks();
  request.measuresDistance = this->MeasureDistance;
  request.memory = remesh::machineMemory();
  request.preparation.mayLend = true;
  request.preparation.mayRefine = true;
  // Only the cells show the coordinates.
  request.preparation.mostKeptDimensions = choice.VoronoiCells ? choice.LargestDimension : 0;
  remesh::RunOutcome outcome;
  remesh::PreparedSurface& prepared = outcome.prepared;
  const remesh::DiagramSource source{ input, prepared, outcome.result, outcome.given.places,
    static_cast<int>(request.options.seed), control.silent(), remesh::blocksOfCells(input) };

  const auto ended = vtkInternals::Execute(this, outputVector,
    [&]() -> remesh::Status
    {
      remesh::Status status = vtkInternals::MakeRequest(this, inputVector, request.preparation);
      if (!status.ok())
      {
        return status;
      }
      status = remesh::makeMesh(request, control.part(0.0, 0.95), outcome);
      facts.Intake = prepared.intake;
      facts.Seconds = secondsOf(outcome);
      if (!status.ok())
      {
        return status;
      }
      remesh::Stopwatch watch;
      if (!writesDiagram)
      {
        outcome.result.diagram = {}; // room for the ports
      }
      status = writePorts(source, choice, control.part(0.95, 1.0), outputVector, prepared.warnings);
      facts.Seconds["diagram"] += watch.lap();
      return status;
    });
  if (ended != vtkInternals::Outcome::Done)
  {
    return ended == vtkInternals::Outcome::Nothing;
  }
  std::vector<std::string> warnings = remesh::warningsOf(request, outcome);
  if (std::string distribution = remesh::describeDistribution(inputVector[0]);
      !distribution.empty())
  {
    warnings.push_back(std::move(distribution));
  }
  for (const std::string& warning : warnings)
  {
    vtkWarningMacro(<< warning);
  }
  facts.Dimension = prepared.surface.dimension;
  facts.Iterations = outcome.result.convergence.rows.back().iteration;
  facts.Evaluations = outcome.result.evaluations;
  facts.TopologyReport = outcome.result.topology.describe();
  facts.Energy = outcome.result.sums.totalEnergy * source.energyUnit() * source.densityUnit();
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
