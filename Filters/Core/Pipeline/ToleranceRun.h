/**
 * @file ToleranceRun.h
 * @brief A run for a distance, instead of a number of points. Its steps are in ToleranceSearch.h.
 */
#ifndef remesh_ToleranceRun_h
#define remesh_ToleranceRun_h

#include "Pipeline/RunRequest.h"

namespace remesh
{
/**
 * Finds the number of points that the tolerance takes, and makes the mesh. It may count finer
 * creases as features than that number of points would. `outcome.result.distance` tells what was
 * reached. If that is not the tolerance, there is a warning in `outcome.prepared`.
 *
 * @param request its numbers of sites are not looked at. Nor are its extra points, if they are to
 *        be one percent of the number. `exactNumber` and `keepDiagram` are replaced: the number is
 *        not kept, and the diagram is.
 * @return InvalidInput for a tolerance below 1e-7 of the diagonal, and what remeshWithNumber
 *         returns.
 * Memory: two surfaces and meshes while finer creases are tried.
 */
Status remeshWithin(RunRequest request, const RunControl& control, RunOutcome& outcome);
}

#endif
