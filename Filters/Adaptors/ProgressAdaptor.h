/**
 * @file ProgressAdaptor.h
 * @brief VTK's progress and abort behind the core's RunControl.
 */
#ifndef remesh_ProgressAdaptor_h
#define remesh_ProgressAdaptor_h

#include "Adaptors/VTKCompatibility.h"
#include "Support/RunControl.h"

#include "vtkCommand.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

namespace remesh
{
/**
 * Whether to stop. Who observes AbortCheckEvent is asked first, at most every 30 ms, and who
 * observes ProgressEvent at most every 120 ms, though nothing has come forward: most programs stop
 * a filter from there. By the thread that executes the filter alone, which is the one that makes
 * this object.
 */
class AbortCheck
{
public:
  explicit AbortCheck(vtkAlgorithm* algorithm)
    : m_algorithm(algorithm)
  {
  }

  bool operator()()
  {
    if (std::this_thread::get_id() == m_thread)
    {
      const auto now = std::chrono::steady_clock::now();
      if (now >= m_next)
      {
        m_algorithm->InvokeEvent(vtkCommand::AbortCheckEvent);
        if (++m_checks % 4 == 0)
        {
          m_algorithm->UpdateProgress(m_algorithm->GetProgress());
        }
        m_next = now + std::chrono::milliseconds(30);
      }
    }
    return abortRequested(m_algorithm);
  }

private:
  vtkAlgorithm* m_algorithm;
  std::thread::id m_thread = std::this_thread::get_id();
  std::chrono::steady_clock::time_point m_next{};
  int m_checks = 0;
};

/** Progress events at most every half percent or at a new phase, and never falling. */
inline RunControl makeRunControl(vtkAlgorithm* algorithm)
{
  double last = -1.0;
  const char* lastPhase = nullptr;
  const auto report = [=](double fraction, const char* phase) mutable
  {
    if (phase != lastPhase)
    {
      algorithm->SetProgressText(phase);
    }
    if (phase != lastPhase || fraction >= last + 0.005)
    {
      last = std::max(last, fraction);
      lastPhase = phase;
      algorithm->UpdateProgress(last);
    }
  };
  // RunControl is copied freely; all copies must share what was reported last.
  const auto shared = std::make_shared<std::decay_t<decltype(report)>>(report);
  const auto check = std::make_shared<AbortCheck>(algorithm);
  return RunControl([shared](double fraction, const char* phase) { (*shared)(fraction, phase); },
    [check]() { return (*check)(); });
}
}

#endif
