/**
 * @file TopologyRounds.h
 * @brief Rounds of sites for where the topology is not proven.
 */
#ifndef remesh_TopologyRounds_h
#define remesh_TopologyRounds_h

#include "RemeshTask.h"
#include "RepairState.h"

namespace remesh
{
/**
 * Sites for where the certificate fails, stage after stage (RepairStage).
 *
 * @return the number of sites touched; 0 if there is nothing left to try.
 */
Index repairTopology(
  const Task& task, const RunControl& control, Repair& repair, RemeshResult& result);
}

#endif
