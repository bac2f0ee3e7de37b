/**
 * @file VertexPlaces.h
 * @brief Where the vertices of pieces lie in their facets.
 *
 * A vertex is constructed from the sites that meet there in the order of their ids, and on an edge
 * from the edge's ends in the order of theirs. So it has the same coordinates, to the bit, in all
 * pieces around it, in the facet across an edge, and whenever it is asked for.
 */
#ifndef remesh_VertexPlaces_h
#define remesh_VertexPlaces_h

#include "Voronoi/Diagram.h"

namespace remesh
{
/**
 * The crossing of the bisector of two sites with edge `edge` of a facet.
 *
 * @param corners ids that make the edge's direction common to both sides.
 */
void placeOnEdge(
  const Triple& corners, const FacetSite& i, const FacetSite& j, int edge, double b[3]);

/** The point of a facet where the cells of three sites meet. */
void placeInside(const FacetSite& i, const FacetSite& j, const FacetSite& m, double b[3]);

/** Places of the vertices of a whole diagram. */
struct VertexPlaces
{
  const EmbeddedSurface& surface;
  const Sites& sites;
  const Diagram& diagram;

  /** Barycentric coordinates in the piece's facet. O(d). */
  std::array<double, 3> at(Offset piece, Offset vertex) const;
};

/** The same for one piece: faster where all of its vertices are asked for, one after the other. */
class PiecePlaces
{
public:
  PiecePlaces(const VertexPlaces& places, Offset piece);

  std::array<double, 3> at(Offset vertex);

private:
  static constexpr int ownSlot = 2;

  const FacetSite& see(Index site, int slot);

  const VertexPlaces& m_places;
  Offset m_piece;
  Index m_facet;
  FacetSite m_seen[3]; ///< across the last edges, and the piece's own
};
}

#endif
