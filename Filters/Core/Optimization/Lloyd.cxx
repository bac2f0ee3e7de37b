#include "Optimization/Lloyd.h"

#include "Optimization/EmptyCells.h"

namespace remesh
{
namespace
{
/** x_i <- g_i = x_i + moment_i / m_i. */
void moveToCentroids(const CellSums& sums, Sites& sites)
{
  const int d = sites.dimension;
  for (Index i = 0; i < sites.count(); ++i)
  {
    if (sums.mass[i] > 0.0)
    {
      double* x = sites.site(i);
      const double* moment =
        sums.moment.data() + static_cast<std::size_t>(i) * static_cast<std::size_t>(d);
      for (int k = 0; k < d; ++k)
      {
        x[k] += moment[k] / sums.mass[i];
      }
    }
  }
}
}

Status relaxLloyd(RestrictedVoronoi& voronoi, const EmbeddedSurface& surface, int iterations,
  std::uint64_t seed, const RunControl& control, Sites& sites, CellSums& sums,
  Convergence& convergence, Index& emptyCells)
{
  for (int step = 0; step <= iterations; ++step)
  {
    if (step > 0)
    {
      moveToCentroids(sums, sites);
    }
    if (Status status = integrateAndFill(
          voronoi, surface, seed, control.step(step, iterations + 1), sites, sums, emptyCells);
        !status.ok())
    {
      return status;
    }
    convergence.add(sums.totalEnergy, sums.gradientNorm, step == 0 ? 0.0 : 1.0);
  }
  return Status::success();
}
}
