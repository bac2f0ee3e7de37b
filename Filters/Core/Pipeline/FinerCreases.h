/**
 * @file FinerCreases.h
 * @brief Creases that are too small for a mesh's points, but the reason why it is far.
 */
#ifndef remesh_FinerCreases_h
#define remesh_FinerCreases_h

#include "Pipeline/RunRequest.h"

namespace remesh
{
struct FinerCreases
{
  Offset sites = 0;        ///< whose spacing lets them count; 0: there are none
  Offset neededPoints = 0; ///< that all features then take at least
};

/**
 * Looks at the features for ever more sites, until those that are new touch nearly all of the cells
 * that are far. They may still be noise, which is everywhere: only a mesh with them tells.
 *
 * @param request what `outcome` is of. Its tolerance is in the unit of the points, and smaller
 *        creases are no reason.
 * @param farCells components of `outcome` that have a place beyond a tolerance.
 * @return Cancelled, or as embedSurface().
 * Cost: O(F) for each four times as many sites; memory, a copy of the mesh.
 */
Status findFinerCreases(const RunRequest& request, const RunOutcome& outcome,
  const std::vector<Index>& farCells, const RunControl& control, FinerCreases& finer);
}

#endif
