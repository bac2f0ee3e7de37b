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

Status relaxLloyd(const Relaxation& relaxation, int iterations, const RunControl& control)
{
  const CellSums& sums = relaxation.sums;
  for (int step = 0; step <= iterations; ++step)
  {
    if (step > 0)
    {
      moveToCentroids(sums, relaxation.sites);
    }
    if (Status status = integrateAndFill(relaxation, control.step(step, iterations + 1));
        !status.ok())
    {
      return status;
    }
    relaxation.convergence.add(sums.totalEnergy, sums.gradientNorm, step == 0 ? 0.0 : 1.0);
  }
  return Status::success();
}
}
