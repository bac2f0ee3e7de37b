/**
 * @file EmptyCells.h
 * @brief Sites whose cell has no mass are moved to where they are needed, never lost.
 */
#ifndef remesh_EmptyCells_h
#define remesh_EmptyCells_h

#include "Voronoi/RestrictedVoronoi.h"

#include <cstdint>

namespace remesh
{
/**
 * Integrates; while there are sites without mass, draws new places for them, with a probability
 * proportional to the cells' energy density, and integrates again. The energy only falls.
 * Fixed sites stay, and are left out of moment and gradient.
 *
 * @param emptyCells sites still without mass after the last of several rounds (0 but for surfaces
 *        that cannot hold so many).
 */
Status integrateAndFill(RestrictedVoronoi& voronoi, const EmbeddedSurface& surface,
  std::uint64_t seed, const RunControl& control, Sites& sites, CellSums& sums, Index& emptyCells);
}

#endif
