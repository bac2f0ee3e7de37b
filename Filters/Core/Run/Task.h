/**
 * @file Task.h
 * @brief The input that all steps of a run share, and a stopwatch.
 */
#ifndef remesh_Task_h
#define remesh_Task_h

#include "Features/FeaturedSurface.h"
#include "Metric/MetricField.h"
#include "Optimization/Relaxation.h"
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

/** The input of a run. The steps read it; what they make goes into a RemeshResult. */
struct Task
{
  const SurfaceMesh& mesh;
  const EmbeddedSurface& surface;
  const Features* features; ///< nullptr: none
  const RemeshOptions& options;
  /** In which the triangles are to be even, for the embedding that the surface has; nullptr: none.
   */
  const MetricField* metric = nullptr;

  /** Finds closest facets of the whole surface. Made by `wholeSurface`, where there is none. */
  mutable std::shared_ptr<const WholeSurface> whole = nullptr;

  const WholeSurface& wholeSurface(const RunControl& control) const
  {
    if (!this->whole)
    {
      this->whole = std::make_shared<const WholeSurface>(this->mesh, control);
    }
    return *this->whole;
  }
  /** Makes room, until it is wanted again. */
  void forgetWholeSurface() const { this->whole.reset(); }

  /** What the optimisation of the result's sites reads and changes. */
  Relaxation relaxation(RestrictedVoronoi& voronoi, RemeshResult& result) const
  {
    return { voronoi, this->surface, this->options.seed, result.sites, result.sums,
      result.convergence, result.emptyCells };
  }

  /** Only if there are features. */
  FeaturedSurface featured() const { return { this->mesh, this->surface, *this->features }; }

  /**
   * How many of the vertices may lie on features, to keep close curves apart. It leaves the part of
   * the surface that is far from features half of what it would have if all vertices were spread
   * evenly; at least a tenth of all vertices, and at most four tenths.
   *
   * @param vertices of the mesh.
   * @param shareApart from 0 to 1: share of the surface that is far from features.
   */
  Offset maxPointsOnFeatures(Offset vertices, double shareApart) const
  {
    const double share = std::clamp(1.0 - 0.5 * shareApart, 0.6, 0.9);
    return static_cast<Offset>(share * static_cast<double>(vertices));
  }

  /**
   * How many free sites are kept, even if cells of several parts make more vertices than asked for.
   * None if less than three tenths of the surface is far from features: the cells on features cover
   * it.
   *
   * @param shareApart as above.
   */
  Offset minFreeSites(double shareApart) const
  {
    const double share = 0.2 * std::max(shareApart - 0.3, 0.0);
    return static_cast<Offset>(share * static_cast<double>(this->options.numberOfSites));
  }
};
}

#endif
