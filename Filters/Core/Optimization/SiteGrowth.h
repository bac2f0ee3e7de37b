/**
 * @file SiteGrowth.h
 * @brief From the sites of a coarse tessellation to about four times as many.
 */
#ifndef remesh_SiteGrowth_h
#define remesh_SiteGrowth_h

#include "Optimization/CoarseCells.h"

namespace remesh
{
/**
 * Puts the sites of a coarse tessellation, and the middles between neighbours, in the place of
 * drawn ones: hexagons become hexagons of half the size. Only those of cells that are about as
 * flat as hexagons and as large as is usual; what a cell does not resolve, the middles of its edges
 * do not either. There, and beside features, the drawn sites stay: in each cell those farthest from
 * what has grown, so that cells get what is due to their measure, and the number remains.
 *
 * @param sites free ones of a patch come out together, in the order of the coarse ones.
 * @return Cancelled; then `sites` is of no use.
 * Cost: O(P + n log n) for P pieces and n sites.
 */
Status growSites(const EmbeddedSurface& surface, const CoarseTessellation& coarse,
  const RunControl& control, Sites& sites);
}

#endif
