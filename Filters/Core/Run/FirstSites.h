/**
 * @file FirstSites.h
 * @brief From the surface to the sites that the optimisation starts from.
 */
#ifndef remesh_FirstSites_h
#define remesh_FirstSites_h

#include "Run/Task.h"

namespace remesh
{
/**
 * The sites given, or as many as are wanted: first those on features, if there are any, and then
 * the free ones of each patch, drawn from it. With `coarseStart`, a start with a quarter of them
 * takes a few iterations, and where its cells are near hexagons, its sites and their middles come
 * in the place of drawn ones (SiteGrowth.h). What is far apart is spread evenly by then, which
 * takes the iterations longest: the energy is lower after as many, or as low after two thirds.
 *
 * @param result gets sites, stations and sites on features.
 * Cost: with a coarse start, about that of three to ten iterations: the more facets there are for
 * each site, the more.
 */
Status makeSites(const Task& task, const RunControl& control, RemeshResult& result);
}

#endif
