/**
 * @file RemeshStart.h
 * @brief From the surface to the sites that the optimisation starts from.
 */
#ifndef remesh_RemeshStart_h
#define remesh_RemeshStart_h

#include "RemeshTask.h"

namespace remesh
{
/**
 * The sites given, or as many as are wanted: first those on features, if there are any, and then
 * the free ones of each patch, drawn from it or, with `coarseStart`, grown (SiteGrowth.h) from the
 * sites of a start with a quarter of them and a few iterations. What is far apart is spread evenly
 * by then, which takes the iterations longest, and cells are near hexagons: the energy is lower
 * after as many iterations, or as low after half of them.
 *
 * @param result gets sites, stations and sites on features.
 * Cost: with a coarse start, about that of three to ten iterations: the more facets there are for
 * each site, the more.
 */
Status makeSites(const Task& task, const RunControl& control, RemeshResult& result);
}

#endif
