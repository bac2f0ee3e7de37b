/**
 * @file Task.h
 * @brief What the steps of the pipeline share.
 */
#ifndef remesh_Task_h
#define remesh_Task_h

#include "Features/FeaturedSurface.h"
#include "Placement/WholeSurface.h"
#include "Run/RemeshResult.h"

#include <algorithm>
#include <chrono>
#include <memory>

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

  /** For triangles that face it; made when it is first asked for. */
  mutable std::shared_ptr<const WholeSurface> whole = nullptr;

  const WholeSurface& wholeSurface(const RunControl& control) const
  {
    if (!this->whole)
    {
      this->whole = std::make_shared<const WholeSurface>(this->mesh, control);
    }
    return *this->whole;
  }

  /** Where there are features. */
  FeaturedSurface featured() const { return { this->mesh, this->surface, *this->features }; }

  /**
   * Of so many vertices, those that features may take so that their curves are kept apart: the rest
   * of the surface gets half of what it would if all were spread evenly, if not less than a tenth.
   *
   * @param shareApart of the surface, what is far from features.
   */
  Offset mostPointsOnFeatures(Offset vertices, double shareApart) const
  {
    const double share = std::clamp(1.0 - 0.5 * shareApart, 0.6, 0.9);
    return static_cast<Offset>(share * static_cast<double>(vertices));
  }

  /**
   * Free sites that stay, though cells of several parts make more vertices than asked for. Where
   * little is far from features, the cells there cover it.
   */
  Offset leastFreeSites(double shareApart) const
  {
    const double share = 0.2 * std::max(shareApart - 0.3, 0.0);
    return static_cast<Offset>(share * static_cast<double>(this->options.numberOfSites));
  }
};
}

#endif
