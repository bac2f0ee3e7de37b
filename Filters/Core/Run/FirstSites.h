/**
 * @file FirstSites.h
 * @brief The sites that the optimisation starts from.
 */
#ifndef remesh_FirstSites_h
#define remesh_FirstSites_h

#include "Run/Task.h"

namespace remesh
{
/**
 * Takes the sites that are given, or else makes as many as are wanted. Those on features come
 * first, if there are any. The free ones follow: they are drawn from each patch.
 *
 * With `coarseStart`, most drawn sites are then replaced. A quarter as many sites takes a few
 * iterations. Where their cells are near hexagons, they and the middles between neighbours come in
 * the place of drawn sites (SiteGrowth.h). So all regions have their due number of sites from the
 * start, which takes iterations longest to reach. After as many iterations the energy is lower; or
 * it is as low after two thirds of them.
 *
 * @param result gets the sites, those on features, and what is known of the features' curves.
 * Cost: with a coarse start, about that of three to ten iterations. It grows with the number of
 * facets for each site.
 */
Status makeSites(const Task& task, const RunControl& control, RemeshResult& result);
}

#endif
