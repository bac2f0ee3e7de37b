#include "vtkEmbeddedSurfaceAlgorithm.h"

#include "vtkEmbeddedSurfaceInternals.h"

#include "Adaptors/CellLabels.h"
#include "Adaptors/ChosenArrays.h"
#include "Adaptors/OutputPorts.h"
#include "Adaptors/ParameterCheck.h"
#include "Adaptors/PointArrays.h"
#include "Adaptors/SurfaceIntake.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

vtkEmbeddedSurfaceAlgorithm::vtkEmbeddedSurfaceAlgorithm()
  : Internals(new vtkInternals)
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::NORMALS);
}

vtkEmbeddedSurfaceAlgorithm::~vtkEmbeddedSurfaceAlgorithm() = default;

void vtkEmbeddedSurfaceAlgorithm::ForgetLastRun()
{
  this->Internals->LastRun = {};
}

void vtkEmbeddedSurfaceAlgorithm::AddCoordinateArray(const char* name, double scale)
{
  if (!name || !*name || !std::isfinite(scale))
  {
    vtkErrorMacro("A coordinate array needs a name and a finite scale.");
    return;
  }
  this->Internals->CoordinateArrays.emplace_back(name, scale);
  this->Modified();
}

void vtkEmbeddedSurfaceAlgorithm::ClearCoordinateArrays()
{
  if (!this->Internals->CoordinateArrays.empty())
  {
    this->Internals->CoordinateArrays.clear();
    this->Modified();
  }
}

int vtkEmbeddedSurfaceAlgorithm::GetNumberOfCoordinateArrays() const
{
  return static_cast<int>(this->Internals->CoordinateArrays.size());
}

const char* vtkEmbeddedSurfaceAlgorithm::GetCoordinateArrayName(int index) const
{
  const auto& arrays = this->Internals->CoordinateArrays;
  return index >= 0 && index < this->GetNumberOfCoordinateArrays() ? arrays[index].first.c_str()
                                                                   : nullptr;
}

double vtkEmbeddedSurfaceAlgorithm::GetCoordinateArrayScale(int index) const
{
  const auto& arrays = this->Internals->CoordinateArrays;
  return index >= 0 && index < this->GetNumberOfCoordinateArrays() ? arrays[index].second : 0.0;
}

void vtkEmbeddedSurfaceAlgorithm::SetEmbeddingArray(const char* name)
{
  this->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name ? name : "");
}

void vtkEmbeddedSurfaceAlgorithm::SetMetricArray(const char* name)
{
  this->SetInputArrayToProcess(5, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name ? name : "");
}

vtkIdType vtkEmbeddedSurfaceAlgorithm::GetNumberOfInputComponents() const
{
  return this->Internals->LastRun.Intake.components;
}

vtkIdType vtkEmbeddedSurfaceAlgorithm::GetNumberOfDroppedTriangles() const
{
  return this->Internals->LastRun.Intake.dropped();
}

vtkIdType vtkEmbeddedSurfaceAlgorithm::GetNumberOfMergedPoints() const
{
  return this->Internals->LastRun.Intake.mergedPoints;
}

const char* vtkEmbeddedSurfaceAlgorithm::GetUsedBackend() const
{
  return this->Internals->LastRun.Execution.backend.c_str();
}

int vtkEmbeddedSurfaceAlgorithm::GetNumberOfUsedThreads() const
{
  return this->Internals->LastRun.Execution.threads;
}

remesh::Status vtkEmbeddedSurfaceAlgorithm::CheckParameters()
{
  remesh::ParameterCheck check;
  check.within("EmbeddingMode", this->EmbeddingMode, POSITION, GAUSS_MAP)
    .within("Anisotropy", this->Anisotropy, 0.0, 1.0)
    .within("NormalSmoothingPasses", this->NormalSmoothingPasses, -1, 10000)
    .within("NormalSmoothingRadius", this->NormalSmoothingRadius, -1.0, VTK_DOUBLE_MAX)
    .within("MergeTolerance", this->MergeTolerance, 0.0, 0.1)
    .within("MetricOrder", this->MetricOrder, METRIC_VTK, METRIC_SOL)
    .within("MetricDimension", this->MetricDimension, 3, remesh::maxEmbeddingDimensions)
    .within("MetricGrowth", this->MetricGrowth, 1.01, 1000.0)
    .within("NumberOfThreads", this->NumberOfThreads, 0, 1024)
    .within("SMPBackend", this->SMPBackend, SMP_AUTOMATIC, SMP_TBB);
  return check.status();
}

namespace
{
/** The labels that features are to keep apart. */
remesh::Status findLabels(
  vtkInformation* choice, vtkPolyData* input, remesh::PreparationRequest& request)
{
  vtkAbstractArray* labels = nullptr;
  remesh::Status status = remesh::findCellArray(choice, input, "labels", labels);
  if (status.ok() && labels && request.preserveFeatures)
  {
    status = remesh::readCellLabels(labels, input->GetNumberOfCells(), request.cellLabels);
  }
  if (status.ok() && request.preserveFeatures)
  {
    remesh::addRegions(input, request.cellLabels);
  }
  return status;
}

/** What is active is taken if it is there; with "None", nothing is told of jumps either. */
remesh::Status findSeams(
  vtkInformation* choice, vtkPolyData* input, remesh::PreparationRequest& request)
{
  if (remesh::isChosenByName(choice) &&
    choice->Get(vtkDataObject::FIELD_NAME()) == std::string("None"))
  {
    return remesh::Status::success();
  }
  request.carried = remesh::carriedPointArrays(input);
  if (remesh::isPointAttribute(choice, vtkDataSetAttributes::TCOORDS))
  {
    request.seams = remesh::lentArray(input->GetPointData()->GetTCoords());
    return remesh::Status::success();
  }
  return remesh::findPointArray(choice, input, "seams", request.seams);
}
}

remesh::Status vtkEmbeddedSurfaceAlgorithm::vtkInternals::FindNormals(
  vtkEmbeddedSurfaceAlgorithm* self, vtkPolyData* input, remesh::PreparationRequest& request)
{
  if (self->EstimateNormals)
  {
    return remesh::Status::success();
  }
  vtkInformation* choice = self->GetInputArrayInformation(0);
  const bool isAutomatic = remesh::isPointAttribute(choice, vtkDataSetAttributes::NORMALS) ||
    (remesh::isChosenByName(choice) &&
      choice->Get(vtkDataObject::FIELD_NAME()) == std::string("Automatic"));
  if (isAutomatic) // what is active is taken if it is there
  {
    request.normals = remesh::lentArray(input->GetPointData()->GetNormals());
    return remesh::Status::success();
  }
  request.normalsRequired = true;
  return remesh::findPointArray(choice, input, "normals", request.normals);
}

remesh::Status vtkEmbeddedSurfaceAlgorithm::vtkInternals::FindArrays(
  vtkEmbeddedSurfaceAlgorithm* self, vtkPolyData* input, remesh::PreparationRequest& request)
{
  remesh::Status status = FindNormals(self, input, request);
  const auto find = [&](int index, const char* role, std::optional<remesh::PointArray>& array)
  {
    if (status.ok())
    {
      status = remesh::findPointArray(self->GetInputArrayInformation(index), input, role, array);
    }
  };
  find(1, "embedding", request.embedding);
  find(5, "metric", request.metric);
  find(3, "density", request.density);
  if (status.ok())
  {
    status = findLabels(self->GetInputArrayInformation(2), input, request);
  }
  if (status.ok())
  {
    status = findSeams(self->GetInputArrayInformation(4), input, request);
  }
  for (const auto& [name, scale] : self->Internals->CoordinateArrays)
  {
    vtkDataArray* array = input->GetPointData()->GetArray(name.c_str());
    if (status.ok() && !array)
    {
      status = remesh::Status::invalid("The input has no numeric point array \"" + name +
        "\", chosen as coordinates of the embedding.");
    }
    if (status.ok())
    {
      request.coordinates.emplace_back(*remesh::lentArray(array), scale);
    }
  }
  return status;
}

remesh::Status vtkEmbeddedSurfaceAlgorithm::vtkInternals::MakeRequest(
  vtkEmbeddedSurfaceAlgorithm* self, vtkInformationVector** inputVector,
  remesh::PreparationRequest& request)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  if (remesh::Status status = remesh::checkForPolygons(input); !status.ok())
  {
    return status;
  }
  request.source = remesh::sourceOf(input);
  request.gaussMap = self->EmbeddingMode == GAUSS_MAP;
  request.anisotropy = self->Anisotropy;
  request.normalSmoothingPasses = self->NormalSmoothingPasses;
  request.smoothingRadius = self->NormalSmoothingRadius;
  request.mergeTolerance = self->MergeTolerance;
  request.metricOrder = static_cast<remesh::TensorOrder>(self->MetricOrder);
  request.metricDimension = self->MetricDimension;
  request.limitMetric = self->LimitMetric;
  request.metricGrowth = self->MetricGrowth;
  remesh::Status status = FindArrays(self, input, request);
  return status.ok() && request.metric && (request.embedding || !request.coordinates.empty())
    ? remesh::Status::invalid(
        "A metric is an embedding: choose it, or an embedding and coordinate arrays.")
    : status;
}

vtkEmbeddedSurfaceAlgorithm::vtkInternals::Outcome
vtkEmbeddedSurfaceAlgorithm::vtkInternals::Execute(vtkEmbeddedSurfaceAlgorithm* self,
  vtkInformationVector* outputVector, const std::function<remesh::Status()>& work)
{
  remesh::Status status = self->CheckParameters();
  if (status.ok())
  {
    status = remesh::runFilter(
      self, self->SMPBackend, self->NumberOfThreads, work, self->Internals->LastRun.Execution);
  }
  if (!status.ok())
  {
    remesh::emptyPorts(outputVector);
  }
  switch (status.code)
  {
    case remesh::StatusCode::Ok:
      return Outcome::Done;
    case remesh::StatusCode::EmptyInput:
      if (self->Internals->LastRun.Intake.dropped() > 0)
      {
        vtkWarningWithObjectMacro(self, << status.message);
      }
      return Outcome::Nothing;
    case remesh::StatusCode::Cancelled:
      return Outcome::Nothing; // a failure would make the executive report an error
    default:
      vtkErrorWithObjectMacro(self, << status.message);
      return Outcome::Failed;
  }
}

void vtkEmbeddedSurfaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "EmbeddingMode: " << this->EmbeddingMode << "\n";
  os << indent << "Anisotropy: " << this->Anisotropy << "\n";
  os << indent << "EstimateNormals: " << this->EstimateNormals << "\n";
  os << indent << "NormalSmoothingPasses: " << this->NormalSmoothingPasses << "\n";
  os << indent << "NormalSmoothingRadius: " << this->NormalSmoothingRadius << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "MetricOrder: " << this->MetricOrder << "\n";
  os << indent << "MetricDimension: " << this->MetricDimension << "\n";
  os << indent << "LimitMetric: " << this->LimitMetric << "\n";
  os << indent << "MetricGrowth: " << this->MetricGrowth << "\n";
  os << indent << "CoordinateArrays: " << this->GetNumberOfCoordinateArrays() << "\n";
  for (const auto& [name, scale] : this->Internals->CoordinateArrays)
  {
    os << indent.GetNextIndent() << name << " * " << scale << "\n";
  }
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "SMPBackend: " << this->SMPBackend << "\n";
  os << indent << "NumberOfInputComponents: " << this->GetNumberOfInputComponents() << "\n";
  os << indent << "NumberOfDroppedTriangles: " << this->GetNumberOfDroppedTriangles() << "\n";
  os << indent << "NumberOfMergedPoints: " << this->GetNumberOfMergedPoints() << "\n";
  os << indent << "UsedBackend: " << this->GetUsedBackend() << "\n";
  os << indent << "NumberOfUsedThreads: " << this->GetNumberOfUsedThreads() << "\n";
}
