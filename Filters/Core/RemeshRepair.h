/**
 * @file RemeshRepair.h
 * @brief Changes sites where their dual is not what it should be.
 */
#ifndef remesh_RemeshRepair_h
#define remesh_RemeshRepair_h

#include "Placement/FlipRepair.h"
#include "RemeshTask.h"
#include "RepairState.h"

#include <vector>

namespace remesh
{
/**
 * The flipped triangles of the cells' centroids that these steps do not turn back: the dual's where
 * no edges turn. Those without a height are not among them: turned edges mend them.
 */
std::vector<Index> flippedTriangles(
  const Task& task, FlipSteps steps, const RunControl& control, const RemeshResult& result);

/**
 * The triangles of the cells' centroids that face their own facets, or those of a part of the
 * surface that is closer (StrayTriangles.h), the wrong way and are not turned back by moving
 * vertices.
 *
 * @param noneFlipped whether none faces its own facets the wrong way: saves time.
 */
std::vector<Index> wrongTriangles(
  const Task& task, bool noneFlipped, const RunControl& control, const RemeshResult& result);

/**
 * Mends the first of these that is wrong: cells that reach a curve between its sites, the topology,
 * the number of vertices, flipped triangles, strays.
 *
 * @param result with the diagram and dual of its sites, which change.
 * @return the number of sites touched; 0 if there is nothing to mend that can be.
 */
Index mend(const Task& task, const RunControl& control, Repair& repair, RemeshResult& result);

/** Whether the last sites touched are to be the only ones that change. */
bool othersMustStay(const Repair& repair);

/** Whether those around them are to be settled in the end instead. */
bool leavesUnsettled(const Repair& repair);
}

#endif
