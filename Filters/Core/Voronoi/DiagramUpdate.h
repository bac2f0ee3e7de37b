/**
 * @file DiagramUpdate.h
 * @brief An earlier diagram, brought up to date where sites have changed.
 */
#ifndef remesh_DiagramUpdate_h
#define remesh_DiagramUpdate_h

#include "Voronoi/KeptPieces.h"

namespace remesh
{
/**
 * Replaces the pieces of all facets but those that keep theirs; sites get their later ids. Array
 * by array, so that besides the changes no more than the largest array is held twice.
 *
 * @param kept of `diagram` as it is before.
 * @param changes the pieces of the other facets; freed as they are taken.
 * @return InvalidInput if the pieces have more vertices than an Index counts, or Cancelled; then
 *         `diagram` is of no use.
 * Cost: O(P + V), in parallel.
 */
Status updateDiagram(
  const KeptPieces& kept, Diagram& changes, const RunControl& control, Diagram& diagram);
}

#endif
