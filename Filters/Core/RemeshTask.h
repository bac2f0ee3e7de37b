/**
 * @file RemeshTask.h
 * @brief What the steps of the pipeline share.
 */
#ifndef remesh_RemeshTask_h
#define remesh_RemeshTask_h

#include "Remesh.h"

#include <algorithm>
#include <chrono>

namespace remesh
{
/** Seconds since the last call. */
class Stopwatch
{
public:
  double lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> elapsed = now - m_start;
    m_start = now;
    return elapsed.count();
  }

private:
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/** What all steps work on. */
struct Task
{
  const SurfaceMesh& mesh;
  const EmbeddedSurface& surface;
  const Features* features; ///< nullptr: none
  const RemeshOptions& options;

  /** To keep curves apart, of so many vertices that there are, or of those asked for. */
  Offset mostPointsOnFeatures(Offset vertices) const
  {
    return std::max(this->options.numberOfSites, vertices) * 9 / 10;
  }
};
}

#endif
