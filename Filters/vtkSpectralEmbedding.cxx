#include "vtkSpectralEmbedding.h"

#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/FieldSurface.h"
#include "Adaptors/ParameterCheck.h"
#include "Spectrum/SpectralEmbedding.h"

#include "vtkFieldData.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSpectralEmbedding);

vtkSpectralEmbedding::vtkSpectralEmbedding() = default;
vtkSpectralEmbedding::~vtkSpectralEmbedding() = default;

remesh::Status vtkSpectralEmbedding::CheckParameters()
{
  remesh::ParameterCheck check;
  check.within("Dimension", this->Dimension, 2, 100000)
    .within("Scaling", this->Scaling, NONE, BIHARMONIC)
    .within("DiffusionTime", this->DiffusionTime, 0.0, VTK_DOUBLE_MAX)
    .within("MassMatrix", this->MassMatrix, LUMPED, CONSISTENT)
    .within("BorderCondition", this->BorderCondition, NATURAL, FIXED);
  return check.status();
}

remesh::Status vtkSpectralEmbedding::AddField(remesh::FieldSurface& surface)
{
  remesh::SpectralOptions options;
  options.dimension = this->Dimension;
  options.scaling = static_cast<remesh::SpectralScaling>(this->Scaling);
  options.time = this->DiffusionTime;
  options.mass = static_cast<remesh::MassMatrix>(this->MassMatrix);
  options.border = static_cast<remesh::BorderCondition>(this->BorderCondition);
  remesh::SpectralEmbedding embedding;
  remesh::RunControl control = surface.control;
  control.enterPhase("Eigenfunctions", 0.0, 1.0);
  remesh::Status status = remesh::embedSpectrally(surface.mesh, options, control, embedding);
  if (!status.ok())
  {
    return status;
  }
  remesh::addPointField(surface, "Embedding", this->Dimension,
    [&](remesh::Index point, double* tuple)
    {
      const remesh::Index row =
        point == remesh::noIndex ? remesh::noIndex : embedding.unknowns[point];
      for (int k = 0; k < this->Dimension; ++k)
      {
        tuple[k] = row == remesh::noIndex ? 0.0 : embedding.functions(row, k);
      }
    });
  const remesh::Columns facts{ surface.output->GetFieldData(), this->Dimension, control.silent() };
  facts.add<vtkDoubleArray>(
    "Eigenvalues", [&](remesh::Offset k) { return embedding.eigenvalues[k]; });
  return control.cancelled() ? remesh::Status::cancelled() : remesh::Status::success();
}

void vtkSpectralEmbedding::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimension: " << this->Dimension << "\n";
  os << indent << "Scaling: " << this->Scaling << "\n";
  os << indent << "DiffusionTime: " << this->DiffusionTime << "\n";
  os << indent << "MassMatrix: " << this->MassMatrix << "\n";
  os << indent << "BorderCondition: " << this->BorderCondition << "\n";
}
