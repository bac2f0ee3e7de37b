/**
 * @file RepairRevision.h
 * @brief How repairs change sites: with a number of vertices to keep, and on curves.
 */
#ifndef remesh_RepairRevision_h
#define remesh_RepairRevision_h

#include "Delaunay/Collar.h"
#include "Delaunay/TopologyRepair.h"
#include "RemeshTask.h"
#include "RepairState.h"

#include <vector>

namespace remesh
{
/**
 * Adds these sites, and others or none, so that the mesh has as many vertices as wanted.
 *
 * @param failures where sites are not to be taken away.
 * @return the number of sites added and removed.
 */
Index revise(Refinement refinement, const Certificate& failures, Offset wanted, const Task& task,
  Repair& repair, RemeshResult& result);

/**
 * Places on curves where these reach them; the number of vertices is brought to what it shall be at
 * once.
 *
 * @return the number of sites touched.
 */
Index repairCurves(const Task& task, const std::vector<Intrusion>& intrusions,
  const RunControl& control, Repair& repair, RemeshResult& result);

/** The sections of curves that these reach. */
Offset countSections(const std::vector<Intrusion>& intrusions);

/** Where so much of the mesh fails, other sites are no use: there are too few. */
bool isHopeless(Offset failures, const RemeshResult& result);
}

#endif
