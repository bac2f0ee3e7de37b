#include "vtkAnisotropicRemesher.h"

#include "vtkEmbeddedSurfaceInternals.h"

#include "Adaptors/OutputPorts.h"
#include "Adaptors/ParameterCheck.h"
#include "Adaptors/SurfaceIntake.h"
#include "Pipeline/RunRequest.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkAnisotropicRemesher);

vtkAnisotropicRemesher::vtkAnisotropicRemesher()
{
  this->SetSeamArray(nullptr);
}

vtkAnisotropicRemesher::~vtkAnisotropicRemesher() = default;

int vtkAnisotropicRemesher::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

void vtkAnisotropicRemesher::SetInitialSitesConnection(vtkAlgorithmOutput* port)
{
  this->SetInputConnection(1, port);
}

void vtkAnisotropicRemesher::SetInitialSitesData(vtkDataObject* sites)
{
  this->SetInputData(1, sites);
}

void vtkAnisotropicRemesher::SetFeatureLabelArray(const char* name)
{
  this->SetInputArrayToProcess(2, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name ? name : "");
}

void vtkAnisotropicRemesher::SetSeamArray(const char* name)
{
  const bool isAutomatic = !name || !*name || name == std::string("Automatic");
  if (isAutomatic)
  {
    this->SetInputArrayToProcess(
      4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::TCOORDS);
    return;
  }
  this->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

remesh::Status vtkAnisotropicRemesher::CheckParameters()
{
  remesh::ParameterCheck check;
  check.within("DistanceTolerance", this->DistanceTolerance, 0.0, VTK_DOUBLE_MAX)
    .within("MaximumNumberOfPoints", this->MaximumNumberOfPoints, 4, VTK_ID_MAX)
    .within("MetricComplexity", this->MetricComplexity, 0.0, VTK_DOUBLE_MAX)
    .within("FeatureAngle", this->FeatureAngle, 0.0, 180.0)
    .within("MaximumNumberOfExtraPoints", this->MaximumNumberOfExtraPoints, ONE_PERCENT, VTK_ID_MAX)
    .within("SamplingMethod", this->SamplingMethod, RANDOM, STRATIFIED)
    .within("NumberOfLloydIterations", this->NumberOfLloydIterations, 0, 100000)
    .within("NumberOfNewtonIterations", this->NumberOfNewtonIterations, 0, 100000)
    .within("HistoryLength", this->HistoryLength, 1, 100)
    .within("GradientTolerance", this->GradientTolerance, 0.0, 1.0)
    .within("EnergyTolerance", this->EnergyTolerance, 0.0, 1.0);
  return check.status().ok() ? this->Superclass::CheckParameters() : check.status();
}

remesh::RemeshOptions vtkAnisotropicRemesher::MakeOptions() const
{
  remesh::RemeshOptions options;
  options.numberOfSites = this->NumberOfPoints;
  options.sampling = this->SamplingMethod == RANDOM ? remesh::SamplingMethod::Random
                                                    : remesh::SamplingMethod::Stratified;
  options.coarseStart = this->CoarseStart;
  options.seed = static_cast<std::uint64_t>(this->Seed);
  options.lloydIterations = this->NumberOfLloydIterations;
  options.quasiNewton.iterations = this->NumberOfNewtonIterations;
  options.quasiNewton.historyLength = this->HistoryLength;
  options.quasiNewton.gradientTolerance = this->GradientTolerance;
  options.quasiNewton.energyTolerance = this->EnergyTolerance;
  return options;
}

int vtkAnisotropicRemesher::RequestWhole(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* initialSites = vtkPointSet::GetData(inputVector[1]);
  const bool isTolerance = this->DistanceTolerance > 0.0 && !initialSites;
  const vtkIdType points = initialSites ? initialSites->GetNumberOfPoints()
    : isTolerance                       ? 0 // a number asked for does not count
                                        : this->NumberOfPoints;
  const bool isEmpty = remesh::checkForPolygons(vtkPolyData::GetData(inputVector[0])).code ==
    remesh::StatusCode::EmptyInput;
  if (this->UnitEdges && (isTolerance || initialSites))
  {
    vtkErrorMacro("UnitEdges and a distance tolerance or initial sites both decide the number of "
                  "points: choose one.");
    remesh::emptyPorts(outputVector);
    return 0;
  }
  if (points < 4 && !isTolerance && !isEmpty && !this->UnitEdges)
  {
    vtkErrorMacro("A mesh needs at least 4 points; "
      << points << (initialSites ? " initial sites were given." : " were asked for."));
    remesh::emptyPorts(outputVector);
    return 0;
  }
  remesh::RunRequest request;
  request.preparation.preserveFeatures = this->PreserveFeatures && !initialSites;
  request.preparation.featureAngle = this->FeatureAngle;
  const bool isOnePercent = this->MaximumNumberOfExtraPoints == ONE_PERCENT;
  request.tolerance = { isTolerance ? this->DistanceTolerance : 0.0,
    this->DistanceToleranceIsAbsolute, this->MaximumNumberOfPoints, isOnePercent };
  request.unit = { this->UnitEdges, this->MetricComplexity };
  request.options = this->MakeOptions();
  request.options.exactNumber = request.preparation.preserveFeatures;
  request.options.maximumExtraPoints = isOnePercent ? points / 100
    : this->MaximumNumberOfExtraPoints == UNLIMITED ? remesh::maximumIndex
                                                    : this->MaximumNumberOfExtraPoints;
  const int done = this->ComputeDiagram(inputVector, outputVector, std::move(request));
  if (done && !isEmpty && initialSites && this->DistanceTolerance > 0.0)
  {
    vtkWarningMacro("The distance tolerance does not count: initial sites give the number of "
                    "points.");
  }
  return done;
}

void vtkAnisotropicRemesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "UnitEdges: " << this->UnitEdges << "\n";
  os << indent << "MetricComplexity: " << this->MetricComplexity << "\n";
  os << indent << "DistanceTolerance: " << this->DistanceTolerance << "\n";
  os << indent << "DistanceToleranceIsAbsolute: " << this->DistanceToleranceIsAbsolute << "\n";
  os << indent << "MaximumNumberOfPoints: " << this->MaximumNumberOfPoints << "\n";
  os << indent << "PreserveFeatures: " << this->PreserveFeatures << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MaximumNumberOfExtraPoints: " << this->MaximumNumberOfExtraPoints << "\n";
  os << indent << "SamplingMethod: " << this->SamplingMethod << "\n";
  os << indent << "CoarseStart: " << this->CoarseStart << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "NumberOfLloydIterations: " << this->NumberOfLloydIterations << "\n";
  os << indent << "NumberOfNewtonIterations: " << this->NumberOfNewtonIterations << "\n";
  os << indent << "HistoryLength: " << this->HistoryLength << "\n";
  os << indent << "GradientTolerance: " << this->GradientTolerance << "\n";
  os << indent << "EnergyTolerance: " << this->EnergyTolerance << "\n";
}
