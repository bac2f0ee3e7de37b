#include "RunParts.h"

#include "Adaptors/ExecutionScope.h"
#include "Optimization/Lloyd.h"

#include <stdexcept>

namespace remesh::benchmark
{
void orThrow(const Status& status)
{
  if (!status.ok())
  {
    throw std::runtime_error(status.message);
  }
}

void inScope(const Settings& settings, const std::function<void()>& work)
{
  bool available = false;
  Execution execution = chooseExecution("", settings.threads, available);
  runInScope(execution, work);
}

void Optimization::run(const EmbeddedSurface& surface, int lloyd, int newton)
{
  orThrow(relaxLloyd(
    { this->voronoi, surface, 0, this->sites, this->sums, this->convergence, this->emptyCells },
    lloyd, RunControl()));
  QuasiNewtonOptions options;
  options.iterations = newton;
  orThrow(minimizeQuasiNewton(
    { this->voronoi, surface, 0, this->sites, this->sums, this->convergence, this->emptyCells },
    options, RunControl()));
}
}
