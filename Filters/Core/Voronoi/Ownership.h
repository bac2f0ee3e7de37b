/**
 * @file Ownership.h
 * @brief The site nearest to each corner of the surface.
 */
#ifndef remesh_Ownership_h
#define remesh_Ownership_h

#include "Voronoi/NeighborLists.h"

namespace remesh
{
/**
 * Walks from each corner's last owner to a nearer neighbour as long as there is one: exact (the
 * lower id wins a tie), and a few distances when the last owner is nearly right.
 *
 * @param owners C sites to start from; empty: start from a search in the tree. On return, the
 *        owners.
 * @param squared C, on return the squared distances to them.
 */
Status findOwners(const EmbeddedSurface& surface, const Sites& sites, const NeighborLists& lists,
  const RunControl& control, std::vector<Index>& owners, std::vector<double>& squared);
}

#endif
