/**
 * @file Runs.h
 * @brief What can be measured of one surface and one number of points.
 */
#ifndef remesh_benchmark_Runs_h
#define remesh_benchmark_Runs_h

#include "Results.h"
#include "Surfaces.h"

namespace remesh::benchmark
{
/**
 * One evaluation of the restricted Voronoi diagram's integrals and its share of the optimisation,
 * averaged over a whole one: `processor` and `wall`, and the parts of both, `neighbors`,
 * `ownership`, `clipping`, `reduction`, and `optimizer` for the rest.
 */
Figures evaluation(const EmbeddedSurface& surface, Offset points, const Settings& settings);

/** The filter, from polygons to polygons: `processor`, `wall`. */
Figures filterRun(vtkPolyData* surface, Offset points, const Settings& settings);

/**
 * The command line, from file to file: `processor`, `wall`, `memory` (peak).
 *
 * @param options of the command line, beyond those that the settings name.
 */
Figures programRun(const Surface& surface, Offset points, const std::vector<std::string>& options,
  const Settings& settings);

/**
 * The filter in many dimensions, in a process of its own: `processor` and `wall`, with the making
 * of the embedding, peak `memory`, and this as a multiple of the embedding's, `memory_multiple`.
 */
Figures wideRun(const WideRun& wide, const Settings& settings);

/** The work of that process. */
void runWide(const WideRun& wide, const Settings& settings);

/**
 * The embedding of a metric: `processor`, `wall`, and the peak `memory` of a
 * process of its own that does it; those times of a default run in it, `remeshing`; and the
 * processor seconds of the embedding as a multiple of this one's, `over_remeshing`.
 */
Figures metricRun(const MetricRun& metric, const Settings& settings);

/** The work of that process: the surface, and its embedding. */
void runMetric(const MetricRun& metric, const Settings& settings);

/**
 * What exact decisions cost over their floating-point filters alone (`exactness`, %) in a diagram
 * of relaxed sites, and what that takes (`processor`). Evaluations leave all but a few facets to
 * arithmetic that refuses what is too close, and these to the same decisions.
 */
Figures costOfExactness(const EmbeddedSurface& surface, Offset points, const Settings& settings);

/**
 * How far from converged (300 quasi-Newton iterations) the default run ends:
 * `energy_above_converged` (%), and after how many `steps_to_0.3_percent` it comes that near. The
 * steps of its coarse start are not counted.
 */
Figures energyLeft(const EmbeddedSurface& surface, Offset points, const Settings& settings);
}

#endif
