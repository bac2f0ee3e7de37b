/**
 * @file NumberRun.h
 * @brief Surface and mesh for a number of sites, or for given ones (ToleranceRun.h: for a
 * distance).
 */
#ifndef remesh_NumberRun_h
#define remesh_NumberRun_h

#include "Pipeline/RunRequest.h"

#include <new>

namespace remesh
{
/**
 * Prepares the surface for the sites, and makes the mesh.
 *
 * Where smoothing the normals would flatten few wrinkles (Wrinkles.h), the first mesh is made
 * without it. If its cells fall into many parts, as below, it is not finished, and another is made
 * with smoothed normals; so it is where the mesh has faults, and the better one is kept.
 *
 * Where normals are noisy and count for much, the surface in R^d has more wrinkles than there are
 * sites: cells fall into many parts. Such a run ends at its first diagram, and another is made with
 * normals smoothed over twice, then four times the radius, as long as the radius is less than the
 * mean spacing in R^d. If the mesh of a manifold cannot be certified in spite of that, or has
 * more points than it may, the first radius is tried to the end, too, and the better mesh is kept:
 * up to four runs after that without smoothing, and at last three surfaces and meshes in memory.
 *
 * Only one where the radius or the passes are chosen, where normals are given, where there are
 * sites to start from or further coordinates, and without iterations.
 *
 * @param outcome times and evaluations are of all these runs together.
 * @return as prepareSurface, placeSites and remesh; OutOfMemory where that many sites do not fit.
 */
Status remeshWithNumber(RunRequest request, const RunControl& control, RunOutcome& outcome);

/** What `work` returns, or OutOfMemory, without a message: something is tried beside a mesh. */
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
