#include "vtkSurfaceFieldAlgorithm.h"

#include "Adaptors/Distribution.h"
#include "Adaptors/ExecutionScope.h"
#include "Adaptors/FieldSurface.h"
#include "Adaptors/OutputPorts.h"
#include "Adaptors/ParameterCheck.h"
#include "Adaptors/ProgressAdaptor.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"

vtkSurfaceFieldAlgorithm::vtkSurfaceFieldAlgorithm() = default;
vtkSurfaceFieldAlgorithm::~vtkSurfaceFieldAlgorithm() = default;

bool vtkSurfaceFieldAlgorithm::PassesInput(int) const
{
  return true;
}

int vtkSurfaceFieldAlgorithm::RequestWhole(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  remesh::ParameterCheck check;
  check.within("NumberOfThreads", this->NumberOfThreads, 0, 1024)
    .within("SMPBackend", this->SMPBackend, SMP_AUTOMATIC, SMP_TBB);
  remesh::FieldSurface surface;
  surface.input = vtkPolyData::GetData(inputVector[0]);
  surface.output = vtkPolyData::GetData(outputVector);
  surface.control = remesh::makeRunControl(this);
  remesh::Status status = check.status().ok() ? this->CheckParameters() : check.status();
  if (status.ok())
  {
    remesh::Execution execution;
    status = remesh::runFilter(
      this, this->SMPBackend, this->NumberOfThreads,
      [&]()
      {
        const remesh::Status taken = remesh::takeFieldSurface(surface);
        return taken.ok() ? this->AddField(surface) : taken;
      },
      execution);
  }
  if (!status.ok())
  {
    remesh::emptyPorts(outputVector);
  }
  if (status.code == remesh::StatusCode::EmptyInput && surface.intake.dropped() > 0)
  {
    surface.warnings.push_back(status.message);
  }
  surface.warnings.push_back(remesh::describeDistribution(inputVector[0]));
  const int done = remesh::reportEnd(this, status);
  if (done)
  {
    remesh::showWarnings(this, surface.warnings);
  }
  return done;
}

void vtkSurfaceFieldAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "SMPBackend: " << this->SMPBackend << "\n";
}
