#include "vtkRestrictedVoronoiDiagram.h"

#include "Pipeline/RunRequest.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkRestrictedVoronoiDiagram);

vtkRestrictedVoronoiDiagram::vtkRestrictedVoronoiDiagram() = default;
vtkRestrictedVoronoiDiagram::~vtkRestrictedVoronoiDiagram() = default;

void vtkRestrictedVoronoiDiagram::SetSitesConnection(vtkAlgorithmOutput* port)
{
  this->SetInputConnection(1, port);
}

void vtkRestrictedVoronoiDiagram::SetSitesData(vtkDataObject* sites)
{
  this->SetInputData(1, sites);
}

int vtkRestrictedVoronoiDiagram::RequestWhole(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  remesh::RunRequest request;
  request.options.optimize = false;
  return this->ComputeDiagram(inputVector, outputVector, std::move(request));
}

void vtkRestrictedVoronoiDiagram::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
