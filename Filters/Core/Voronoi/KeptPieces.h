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
/** An exact diagram. */
struct EarlierDiagram
{
  const Sites& sites;
  const Diagram& diagram;
  const std::vector<Index>& owners; ///< C, of the corners
};

class KeptPieces
{
public:
  /** Both must outlive this object. */
  KeptPieces(const EmbeddedSurface& surface, const EarlierDiagram& earlier)
    : m_surface(surface)
    , m_earlier(earlier)
  {
  }

  /**
   * Cost: that of compareSites, O(pieces d) and, for each facet, a search among the added sites.
   * Parallel. No facet is kept in `manyDimensions`, where looking at the facets costs as much as
   * the diagram.
   */
  Status find(const Sites& sites, const RunControl& control);

  bool keeps(Index facet) const { return m_keeps[facet] != 0; }

  /** Calls `visit(piece)` for the earlier pieces of a facet that is kept. */
  template <class Visit>
  void forEachPiece(Index facet, const Visit& visit) const
  {
    for (Offset piece = this->diagram().facetBegin[facet];
         piece < this->diagram().facetBegin[facet + 1]; ++piece)
    {
      visit(piece);
    }
  }

  const Diagram& diagram() const { return m_earlier.diagram; }
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
  EarlierDiagram m_earlier;
  std::vector<Index> m_later; ///< n earlier ones; noIndex for one that is gone
  std::vector<Index> m_added; ///< ascending
  std::vector<char> m_keeps;  ///< F
};
}

#endif
