/**
 * @file RunParts.h
 * @brief What several measurements are made of.
 */
#ifndef remesh_benchmark_RunParts_h
#define remesh_benchmark_RunParts_h

#include "Optimization/QuasiNewton.h"
#include "Results.h"

#include <functional>

namespace remesh::benchmark
{
/** Throws std::runtime_error unless all went well. */
void orThrow(const Status& status);

/** In the back-end that the filter chooses, with as many threads as are set. */
void inScope(const Settings& settings, const std::function<void()>& work);

/** Medians over repetitions of a run. */
template <class Run>
Figures repeated(const Settings& settings, const Run& run)
{
  std::vector<Figures> runs;
  for (int k = 0; k < settings.repetitions; ++k)
  {
    runs.push_back(run());
  }
  return medians(runs);
}

/** An optimisation as Remesh.cxx runs it, with its diagrams. */
struct Optimization
{
  explicit Optimization(const EmbeddedSurface& surface)
    : voronoi(surface)
  {
  }

  void run(const EmbeddedSurface& surface, int lloyd, int newton);

  RestrictedVoronoi voronoi;
  Sites sites;
  CellSums sums;
  Convergence convergence;
  Index emptyCells = 0;
};
}

#endif
