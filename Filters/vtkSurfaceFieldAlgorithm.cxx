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
  const bool isDropped =
    status.code == remesh::StatusCode::EmptyInput && surface.intake.dropped() > 0;
  if (isDropped)
  {
    surface.warnings.push_back(status.message);
  }
  if (const std::string spread = remesh::describeDistribution(inputVector[0]); !spread.empty())
  {
    surface.warnings.push_back(spread);
  }
  if (status.ok() || status.code == remesh::StatusCode::EmptyInput ||
    status.code == remesh::StatusCode::Cancelled)
  {
    for (const std::string& warning : surface.warnings)
    {
      vtkWarningMacro(<< warning);
    }
    return 1; // the last two leave empty outputs
  }
  vtkErrorMacro(<< status.message);
  return 0;
}

void vtkSurfaceFieldAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "SMPBackend: " << this->SMPBackend << "\n";
}
