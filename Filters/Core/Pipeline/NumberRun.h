/**
 * @file NumberRun.h
 * @brief A run for a number of sites, or for given sites. ToleranceRun.h is that for a distance.
 */
#ifndef remesh_NumberRun_h
#define remesh_NumberRun_h

#include "Pipeline/RunRequest.h"

#include <new>

namespace remesh
{
/**
 * Prepares the surface for the sites, and makes the mesh. It may make several meshes, with other
 * normals, and keeps the one with the best verdict:
 *
 * 1. Normals as they are, if smoothing would flatten few wrinkles (Wrinkles.h). Go on with 2 if
 *    cells fall into many parts, or if the mesh has faults.
 * 2. Normals smoothed over the usual radius. Noisy normals that count for much give the surface in
 *    R^d more wrinkles than there are sites, so that cells fall into many parts. If the radius is
 *    less than the mean spacing in R^d, such a run ends at its first diagram, and 3 follows.
 * 3. The same with twice, and then with four times the radius. The last one is made to the end.
 * 4. After 3, if the mesh of a manifold is not certified, or has more points than it may: the run
 *    of 2 once more, to the end.
 *
 * There is one run alone if the radius or the passes of smoothing are chosen, if normals are given,
 * if there are sites to start from or coordinate arrays, or without iterations.
 *
 * @param outcome its times and evaluations are those of all runs together.
 * @return as prepareSurface, placeSites and remesh; OutOfMemory where that many sites do not fit.
 * Cost: one run as a rule, five at most. Memory: three surfaces and meshes at most.
 */
Status remeshWithNumber(RunRequest request, const RunControl& control, RunOutcome& outcome);

/**
 * Calls `work`, which tries to make a better mesh while the one at hand is kept.
 *
 * @return what it returns; OutOfMemory, without a message, if the memory is not enough for both.
 */
template <class Work>
Status withinMemory(const Work& work)
{
  try
  {
    return work();
  }
  catch (const std::bad_alloc&)
  {
    return { StatusCode::OutOfMemory, "" };
  }
}
}

#endif
