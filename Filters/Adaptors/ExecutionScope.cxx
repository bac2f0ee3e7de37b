#include "Adaptors/ExecutionScope.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <thread>

namespace remesh
{
namespace
{
/** Whether vtkSMPTools has a back-end, found by trying it once. */
bool hasBackend(const std::string& backend)
{
  const std::string before = vtkSMPTools::GetBackend();
  if (before == backend)
  {
    return true;
  }
  const bool has = vtkSMPTools::SetBackend(backend.c_str());
  vtkSMPTools::SetBackend(before.c_str());
  return has;
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
