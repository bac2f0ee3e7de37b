/**
 * @file CapSplit.h
 * @brief Keeps the surface closed where triangles without area lie between others.
 *
 * Such a triangle with three corners on a line (a cap) joins what lies along its two short sides to
 * what lies along the long one. Where it goes, the neighbour across the long side is split at the
 * middle corner instead: the same surface, and no slit in it.
 */
#ifndef remesh_CapSplit_h
#define remesh_CapSplit_h

#include "Mesh/IntakeDraft.h"

namespace remesh
{
/**
 * Splits the neighbours of the marked facets that have three different corners. Where the longest
 * side is on a border, nothing is needed.
 *
 * @param marked F, the facets without area. Parts without area that come about are marked, too, and
 *        split in turn; in the end none of the marked ones is needed.
 * @param control asked for cancellation; some are left then.
 * Cost: O(C + F) for C such facets, expected, where the facets around each side are few.
 */
void splitAtCaps(const TriangleSoup& soup, const RunControl& control,
  std::vector<unsigned char>& marked, Draft& draft);
}

#endif
