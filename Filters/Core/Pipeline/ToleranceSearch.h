/**
 * @file ToleranceSearch.h
 * @brief A mesh within a distance of the surface, with as many points as that takes.
 *
 * 1. A pilot run with few points; the mean distance falls as 1 over their number, which gives the
 *    number for which it is a third of the tolerance: then most of the mesh is within it.
 * 2. That run. Further ones, with the same creases: with more points, if features take most of
 * them; with fewer, while nothing is beyond the tolerance.
 * 3. Where the mesh or the surface is beyond (DistanceLimit.h), sites are added, one in each cell;
 *    two Lloyd steps, diagram, dual and placement follow; again until nothing is beyond.
 * 4. Where that does not end, or takes more points than creases would that were too small for the
 *    number of step 2, and these are where the mesh is far: again from there, with those creases.
 *
 * So the points that single places take are put there, and not spread over the whole surface.
 */
#ifndef remesh_ToleranceSearch_h
#define remesh_ToleranceSearch_h

#include "Pipeline/RunRequest.h"

namespace remesh
{
struct ToleranceOutcome
{
  enum How
  {
    Kept,
    TooManyPoints, ///< it would take more than allowed
    Stuck          ///< further points do not help
  };

  How how = Stuck;
  std::vector<Index> farCells; ///< components with a place beyond the tolerance, ascending
};

/** What is known of a run when the number for the next one is chosen. */
struct NumberTrial
{
  Offset number = 0;      ///< of points
  double mean = 0.0;      ///< distance, the larger of both ways
  Offset leastNumber = 0; ///< that features take
};

/** Step 1: the number after the pilot. @param request in the unit of the points. */
Offset numberForTolerance(const NumberTrial& pilot, const ToleranceRequest& request);

/**
 * Step 3, on the outcome of a run for the same request.
 *
 * @param request its tolerance is in the unit of the points; `exactNumber` must be off: points are
 *        added.
 * @param manyPoints with so many it ends, before a round.
 * @return Cancelled, InvalidInput if the mesh has no area, or success, whatever was reached.
 * Cost: a round takes about as much as three steps of the optimisation and the measuring.
 */
Status refineToTolerance(const RunRequest& request, Offset manyPoints, RunControl control,
  RunOutcome& outcome, ToleranceOutcome& reached);
}

#endif
