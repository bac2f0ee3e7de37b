/**
 * @file KeptPieces.h
 * @brief The facets whose pieces a few other sites leave as they are.
 *
 * A facet keeps its pieces if all of their sites are still there and no site that was added is so
 * near that it may win a point of the facet. What the diagram of the later sites has there is then
 * the same, to the bit: pieces depend on the sites that meet there, and on the order of their ids.
 */
#ifndef remesh_KeptPieces_h
#define remesh_KeptPieces_h

#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/Diagram.h"
#include "Voronoi/NeighborSearch.h"

namespace remesh
{
/** What an exact diagram was made of. */
struct EarlierSites
{
  const Sites& sites;
  const std::vector<Index>& owners; ///< C, of the corners
};

class KeptPieces
{
public:
  /** All must outlive this object. */
  KeptPieces(
    const EmbeddedSurface& surface, const EarlierSites& earlier, const Diagram& earlierDiagram)
    : m_surface(surface)
    , m_earlier(earlier)
    , m_diagram(earlierDiagram)
  {
  }

  /**
   * Cost: that of compareSites, O(pieces d) and, for each facet, a search among the added sites.
   * Parallel. No facet is kept in `manyDimensions`, where looking at the facets costs as much as
   * the diagram.
   */
  Status find(const Sites& sites, const RunControl& control);

  bool keeps(Index facet) const { return m_keeps[facet] != 0; }

  /** Calls `visit(site, integral)` for the pieces of a facet that is kept; sites by later ids. */
  template <class Visit>
  void forEachPiece(Index facet, const Visit& visit) const
  {
    for (Offset piece = m_diagram.facetBegin[facet]; piece < m_diagram.facetBegin[facet + 1];
         ++piece)
    {
      visit(m_later[m_diagram.sites[piece]], m_diagram.integralOf(piece));
    }
  }

  /** The ids that kept sites have now, by their earlier ones. Their order is the same. */
  const std::vector<Index>& later() const { return m_later; }

  /** C, the owners of the corners of kept facets; noIndex elsewhere. */
  std::vector<Index> owners() const;
  /** The sites that share the facets that are not kept, as far as they are known; ascending. */
  std::vector<Index> sitesAround(const Sites& sites) const;

private:
  template <int D>
  void findRange(Index begin, Index end, const NeighborSearch* added, const Sites& addedSites);

  const EmbeddedSurface& m_surface;
  EarlierSites m_earlier;
  const Diagram& m_diagram;
  std::vector<Index> m_later; ///< n earlier ones; noIndex for one that is gone
  std::vector<Index> m_added; ///< ascending
  std::vector<char> m_keeps;  ///< F
};
}

#endif
