/**
 * @file RankRun.h
 * @brief What several processes share, which are joined by sockets.
 */
#ifndef remesh_benchmark_RankRun_h
#define remesh_benchmark_RankRun_h

#include "Results.h"

namespace remesh::benchmark
{
/**
 * Two stages on r = 1, 2 and 4 processes: an optimisation, of a bumpy torus from stratified sites;
 * and the distances of the torus and a mesh of it with as many points. Throws std::runtime_error
 * unless all give the same bytes. For each r: `wall_r`; the processor seconds of the first
 * (`first_r`) and of the busiest of the others (`other_r`), in which no waiting is; peak memory so
 * far (`memory_r`, `memory_other_r`); and what the first sends for an evaluation (`sent_r`), and
 * all others to it (`back_r`). Others do nothing but what they share in. Of the second stage the
 * same, with `distance_` before the names, for all of it.
 *
 * @param scaled gets the speed-ups over one process: `processor_r` by the processor seconds of the
 *        busiest one, whatever else the machine does; `wall_r` where it has so many cores.
 */
Figures rankRuns(const RankRun& run, const Settings& settings, Figures& scaled);

/** The work of these processes: prints what each took. */
void runOnRanks(const RankRun& run, const Settings& settings);
}

#endif
