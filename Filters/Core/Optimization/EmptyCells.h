/**
 * @file EmptyCells.h
 * @brief Sites whose cell has no mass are moved to where they are needed, never lost.
 */
#ifndef remesh_EmptyCells_h
#define remesh_EmptyCells_h

#include "Optimization/Relaxation.h"

namespace remesh
{
/**
 * Finds `sums` of `sites`; while there are sites without mass, draws new places for them, with a
 * probability proportional to the cells' energy density, and integrates again. The energy only
 * falls. Fixed sites stay, and are left out of moment and gradient. `emptyCells` counts the sites
 * still without mass after the last of several rounds: 0 but for surfaces that cannot hold so many.
 */
Status integrateAndFill(const Relaxation& relaxation, const RunControl& control);
}

#endif
