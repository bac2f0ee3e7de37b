/**
 * @file ToleranceSearch.h
 * @brief A mesh within a distance of the surface, with as many points as that takes.
 *
 * 1. A pilot run with few points. The mean distance falls as 1 over their number. So the pilot
 *    gives the number for which the mean is a third of the tolerance: most of the mesh is within it
 *    then. Others with more points may follow, until one has the surface's topology.
 * 2. A run with that number. Others may follow, with the same creases: with more points, if
 *    features take most of them; with fewer, if the mesh is well within the tolerance.
 * 3. Where mesh or surface is beyond the tolerance (DistanceLimit.h), the cell there gets a site,
 *    or two where it is far beyond. Two of Lloyd's steps, diagram, dual and placement follow. It is
 *    repeated until nothing is beyond.
 * 4. Some creases were too small to count in step 2. They may be the reason why step 3 does not
 *    end, or takes more points than it would with these creases. If they are where the mesh is far,
 *    steps 2 and 3 are repeated with them.
 *
 * So a place that needs many points gets them there, and they are not spread over all the surface.
 * This file has steps 1 and 3; ToleranceRun.cxx has all of them in their order.
 */
#ifndef remesh_ToleranceSearch_h
#define remesh_ToleranceSearch_h

#include "Pipeline/RunRequest.h"

namespace remesh
{
/** How a refinement ended. */
struct ToleranceOutcome
{
  enum How
  {
    Kept,          ///< nothing is beyond the tolerance: proven
    TooManyPoints, ///< it would take more points than allowed
    Stuck          ///< more points do not help
  };

  How how = Stuck;
  std::vector<Index> farCells; ///< components with a place beyond the tolerance, ascending
};

/** What is known of a run when the number for the next one is chosen. */
struct NumberTrial
{
  Offset number = 0;    ///< of points
  double mean = 0.0;    ///< mean distance; of mesh to surface and back, the larger one
  Offset minNumber = 0; ///< of points that features take
};

/**
 * Step 1: the number of points for the run after the pilot. At least 4, and so many that features
 * take six tenths of them at most; but no more than `request.maxPoints`.
 *
 * @param request its tolerance is in the unit of the points.
 */
Offset numberForTolerance(const NumberTrial& pilot, const ToleranceRequest& request);

/**
 * Step 1: the number of points for another pilot, or 0 for none. A mesh without the surface's
 * topology is far from it, which does not tell how many points it takes: if it asks for more than
 * eight times as many, another pilot has eight times as many. For a rod, 2000 times as long as it is
 * thick, a pilot of 2000 points asks for 225 000, where 15 500 do.
 *
 * @param number of points of a pilot.
 * @param estimate of the number for the next run, by numberForTolerance().
 * @param isLost whether the pilot is without the surface's topology.
 */
Offset pilotAfter(Offset number, Offset estimate, bool isLost);

/**
 * Step 3.
 *
 * @param request its tolerance is in the unit of the points. Its `exactNumber` must be false, as
 *        points are added.
 * @param manyPoints no further round begins with so many points.
 * @param outcome of a run for the same request; changed.
 * @param reached gets how it ended.
 * @return Cancelled, InvalidInput if the mesh has no area, or success, whatever was reached.
 * Cost: a round takes about as long as three steps of the optimisation and the measuring.
 */
Status refineToTolerance(const RunRequest& request, Offset manyPoints, RunControl control,
  RunOutcome& outcome, ToleranceOutcome& reached);
}

#endif
