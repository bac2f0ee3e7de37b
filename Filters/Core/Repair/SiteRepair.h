/**
 * @file SiteRepair.h
 * @brief Repairs optimised sites until their dual has the topology of the surface.
 */
#ifndef remesh_SiteRepair_h
#define remesh_SiteRepair_h

#include "Repair/SiteCandidate.h"

namespace remesh
{
/** The repairs of the topology and of the number of vertices. They come first. */
SiteTable topologyTable();

/**
 * The repairs of curves that cells reach, and of triangles that face the wrong way. They come
 * second. Two rows are those of the first table, to mend what the others spoil.
 */
SiteTable facingTable();

/**
 * Makes diagram, components, dual and certificate of the sites, and what the outputs tell of the
 * cells. If something is wrong, the sites are improved (Improve.h), first by `topologyTable`, then
 * by `facingTable`.
 *
 * @param othersStay whether edits change nothing but what they must, from the first one on.
 * @param result has the sites, which change; the rest is filled in. With `fallsApart` set, only
 *        what belongs to the first diagram is.
 * Cost: a diagram and its dual. For each edit: the diagram where sites have changed, the dual, and
 * at first two of Lloyd's steps on a part of the surface.
 */
Status findRepairedDual(
  const Task& task, bool othersStay, const RunControl& control, RemeshResult& result);
}

#endif
