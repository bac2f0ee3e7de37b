#include "vtkMetricEmbedding.h"

#include "Adaptors/MetricOutput.h"
#include "Adaptors/ParameterCheck.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMetricEmbedding);

vtkMetricEmbedding::vtkMetricEmbedding() = default;

vtkMetricEmbedding::~vtkMetricEmbedding()
{
  this->SetMetricArray(nullptr);
}

bool vtkMetricEmbedding::PassesInput(int) const
{
  return false;
}

remesh::Status vtkMetricEmbedding::CheckParameters()
{
  remesh::ParameterCheck check;
  check.within("MetricOrder", this->MetricOrder, METRIC_VTK, METRIC_SOL)
    .within("NumberOfPoints", this->NumberOfPoints, 1, VTK_ID_MAX)
    .within("MetricComplexity", this->MetricComplexity, 0.0, VTK_DOUBLE_MAX)
    .within("Dimension", this->Dimension, 3, remesh::maxEmbeddingDimensions)
    .within("MetricGrowth", this->MetricGrowth, 1.01, 1000.0)
    .within("NumberOfIterations", this->NumberOfIterations, 0, 100000)
    .within("EnergyTolerance", this->EnergyTolerance, 0.0, 1.0);
  return check.status();
}

remesh::Status vtkMetricEmbedding::AddField(remesh::FieldSurface& surface)
{
  remesh::MetricRequest request;
  request.array = this->MetricArray ? this->MetricArray : "";
  if (request.array.empty() || request.array == "None")
  {
    return remesh::Status::invalid("There is no metric to embed: choose a MetricArray.");
  }
  request.order = static_cast<remesh::TensorOrder>(this->MetricOrder);
  request.isUnit = this->UnitEdges;
  request.complexity = this->MetricComplexity;
  remesh::MetricOptions& options = request.options;
  options.dimension = this->Dimension;
  options.sites = this->NumberOfPoints;
  options.isLimited = this->LimitMetric;
  options.growth = this->MetricGrowth;
  options.mayRefine = this->Refine;
  options.iterations = this->NumberOfIterations;
  options.energyDecrease = this->EnergyTolerance;
  return remesh::addMetricEmbedding(request, surface);
}

void vtkMetricEmbedding::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MetricArray: " << (this->MetricArray ? this->MetricArray : "(none)") << "\n";
  os << indent << "MetricOrder: " << this->MetricOrder << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "UnitEdges: " << this->UnitEdges << "\n";
  os << indent << "MetricComplexity: " << this->MetricComplexity << "\n";
  os << indent << "Dimension: " << this->Dimension << "\n";
  os << indent << "Refine: " << this->Refine << "\n";
  os << indent << "LimitMetric: " << this->LimitMetric << "\n";
  os << indent << "MetricGrowth: " << this->MetricGrowth << "\n";
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
  os << indent << "EnergyTolerance: " << this->EnergyTolerance << "\n";
}
