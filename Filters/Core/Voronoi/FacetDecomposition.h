/**
 * @file FacetDecomposition.h
 * @brief Cuts one facet into the pieces of all restricted cells that meet it.
 *
 * 1. The owners of the corners are known. One owner for all three: the facet lies wholly in that
 *    (convex) cell.
 * 2. Otherwise each piece starts as the facet and is clipped; the bisectors that bound it name the
 *    next pieces ([Levy12] 4.2, the propagation over the cell graph, inside one facet).
 * 3. What a piece is clipped with: where the facet is small against the cells, the few sites with
 *    |c - x_j| <= |c - x_o| + 2 rho (c, rho: the facet's centre and radius, o: an owner), gathered
 *    once for the facet; else the neighbours of its site by increasing distance, until the radius
 *    of security ([Levy12] Algorithm 2).
 *
 * The result is exact either way. Cost: O(k) distances in R^d for k sites near the facet.
 */
#ifndef remesh_FacetDecomposition_h
#define remesh_FacetDecomposition_h

#include "Voronoi/FacetTiling.h"
#include "Voronoi/NeighborLists.h"
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
  FacetDecomposition(const EmbeddedSurface& surface, const Sites& sites,
    const NeighborLists& lists, const std::vector<Index>& owners);

  /** Forgets longer lists; call between blocks to bound the memory. */
  void beginBlock() { m_longer.clear(); }

  /** Cuts a facet; `pieces` and `tiling` then hold the result, until the next call. */
  void cut(Index facet);

  /** Pieces by increasing site id. */
  const FacetPiece* begin() const { return m_pieces.data(); }
  const FacetPiece* end() const { return m_pieces.data() + m_used; }
  const FacetTiling& tiling() const { return m_tiling; }

  /** The site's H values on a facet. */
  FacetSite see(Index facet, Index site) const;

private:
  bool gatherCandidates(Index facet);
  bool addCandidate(Index facet, Index site);
  void clipWithCandidates(FacetPiece& piece);
  void clipWithNeighbors(Index facet, FacetPiece& piece);
  int slotOf(Index facet, Index site);
  int addSlot(const FacetSite& seen);
  void enqueue(int slot);

  const EmbeddedSurface& m_surface;
  const Sites& m_sites;
  const NeighborLists& m_lists;
  const std::vector<Index>& m_owners;
  SecurityRadius m_security;
  LongerLists m_longer;
  FacetTiling m_tiling;

  std::vector<FacetPiece> m_pieces; ///< the first m_used are this facet's; the rest is capacity
  std::size_t m_used = 0;
  std::vector<char> m_queued;       ///< per slot
  std::vector<Index> m_slotOfSite;  ///< per site, valid where m_cutOfSlot is this cut
  std::vector<Index> m_cutOfSlot;   ///< per site
  Index m_cut = 0;                  ///< counts the calls of cut()
  std::vector<double> m_center;     ///< d
};

extern template class FacetDecomposition<3>;
extern template class FacetDecomposition<6>;
extern template class FacetDecomposition<8>;
extern template class FacetDecomposition<Eigen::Dynamic>;
}

#endif
