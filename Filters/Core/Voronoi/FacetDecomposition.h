/**
 * @file FacetDecomposition.h
 * @brief Cuts one facet into the pieces of all restricted cells that meet it.
 *
 * 1. The owners of the corners are known. One owner for all three: the facet lies wholly in that
 *    (convex) cell.
 * 2. Otherwise, where the facet is small against the cells, the few sites that may have a piece are
 *    gathered: |c - x_j| <= |c - x_o| + 2 rho (c, rho: the facet's centre and radius, o: an owner),
 *    and better than each owner at some corner.
 * 3. Each piece starts as the facet and is clipped, with those sites, or, where they are too many,
 *    with the neighbours of its site by increasing distance, until the radius of security ([Levy12]
 *    Algorithm 2). The bisectors that bound a piece name the next ones ([Levy12] 4.2, the
 *    propagation over the cell graph, inside one facet). Where all sites are far away against their
 *    spacing, nearly all are within that radius: then the sites nearest to the piece's vertices are
 *    looked for instead. One that takes a part of a convex piece wins a vertex of it.
 *
 * The result is exact either way. Cost: O(k) distances in R^d for k sites near the facet.
 */
#ifndef remesh_FacetDecomposition_h
#define remesh_FacetDecomposition_h

#include "Embedding/CornerReader.h"
#include "Voronoi/FacetTiling.h"
#include "Voronoi/NeighborWalk.h"
#include "Voronoi/SecurityRadius.h"

namespace remesh
{
struct FacetPiece
{
  int slot = 0;
  Polygon polygon;
};

/** One thread's working memory for cutting facets. D: see dispatchDimension. */
template <int D>
class FacetDecomposition
{
public:
  FacetDecomposition(const EmbeddedSurface& surface, const Sites& sites, const NeighborLists& lists,
    const std::vector<Index>& owners, Decisions decisions = Decisions::Exact);

  /** Forgets longer lists; call between blocks to bound the memory. */
  void beginBlock() { m_longer.clear(); }

  /**
   * Steps 1 and 2: the sites that may have a piece. `tile` must follow on the same facet.
   */
  void gather(Index facet);

  /** Step 3: cuts that facet; the pieces and `tiling` then hold the result until the next facet. */
  void tile();

  /**
   * Lets each piece begin with its edge to the site of the highest id, so that no bit of what is
   * summed up over its vertices depends on the order in which it was cut.
   */
  void fixFirstVertices();

  /** Pieces by increasing site id. */
  const FacetPiece* begin() const { return m_pieces.data(); }
  const FacetPiece* end() const { return m_pieces.data() + m_used; }
  const FacetTiling& tiling() const { return m_tiling; }

private:
  /** The site's H values on the facet last gathered for. */
  FacetSite see(Index site) const;
  bool gatherCandidates(Index facet);
  bool addCandidate(Index site);
  void clipWithCandidates(FacetPiece& piece);
  void clipWithNeighbors(FacetPiece& piece);
  void clipAroundVertices(FacetPiece& piece);
  bool clipAround(PieceVertex vertex, FacetPiece& piece);
  int slotOf(Index site);
  int addSlot(const FacetSite& seen);
  void enqueue(int slot);

  const EmbeddedSurface& m_surface;
  const Sites& m_sites;
  const NeighborLists& m_lists;
  const std::vector<Index>& m_owners;
  CornerReader<D> m_corners;
  std::array<const double*, 3> m_points = {}; ///< of the facet last gathered for
  SecurityRadius m_security;
  LongerLists m_longer;
  FacetTiling m_tiling;

  std::vector<FacetPiece> m_pieces; ///< the first m_used are this facet's; the rest is capacity
  std::size_t m_used = 0;
  bool m_complete = false;         ///< whether the slots hold all sites that matter
  std::vector<char> m_queued;      ///< per slot
  std::vector<Index> m_slotOfSite; ///< per site, valid where m_cutOfSlot is this cut
  std::vector<Index> m_cutOfSlot;  ///< per site
  Index m_cut = 0;                 ///< counts the calls of gather()
  std::vector<double> m_center;    ///< d
  std::vector<double> m_vertex;    ///< d
  std::vector<Neighbor> m_near;
};

extern template class FacetDecomposition<3>;
extern template class FacetDecomposition<6>;
extern template class FacetDecomposition<Eigen::Dynamic>;
}

#endif
