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
 * Replaces the pieces of all facets but those that keep theirs; sites get their later ids. The
 * arrays stay where they are, as far as there is room: hardly more than the changes is held twice.
 *
 * @param kept of `diagram` as it is before.
 * @param changes the pieces of the other facets; freed as they are taken.
 * @return InvalidInput if the pieces have more vertices than an Index counts, or Cancelled; then
 *         `diagram` is of no use.
 * Cost: O(P + V), little more than moving the arrays once.
 */
Status updateDiagram(
  const KeptPieces& kept, Diagram& changes, const RunControl& control, Diagram& diagram);
}

#endif
