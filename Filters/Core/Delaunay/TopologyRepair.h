/**
 * @file TopologyRepair.h
 * @brief Delaunay refinement in R^d where the dual is not proven to be like the surface, within the
 * number of points asked for.
 *
 * Where a thin part of the surface has too few cells around it (a cell around a limb, two cells
 * that meet along two segments, a cell with two neighbours only at the tip of a spike), one more
 * site mends it. So that the mesh has the number of vertices asked for, sites are taken away
 * where they matter least, away from such places.
 */
#ifndef remesh_TopologyRepair_h
#define remesh_TopologyRepair_h

#include "Delaunay/Certificate.h"
#include "Voronoi/CellSums.h"
#include "Voronoi/VertexPlaces.h"

#include <set>

namespace remesh
{
/** What may mend a few of the failures. */
struct Refinement
{
  std::vector<double> added;  ///< m x d, places of new sites in scaled units
  std::vector<Index> removed; ///< free sites
  /** Components that meet at the vertices of the diagram with new sites: no two at one of them. */
  std::set<Triple> meetings;
};

/**
 * A new site for each cell, or segments between two, where the certificate fails: at the vertex of
 * the diagram that is farthest from the site. What would be next to another one's cells is left for
 * later.
 *
 * @param cutTips whether cells with fewer than three neighbours, as at the tip of a spike, are left
 *        to these instead: the spike ends in one of them then.
 * Cost: O(P).
 */
Refinement refineTopology(const VertexPlaces& places, const Components& components,
  const Dual& dual, const Certificate& certificate, bool cutTips);

/**
 * A new site for each of these triangles, at the vertex of the diagram it is the dual of; none for
 * those next to another one's. O(P / K) each.
 */
Refinement refineTriangles(const VertexPlaces& places, const Components& components,
  const Dual& dual, const std::vector<Index>& triangles);

/** Adds up to `count` sites, at the farthest vertices of the cells' parts with the most energy. */
void addWhereEnergyIs(
  const VertexPlaces& places, const Components& components, Offset count, Refinement& refinement);

/** For each of these sites, those with cells next to its cell; some repeatedly. O(K). */
std::vector<std::vector<Index>> neighborsOf(const std::vector<Index>& candidates,
  const Components& components, const Dual& dual, Index numberOfSites);

struct Revision
{
  Index added = 0; ///< the last sites there are
  Index removed = 0;
  Index removedLast = 0; ///< of them, of the last `addedBefore`
};

/**
 * Adds and takes away these sites, and brings the number of the mesh's vertices to what is wanted:
 * takes away the free sites with the least energy, as far as can be from failures, from where sites
 * were added before and from each other, or adds sites where cells have the most. No patch loses
 * sites that it cannot do without (SpareSites.h), though there be more vertices than wanted.
 *
 * @param places of the diagram, whose sites these are still.
 * @param refinement the last places are left out where there are not enough sites to take away.
 * @param wanted vertices, sites on features (counted once) included.
 * @param addedBefore the last so many sites were added before.
 * @param keepAdded whether these stay, and those around them, but for such in the refinement.
 */
Revision reviseSites(const VertexPlaces& places, const Components& components, const Dual& dual,
  const Certificate& failures, const CellSums& sums, Refinement refinement, Offset wanted,
  Index addedBefore, Sites& sites, bool keepAdded = true);

/** The last `addedBefore` sites, and those a few triangles around them; ascending. O(K). */
std::vector<Index> sitesAroundAdded(
  const Components& components, const Dual& dual, Index numberOfSites, Index addedBefore);
}

#endif
