/**
 * @file Diagram.h
 * @brief The restricted Voronoi diagram as a list of convex pieces, facet by facet.
 */
#ifndef remesh_Diagram_h
#define remesh_Diagram_h

#include "Voronoi/PieceIntegral.h"

#include <algorithm>

namespace remesh
{
/** A vertex of a piece and the edge that starts there (counter-clockwise in the facet). */
struct DiagramVertex
{
  double b[3];  ///< barycentric coordinates in the facet
  Index across; ///< site beyond the edge, or -1 - k where the edge lies on the facet's edge k
};

/**
 * Pieces ordered by facet, then by site. Every facet has at least one piece.
 *
 * Invariants: around a point where three pieces of a facet meet, and along the facet's edges, the
 * vertices are bitwise equal in all pieces and facets that share them; the combinatorics is that
 * of the perturbed diagram, in which no four cells meet.
 */
struct Diagram
{
  std::vector<Offset> facetBegin;       ///< F + 1, into the pieces
  std::vector<Index> sites;             ///< P
  std::vector<Index> facets;            ///< P
  std::vector<PieceIntegral> integrals; ///< P
  std::vector<Offset> vertexBegin;      ///< P + 1, into `vertices`
  std::vector<DiagramVertex> vertices;

  Offset numberOfPieces() const { return static_cast<Offset>(this->sites.size()); }

  /** The piece of `site` in `facet`, or -1. O(log) of the facet's pieces. */
  Offset pieceOf(Index facet, Index site) const
  {
    const auto begin = this->sites.begin() + this->facetBegin[facet];
    const auto end = this->sites.begin() + this->facetBegin[facet + 1];
    const auto found = std::lower_bound(begin, end, site);
    return found != end && *found == site ? found - this->sites.begin() : -1;
  }
};
}

#endif
