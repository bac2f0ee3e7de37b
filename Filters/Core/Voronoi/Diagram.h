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
/**
 * Pieces ordered by facet, then by site. Every facet has at least one piece. The vertices of a
 * piece go counter-clockwise in its facet; where they lie follows from the sites around them
 * (VertexPlaces), and is not stored: at a million sites it would be the larger part of a run's
 * memory.
 *
 * Invariant: the combinatorics is that of the perturbed diagram, in which no four cells meet.
 */
struct Diagram
{
  std::vector<Index> facetBegin;     ///< F + 1, into the pieces
  std::vector<Index> sites;          ///< P
  std::vector<Index> facets;         ///< P
  std::vector<PieceWeights> weights; ///< P
  std::vector<double> energies;      ///< P, as in PieceIntegral; or freed (Remesh.cxx)
  std::vector<Index> vertexBegin;    ///< P + 1, into the vertices
  /** V, site beyond the edge that starts at a vertex, or -1 - k on the facet's edge k. */
  std::vector<Index> across;

  Offset numberOfPieces() const { return static_cast<Offset>(this->sites.size()); }
  bool hasOnePiece(Index facet) const
  {
    return this->facetBegin[facet + 1] - this->facetBegin[facet] == 1;
  }
  PieceIntegral integralOf(Offset piece) const
  {
    return { this->weights[piece], this->energies[piece] };
  }
  Offset numberOfVertices() const { return static_cast<Offset>(this->across.size()); }

  /** As `across`, for the edge that ends at a vertex of a piece. */
  Index acrossIncoming(Offset piece, Offset vertex) const
  {
    const bool first = vertex == this->vertexBegin[piece];
    return this->across[(first ? this->vertexBegin[piece + 1] : vertex) - 1];
  }

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
