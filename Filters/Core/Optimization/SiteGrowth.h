/**
 * @file SiteGrowth.h
 * @brief From the sites of a coarse tessellation to about four times as many.
 */
#ifndef remesh_SiteGrowth_h
#define remesh_SiteGrowth_h

#include "Embedding/EmbeddedSurface.h"
#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/Diagram.h"

namespace remesh
{
/**
 * The free sites of a tessellation and the middles between neighbours of a patch, unless both are
 * fixed: hexagons become hexagons of half the size. Where the cells' measure calls for fewer, the
 * middles of the shortest pairs are left out; where it calls for more, a site comes between three
 * cells.
 *
 * @param diagram of the sites.
 * @param counts how many free sites each patch gets at most. Reduced by what it got.
 * @param grown free sites are appended to it, patch by patch, each along a curve through space.
 *        None, and `counts` as before, if the coarse cells are too wide for the surface: where more
 *        than a twentieth of them lack a site, what is to be spread is not known.
 * @return Cancelled; then `grown` is of no use.
 * Cost: O(P + n log n) for P pieces and n sites.
 */
Status growSites(const EmbeddedSurface& surface, const Sites& sites, const Diagram& diagram,
  const RunControl& control, std::vector<Offset>& counts, Sites& grown);
}

#endif
