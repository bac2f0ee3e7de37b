#include "vtkGaussMapEmbedding.h"

#include "vtkEmbeddedSurfaceInternals.h"

#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/ProgressAdaptor.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkGaussMapEmbedding);

vtkGaussMapEmbedding::vtkGaussMapEmbedding() = default;
vtkGaussMapEmbedding::~vtkGaussMapEmbedding() = default;

namespace
{
/** One tuple per input point: its corner's, or its position and zeros where it has none. */
void addEmbedding(const remesh::PreparedSurface& prepared, bool positionFirst, vtkPolyData* output)
{
  const int d = prepared.coordinates.dimension;
  const auto array = remesh::addArray<vtkDoubleArray>(
    output->GetPointData(), "Embedding", output->GetNumberOfPoints(), d);
  array->Fill(0.0);
  for (vtkIdType point = 0; positionFirst && point < output->GetNumberOfPoints(); ++point)
  {
    output->GetPoint(point, array->GetPointer(point * d));
  }
  const remesh::SurfaceMesh& mesh = prepared.mesh;
  for (std::size_t f = 0; f < mesh.facetCorners.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double* values = prepared.coordinates.values.data() +
        static_cast<std::size_t>(mesh.facetCorners[f][k]) * static_cast<std::size_t>(d);
      std::copy_n(values, d, array->GetPointer(mesh.facetInputPoints[f][k] * d));
    }
  }
}
}

int vtkGaussMapEmbedding::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  auto& facts = this->Internals->LastRun;
  facts = {};
  remesh::PreparedSurface prepared;
  remesh::PreparationRequest request;
  const auto outcome = vtkInternals::Execute(this,
    [&]() -> remesh::Status
    {
      remesh::Status status = vtkInternals::MakeRequest(this, inputVector, request);
      if (status.ok())
      {
        status = remesh::prepareSurface(input, request, remesh::makeRunControl(this), prepared);
      }
      facts.Intake = prepared.intake;
      return status;
    });
  if (outcome != vtkInternals::Outcome::Done)
  {
    return outcome == vtkInternals::Outcome::Nothing;
  }
  for (const std::string& warning : prepared.warnings)
  {
    vtkWarningMacro(<< warning);
  }
  output->ShallowCopy(input);
  addEmbedding(prepared, request.embedding == nullptr, output);
  return 1;
}

void vtkGaussMapEmbedding::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
