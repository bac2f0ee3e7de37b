/**
 * @file RemeshRepair.h
 * @brief Changes sites where their dual is not what it should be.
 */
#ifndef remesh_RemeshRepair_h
#define remesh_RemeshRepair_h

#include "RemeshTask.h"
#include "RepairState.h"

namespace remesh
{
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
