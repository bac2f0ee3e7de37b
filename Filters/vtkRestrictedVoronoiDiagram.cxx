#include "vtkRestrictedVoronoiDiagram.h"

#include "Remesh.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"

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
  remesh::RemeshOptions options;
  options.optimize = false;
  return this->ComputeDiagram(
    inputVector, outputVector, options, vtkPointSet::GetData(inputVector[1]), 0);
}

void vtkRestrictedVoronoiDiagram::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
