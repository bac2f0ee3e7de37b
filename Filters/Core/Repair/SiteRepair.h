/**
 * @file SiteRepair.h
 * @brief From optimised sites to a dual that is like the surface.
 */
#ifndef remesh_SiteRepair_h
#define remesh_SiteRepair_h

#include "Repair/SiteCandidate.h"

namespace remesh
{
/** What is done until the topology is right and the number of vertices is that asked for. */
SiteTable topologyTable();

/** What is done then, about triangles that face the wrong way, and where that spoils the first. */
SiteTable facingTable();

/**
 * Diagram, components, dual and certificate of the sites, and what the outputs tell of the cells.
 * Where the verdict finds something wrong, the sites are improved (Improve.h) by the proposals of
 * the first table, and then of the second.
 *
 * @param othersStay from the first edit on, nothing changes but what must.
 * @param result its sites are given, and change.
 * Cost: of the first diagram, a diagram and its dual; of others, the diagram where sites have
 * changed, its dual, and Lloyd's steps on a part of the surface.
 */
Status findDual(const Task& task, bool othersStay, const RunControl& control, RemeshResult& result);
}

#endif
