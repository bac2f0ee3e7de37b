/**
 * @file CrossingRepair.h
 * @brief Parts triangles that go through each other.
 */
#ifndef remesh_CrossingRepair_h
#define remesh_CrossingRepair_h

#include "Placement/CrossingSearch.h"
#include "Placement/RepairedMesh.h"
#include "Placement/StarRepair.h"

namespace remesh
{
/**
 * Finds the pairs that can be parted: not those where the surface goes through itself, too, among
 * the facets that the cells of the one triangle and of the other meet.
 *
 * @return Cancelled; then `pairs` is of no use.
 * Cost: that of the search, and for each pair O(squares of the facets of its cells) at most.
 */
Status findPartable(const PlacementProblem& problem, const CrossingSearch& search,
  const std::vector<Triple>& triangles, const RunControl& control,
  std::vector<std::pair<Index, Index>>& pairs);

/**
 * Where two sheets of the surface, or the sides of a thin one, are closer than chords are to it,
 * triangles of one go through those of the other. For each such pair, other places are tried for
 * its free vertices, those with the most crossings around them first: those of StarRepair.h, and
 * beyond the plane of the other triangle; if none helps, its edges may turn. Each step must leave
 * fewer triangles that cross, and none flipped that was not. Ends when nothing crosses or nothing
 * helps.
 *
 * @param context with `mayTurn`.
 * @param search of the same mesh; told what changes.
 * @param pairs found by `findPartable`.
 * @param repair counts what is done; its flipped triangles are the caller's.
 * Cost: some hundred places for each pair, with a search for the stars' crossings at each.
 */
void repairCrossings(const RepairContext& context,
  const std::vector<std::pair<Index, Index>>& pairs, CrossingSearch& search, RepairedMesh& mesh,
  FlipRepair& repair);
}

#endif
