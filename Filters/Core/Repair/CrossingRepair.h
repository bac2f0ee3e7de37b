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
 * Two sheets of the surface may be closer to each other than triangles are to them. Then triangles
 * of one go through those of the other. For each such pair:
 *
 * 1. Other places are tried for its free vertices, those with the most crossings around them first:
 *    the places of StarRepair.h, and one beyond the plane of the other triangle.
 * 2. If none helps, its edges may flip.
 *
 * Each step must leave fewer crossings around the vertex or the edge. It must not invert a
 * triangle, nor bring a vertex much farther from the surface. Other pairs may cross then: the
 * verdict decides whether the steps are kept (PlacedMesh.cxx).
 *
 * @param context its `mayFlip` tells whether 2 is done.
 * @param search of the same mesh; it is told which triangles change.
 * @param pairs that can be parted (PartableCrossings.h).
 * @param edits gets the steps added; its `inverted` is left as it is.
 * Cost: some hundred places for each pair, and at each a search for what crosses the triangles
 * around.
 */
void partCrossings(const RepairContext& context, const CrossingSearch::Pairs& pairs,
  CrossingSearch& search, RepairedMesh& mesh, MeshEdits& edits);
}

#endif
