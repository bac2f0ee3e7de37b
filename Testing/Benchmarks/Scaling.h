/**
 * @file Scaling.h
 * @brief How the cost grows: with triangles, points, dimensions and threads.
 */
#ifndef remesh_benchmark_Scaling_h
#define remesh_benchmark_Scaling_h

#include "Cases.h"

namespace remesh::benchmark
{
/**
 * Evaluations over 3 numbers of triangles and 4 of points. Figures: processor time fitted by
 * a m + b n, `per_triangle` and `per_point` (us), and the largest `deviation` from it (%).
 */
void scaleSize(Workshop& workshop, CaseResult& result);

/** Evaluations of m = 20 000 to 2 000 000 triangles, n = m / 10. Figure: the `exponent` of m. */
void scaleRatio(Workshop& workshop, CaseResult& result);

/** Evaluations in 3 to 1000 dimensions. */
void scaleDimension(Workshop& workshop, CaseResult& result);

/**
 * The filter, file reading and writing apart, and an evaluation's parts, with 1, 2, 4... threads
 * up to the machine's. Figures: `speedup_<n>_<t>` of n points on t threads, in wall time.
 */
void scaleThreads(Workshop& workshop, CaseResult& result);
}

#endif
