/**
 * @file FacetJoins.h
 * @brief How the facets of the surface hang together, and what a whole one adds to its cell.
 */
#ifndef remesh_FacetJoins_h
#define remesh_FacetJoins_h

#include "Embedding/EmbeddedSurface.h"
#include "Mesh/EdgeTable.h"

namespace remesh
{
/**
 * Of the surface as it is embedded, cut open along its features. It does not depend on the sites,
 * and is found once for all diagrams of a surface.
 */
struct FacetJoins
{
  EdgeTable edges;
  /** F: bit k, side k has two facets; bit 3 + k, corner k is inside and this is its first facet. */
  std::vector<unsigned char> bits;

  bool isInnerSide(Index facet, int k) const { return (this->bits[facet] >> k & 1) != 0; }
  bool countsCorner(Index facet, int k) const { return (this->bits[facet] >> (3 + k) & 1) != 0; }
};

/**
 * @param edges of the surface, as it is embedded.
 * @return nothing for a cancelled run.
 * Cost: O(F), in parallel but for a pass over the edges. Keeps a byte for each facet, beside
 * `edges`, and takes 9 for each corner on the way.
 */
FacetJoins joinFacets(const EmbeddedSurface& surface, EdgeTable edges, const RunControl& control);
}

#endif
