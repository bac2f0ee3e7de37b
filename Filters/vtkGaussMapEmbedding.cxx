#include "vtkGaussMapEmbedding.h"

#include "vtkEmbeddedSurfaceInternals.h"

#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/Distribution.h"
#include "Adaptors/ParameterCheck.h"
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

bool vtkGaussMapEmbedding::PassesInput(int) const
{
  return true;
}

namespace
{
/** One tuple per input point: its corner's, or its position and zeros where it has none. */
void addEmbedding(const remesh::PreparedSurface& prepared, bool positionFirst, vtkPolyData* output)
{
  const int d = prepared.coordinates.dimension;
  const remesh::Columns columns{ output->GetPointData(), output->GetNumberOfPoints(), {} };
  const auto array = columns.addEmpty<vtkDoubleArray>("Embedding", d);
  array->Fill(0.0);
  for (vtkIdType point = 0; positionFirst && point < output->GetNumberOfPoints(); ++point)
  {
    output->GetPoint(point, array->GetPointer(point * d));
  }
  const remesh::SurfaceMesh& mesh = prepared.mesh;
  std::vector<double> scratch;
  for (std::size_t f = 0; f < mesh.facetCorners.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      std::copy_n(prepared.coordinates.row(mesh.facetCorners[f][k], scratch), d,
        array->GetPointer(mesh.facetInputPoints[f][k] * d));
    }
  }
}
}

remesh::Status vtkGaussMapEmbedding::CheckParameters()
{
  remesh::ParameterCheck check;
  check.within("NumberOfPoints", this->NumberOfPoints, 1, VTK_ID_MAX);
  return check.status().ok() ? this->Superclass::CheckParameters() : check.status();
}

int vtkGaussMapEmbedding::RequestWhole(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  auto& facts = this->Internals->LastRun;
  remesh::PreparedSurface prepared;
  remesh::PreparationRequest request;
  const auto outcome = vtkInternals::Execute(this, outputVector,
    [&]() -> remesh::Status
    {
      remesh::Status status = vtkInternals::MakeRequest(this, inputVector, request);
      request.numberOfSites = this->NumberOfPoints;
      request.mayLend = true;
      if (status.ok())
      {
        status = remesh::prepareSurface(request, remesh::makeRunControl(this), prepared);
      }
      facts.Intake = prepared.intake;
      if (status.ok())
      {
        output->ShallowCopy(input);
        addEmbedding(prepared, !request.embedding, output);
      }
      return status;
    });
  if (outcome != vtkInternals::Outcome::Done)
  {
    return outcome == vtkInternals::Outcome::Nothing;
  }
  prepared.warnings.push_back(remesh::describeDistribution(inputVector[0]));
  remesh::showWarnings(this, prepared.warnings);
  return 1;
}

void vtkGaussMapEmbedding::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
}
