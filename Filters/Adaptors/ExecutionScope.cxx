#include "Adaptors/ExecutionScope.h"

#include "vtkSMP.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <thread>

namespace remesh
{
namespace
{
/** Whether this VTK was built with a back-end; asking vtkSMPTools for one it lacks prints. */
bool hasBackend(const std::string& backend)
{
  return backend == "Sequential" || (backend == "STDThread" && VTK_SMP_ENABLE_STDTHREAD) ||
    (backend == "TBB" && VTK_SMP_ENABLE_TBB);
}
}

Execution chooseExecution(const std::string& backend, int threads, bool& available)
{
  available = backend.empty() || hasBackend(backend);
  if (!backend.empty() && available)
  {
    return { backend, threads };
  }
  const std::string current = vtkSMPTools::GetBackend();
  return { current == "Sequential" ? "STDThread" : current, threads };
}

void runInScope(Execution& execution, const std::function<void()>& work)
{
  // More threads than processors gain nothing, and make TBB, which is set up with any back-end,
  // warn on the terminal.
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  execution.threads = std::min(execution.threads, processors);
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ execution.threads, execution.backend, false },
    [&]()
    {
      execution.backend = vtkSMPTools::GetBackend();
      execution.threads = vtkSMPTools::GetEstimatedNumberOfThreads();
      work();
    });
}
}
