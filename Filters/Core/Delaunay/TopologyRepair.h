/**
 * @file TopologyRepair.h
 * @brief Delaunay refinement in R^d where the dual is not proven to be like the surface.
 *
 * Where a thin part of the surface has too few cells around it (a cell around a limb, two cells
 * that meet along two segments, a cell with two neighbours only at the tip of a spike), one more
 * site mends it. What goes for it is found by SiteRevision.h.
 */
#ifndef remesh_TopologyRepair_h
#define remesh_TopologyRepair_h

#include "Delaunay/Certificate.h"
#include "Voronoi/CellSums.h"
#include "Voronoi/VertexPlaces.h"

#include <set>

namespace remesh
{
/** A diagram, the components of its cells, and their dual. */
struct DiagramDual
{
  VertexPlaces places;
  const Components& components;
  const Dual& dual;
};

/** What may mend a few of the failures. */
struct Refinement
{
  std::vector<double> added;  ///< m x d, places of new sites in scaled units
  std::vector<Index> removed; ///< free sites
  /**
   * Components that meet at the vertices of the diagram with new sites, or with one beyond at a
   * thin tip: no two at one of them.
   */
  std::set<Triple> meetings;
  std::vector<Index> closed; ///< components that get no site for their energy
};

/**
 * A new site for each cell, or segments between two, where the certificate fails: at the vertex of
 * the diagram that is farthest from the site, or at a thin tip between its curves (ThinTips.h).
 * What would be next to another one's cells is left for later. At the apex of a cone each would
 * have another one of the kind above it, at every scale: there the cells that go all around are
 * taken away, down to one that has triangles.
 *
 * @param cutTips whether cells with fewer than three neighbours, as at the tip of a spike, are left
 *        to these instead: the spike ends in one of them then.
 * Cost: O(P).
 */
Refinement refineTopology(const DiagramDual& diagram, const Certificate& certificate, bool cutTips);

/**
 * A new site for each of these triangles, at the vertex of the diagram it is the dual of; none for
 * those next to another one's. O(P / K) each.
 */
Refinement refineTriangles(const DiagramDual& diagram, const std::vector<Index>& triangles);

/**
 * Adds up to `count` sites, at the farthest vertices of the cells' parts with the most energy; none
 * in cells with an apex, whose energy is that of the cells that cannot be there.
 */
void addWhereEnergyIs(
  const VertexPlaces& places, const Components& components, Offset count, Refinement& refinement);
}

#endif
