/**
 * @file ToleranceRun.h
 * @brief Surface and mesh for a distance, instead of a number of points (ToleranceSearch.h).
 */
#ifndef remesh_ToleranceRun_h
#define remesh_ToleranceRun_h

#include "Pipeline/RunRequest.h"

namespace remesh
{
/**
 * Prepares the surface for the number of points found, with the creases that count for it or for
 * more, and makes the mesh. Two surfaces and meshes are held while more creases are tried. Tells in
 * `outcome.result.distance` what was reached, and by a warning in `outcome.prepared` where that is
 * not the tolerance.
 *
 * @param request neither its numbers of sites are looked at, nor are its extra points where they
 *        are one percent of what the runs find. The diagram is kept.
 * @return InvalidInput for a tolerance below 1e-7 of the diagonal, and as the run.
 */
Status remeshWithin(RunRequest request, const RunControl& control, RunOutcome& outcome);
}

#endif
