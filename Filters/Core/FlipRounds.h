/**
 * @file FlipRounds.h
 * @brief Rounds of sites for triangles that are flipped, and for strays.
 */
#ifndef remesh_FlipRounds_h
#define remesh_FlipRounds_h

#include "RemeshTask.h"
#include "RepairState.h"

namespace remesh
{
/**
 * Places on curves and sites for where triangles are flipped, and then sites for strays.
 *
 * @return the number of sites touched; 0 if there is nothing to mend that can be.
 */
Index repairFlips(
  const Task& task, const RunControl& control, Repair& repair, RemeshResult& result);
}

#endif
