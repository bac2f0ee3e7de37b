#include "vtkSurfaceMeshComparison.h"

#include "Adaptors/ComparisonData.h"
#include "Adaptors/Distribution.h"
#include "Adaptors/ExecutionScope.h"
#include "Adaptors/OutputPorts.h"
#include "Adaptors/ParameterCheck.h"
#include "Adaptors/ProgressAdaptor.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkSurfaceMeshComparison);

namespace
{
/** Places of the bound's search for each sample. */
constexpr vtkIdType partsPerSample = 5;

struct Compared
{
  remesh::ComparedSurface mesh;
  remesh::ComparedSurface reference;
  bool referenceIsEmpty = false;
  remesh::Comparison comparison;
};

remesh::Status readAndCompare(vtkPolyData* mesh, vtkPolyData* reference,
  const remesh::DistanceOptions& options, const remesh::RunControl& control, Compared& surfaces)
{
  remesh::Comparison& comparison = surfaces.comparison;
  remesh::Status status = remesh::readComparedSurface(mesh, "mesh", surfaces.mesh);
  if (!status.ok() || !reference)
  {
    return status.ok()
      ? remesh::compareSurfaces(surfaces.mesh.view(), nullptr, options, control, comparison)
      : status;
  }
  status = remesh::readComparedSurface(reference, "reference surface", surfaces.reference);
  surfaces.referenceIsEmpty = status.code == remesh::StatusCode::EmptyInput;
  if (!status.ok() && !surfaces.referenceIsEmpty)
  {
    return status;
  }
  const remesh::Triangles view = surfaces.reference.view();
  return remesh::compareSurfaces(surfaces.mesh.view(), surfaces.referenceIsEmpty ? nullptr : &view,
    options, control, comparison);
}

void writeOutputs(vtkPolyData* mesh, vtkPolyData* reference, const Compared& surfaces, int bins,
  vtkInformationVector* outputs)
{
  using Filter = vtkSurfaceMeshComparison;
  const remesh::Comparison& comparison = surfaces.comparison;
  remesh::writeComparedMesh(
    mesh, surfaces.mesh, comparison, vtkPolyData::GetData(outputs, Filter::MESH));
  if (comparison.hasReference)
  {
    remesh::writeComparedReference(
      reference, comparison, vtkPolyData::GetData(outputs, Filter::REFERENCE));
  }
  remesh::writeComparisonSummary(
    surfaces.mesh, comparison, vtkTable::GetData(outputs, Filter::SUMMARY));
  remesh::writeComparisonHistograms(
    comparison, bins, vtkTable::GetData(outputs, Filter::HISTOGRAMS));
}

/** In the filter's threads and back-end. */
remesh::Status execute(vtkSurfaceMeshComparison* filter, vtkInformationVector** inputs,
  vtkInformationVector* outputs, Compared& surfaces)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* reference = vtkPolyData::GetData(inputs[1]);
  remesh::DistanceOptions options;
  options.numberOfSamples = filter->GetNumberOfSamples();
  options.boundTolerance = filter->GetBoundMaximumDistance() ? 0.01 : -1.0;
  options.negligible = 1e-6;
  options.maximumParts = partsPerSample * filter->GetNumberOfSamples();
  remesh::Execution execution;
  return remesh::runFilter(
    filter, filter->GetSMPBackend(), filter->GetNumberOfThreads(),
    [&]()
    {
      remesh::Status compared =
        readAndCompare(mesh, reference, options, remesh::makeRunControl(filter), surfaces);
      if (compared.ok())
      {
        writeOutputs(mesh, reference, surfaces, filter->GetNumberOfBins(), outputs);
      }
      return compared;
    },
    execution);
}
}

vtkSurfaceMeshComparison::vtkSurfaceMeshComparison()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

vtkSurfaceMeshComparison::~vtkSurfaceMeshComparison() = default;

void vtkSurfaceMeshComparison::SetReferenceConnection(vtkAlgorithmOutput* port)
{
  this->SetInputConnection(1, port);
}

void vtkSurfaceMeshComparison::SetReferenceData(vtkDataObject* reference)
{
  this->SetInputData(1, reference);
}

vtkPolyData* vtkSurfaceMeshComparison::GetReferenceOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(REFERENCE));
}

vtkTable* vtkSurfaceMeshComparison::GetSummaryOutput()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(SUMMARY));
}

vtkTable* vtkSurfaceMeshComparison::GetHistogramsOutput()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(HISTOGRAMS));
}

int vtkSurfaceMeshComparison::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkSurfaceMeshComparison::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port >= SUMMARY)
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
    return 1;
  }
  return this->Superclass::FillOutputPortInformation(port, info);
}

int vtkSurfaceMeshComparison::GetStructurePort(int outputPort) const
{
  return outputPort == REFERENCE ? 1 : 0;
}

bool vtkSurfaceMeshComparison::PassesInput(int outputPort) const
{
  return outputPort == REFERENCE;
}

int vtkSurfaceMeshComparison::RequestWhole(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  remesh::ParameterCheck check;
  check.within("NumberOfSamples", this->NumberOfSamples, 1, 1000000000)
    .within("NumberOfBins", this->NumberOfBins, 1, 10000)
    .within("NumberOfThreads", this->NumberOfThreads, 0, 1024)
    .within("SMPBackend", this->SMPBackend, SMP_AUTOMATIC, SMP_TBB);
  if (!check.status().ok())
  {
    remesh::emptyPorts(outputVector);
    return remesh::reportEnd(this, check.status());
  }
  Compared surfaces;
  const remesh::Status status = execute(this, inputVector, outputVector, surfaces);
  if (!status.ok())
  {
    remesh::emptyPorts(outputVector);
  }
  std::string distribution = remesh::describeDistribution(inputVector[0]);
  if (distribution.empty())
  {
    distribution = remesh::describeDistribution(inputVector[1]);
  }
  remesh::showWarnings(this, { distribution });
  if (surfaces.referenceIsEmpty)
  {
    vtkWarningMacro("The reference surface is empty: the mesh is measured alone.");
  }
  return remesh::reportEnd(this, status);
}

void vtkSurfaceMeshComparison::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "BoundMaximumDistance: " << this->BoundMaximumDistance << "\n";
  os << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "SMPBackend: " << this->SMPBackend << "\n";
}
