#include "Adaptors/ExecutionScope.h"

#include "vtkObject.h"
#include "vtkSMP.h"
#include "vtkSMPTools.h"
#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <new>
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

/**
 * VTK 9.1 does not limit TBB's threads to the number that it was last limited to, though the limit
 * was lifted in between: a second run would have them all. Another number first makes it.
 */
void limitThreads(int threads, int processors)
{
  if (threads > 0 && processors > 1)
  {
    vtkSMPTools::Initialize(threads > 1 ? threads - 1 : 2);
    vtkSMPTools::Initialize(threads);
  }
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
      limitThreads(execution.threads, processors);
      execution.backend = vtkSMPTools::GetBackend();
      execution.threads = vtkSMPTools::GetEstimatedNumberOfThreads();
      work();
    });
}

Status runFilter(vtkObject* filter, int backend, int threads, const std::function<Status()>& work,
  Execution& execution)
{
  static const char* const names[] = { "", "Sequential", "STDThread", "TBB" };
  bool available = true;
  execution = chooseExecution(names[backend], threads, available);
  if (!available)
  {
    vtkWarningWithObjectMacro(filter,
      "This VTK has no SMP back-end " << names[backend] << "; " << execution.backend
                                      << " is used.");
  }
  Status status;
  try
  {
    runInScope(execution, [&]() { status = work(); });
  }
  catch (const std::bad_alloc&)
  {
    status = { StatusCode::OutOfMemory, "There is not enough memory for this run." };
  }
  return status;
}

void showWarnings(vtkObject* filter, const std::vector<std::string>& warnings)
{
  for (const std::string& warning : warnings)
  {
    if (!warning.empty())
    {
      vtkWarningWithObjectMacro(filter, << warning);
    }
  }
}

int reportEnd(vtkObject* filter, const Status& status)
{
  if (status.ok() || status.code == StatusCode::EmptyInput || status.code == StatusCode::Cancelled)
  {
    return 1; // a failure would make the executive report an error
  }
  vtkErrorWithObjectMacro(filter, << status.message);
  return 0;
}

double machineMemory()
{
  vtksys::SystemInformation system;
  return static_cast<double>(system.GetHostMemoryTotal()) * 1024.0;
}
}
