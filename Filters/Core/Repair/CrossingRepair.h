/**
 * @file CrossingRepair.h
 * @brief Parts triangles that go through each other.
 */
#ifndef remesh_CrossingRepair_h
#define remesh_CrossingRepair_h

#include "Repair/CrossingSearch.h"
#include "Repair/RepairedMesh.h"
#include "Repair/StarRepair.h"

namespace remesh
{
/**
 * Where two sheets of the surface, or the sides of a thin one, are closer than chords are to it,
 * triangles of one go through those of the other. For each such pair, other places are tried for
 * its free vertices, those with the most crossings around them first: those of StarRepair.h, and
 * beyond the plane of the other triangle; if none helps, its edges may flip. Each step must leave
 * fewer triangles that cross, and none inverted that was not. Ends when nothing crosses or nothing
 * helps.
 *
 * @param context with `mayFlip`.
 * @param search of the same mesh; told what changes.
 * @param pairs that can be parted (PartableCrossings.h).
 * @param edits counts what is done; its inverted triangles are the caller's.
 * Cost: some hundred places for each pair, with a search for the stars' crossings at each.
 */
void repairCrossings(const RepairContext& context,
  const std::vector<std::pair<Index, Index>>& pairs, CrossingSearch& search, RepairedMesh& mesh,
  MeshEdits& edits);
}

#endif
