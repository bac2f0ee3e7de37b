/**
 * @file ProgressAdaptor.h
 * @brief VTK's progress and abort behind the core's RunControl.
 */
#ifndef remesh_ProgressAdaptor_h
#define remesh_ProgressAdaptor_h

#include "Adaptors/VTKCompatibility.h"
#include "Support/RunControl.h"

#include <algorithm>
#include <memory>

namespace remesh
{
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
  return RunControl([shared](double fraction, const char* phase) { (*shared)(fraction, phase); },
    [algorithm]() { return abortRequested(algorithm); });
}
}

#endif
