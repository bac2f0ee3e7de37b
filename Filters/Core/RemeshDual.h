/**
 * @file RemeshDual.h
 * @brief From optimised sites to a dual that is like the surface.
 */
#ifndef remesh_RemeshDual_h
#define remesh_RemeshDual_h

#include "RemeshTask.h"

namespace remesh
{
/**
 * Diagram, components, dual and certificate of the sites, and what the outputs tell of the cells;
 * again and again while there is something to mend:
 *
 * 1. where cells reach a feature curve, their sites join the curve;
 * 2. where the certificate fails, sites are added, and others taken away (RepairStage); where none
 *    can be, curves that other cells on features reach get places;
 * 3. where it holds without some of the sites that were added, these go where they are missed
 *    (SitePruning.h);
 * 4. where the number of vertices is not what was asked for, sites are added or taken away;
 * 5. where triangles are flipped, and then where they face another part of the surface the wrong
 *    way, sites are added, and others taken away.
 *
 * The first changes are followed by a few steps of Lloyd's around them; later ones change nothing
 * but what they must. If there were such, the sites around them, but for those added and their
 * neighbours, take a few steps in the end, as far as the certificate holds and no more triangles
 * are flipped. The state with the best score (RepairState.h) counts.
 *
 * @param othersStay from the first change on, nothing changes but what must.
 * @param result its sites are given, and change.
 * Cost: of the first round, a diagram and its dual; of others, the diagram where sites have
 * changed, its dual, and Lloyd's steps on a part of the surface.
 */
Status findDual(const Task& task, bool othersStay, const RunControl& control, RemeshResult& result);
}

#endif
