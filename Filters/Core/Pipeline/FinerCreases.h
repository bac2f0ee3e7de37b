/**
 * @file FinerCreases.h
 * @brief Finds creases that were dropped as too small, but keep a mesh far from the surface.
 */
#ifndef remesh_FinerCreases_h
#define remesh_FinerCreases_h

#include "Pipeline/RunRequest.h"

namespace remesh
{
/** Creases that would count with more sites. */
struct FinerCreases
{
  Offset sites = 0;        ///< with so many they count, as their spacing is less; 0: none found
  Offset neededPoints = 0; ///< vertices that all features take at least then
};

/**
 * More sites have a smaller spacing, with which smaller creases count as features. So the features
 * are looked up for four times as many sites, again and again. It ends when the new features touch
 * nine tenths of the cells that are far, when no crease is left out any more, or when the spacing
 * is less than the tolerance.
 *
 * What is found may still be noise, which is everywhere: only a mesh with these features tells.
 *
 * @param request that `outcome` was made for, with its tolerance in the unit of the points.
 * @param farCells components of `outcome` with a place beyond the tolerance.
 * @param finer is replaced.
 * @return Cancelled, what embedSurface returns, or success.
 * Cost: O(F) for each number of sites that is tried; memory: a copy of the mesh.
 */
Status findFinerCreases(const RunRequest& request, const RunOutcome& outcome,
  const std::vector<Index>& farCells, const RunControl& control, FinerCreases& finer);
}

#endif
