/**
 * @file FacetIntegration.h
 * @brief Integrals over the restricted cells on one facet, for the steps of an optimisation.
 *
 * 1. A reference site, one of the corners' owners, and its neighbours up to twice its distance from
 *    the facet's farthest corner: only they can win anything on the facet ([Levy12], Theorem 1).
 *    Their values at the corners come from the reference's packed bisectors, many at once
 *    (BisectorValues.h). Who is below the reference at no corner is out.
 * 2. Where that list is too short for it, the facet is large. The reference is the site that was
 *    nearest to its centre at the last evaluation, if it is known: its list may reach all around.
 * 3. Where it does not, either: the envelope of the owners and of the list is traced. A point at
 *    distance r from its site can only be won by a site within r of it, and so within r and the
 *    point's distance from the reference of the latter. Where the list does not reach that far, the
 *    neighbours of the part's own site join in, until nothing changes: from its list, or where that
 *    ends too early, too, as beside many sites close together, from the tree.
 *
 * Rounded, but never wrong by more than rounding: what cannot be vouched for is refused.
 */
#ifndef remesh_FacetIntegration_h
#define remesh_FacetIntegration_h

#include "Embedding/EmbeddedSurface.h"
#include "Voronoi/BisectorPacks.h"
#include "Voronoi/Envelope.h"
#include "Voronoi/NeighborLists.h"
#include "Voronoi/PieceIntegral.h"

namespace remesh
{
/** One thread's working memory. D: see dispatchDimension. */
template <int D>
class FacetIntegration
{
public:
  /**
   * @param centers for each large facet the site nearest to its centre, for others noIndex; kept
   *        from one evaluation to the next.
   */
  FacetIntegration(const EmbeddedSurface& surface, const Sites& sites, const NeighborLists& lists,
    const std::vector<Index>& owners, std::vector<Index>& centers, InstructionSet instructions);

  /**
   * The parts of all cells on a facet that several share. False: left to FacetDecomposition, for
   * too many sites, too many coordinates, or for rounding.
   */
  bool integrate(Index facet);

  /** Those in use, for others that look at the same sites. */
  BisectorPacks& packs() { return m_packs; }

  /** What was found: calls `add(site, integral)` for each part. */
  template <class Add>
  void forEachPart(const FacetConstants& facet, const Add& add) const
  {
    for (int slot = 0; slot < m_envelope.count; ++slot)
    {
      if (m_envelope.moments[slot][0] > minFraction)
      {
        add(m_ids[slot], this->integralOf(slot, facet));
      }
    }
  }

private:
  /** Smaller parts are rounding. */
  static constexpr double minFraction = 1e-12;
  static constexpr int maxViews = 4;

  /** The corners as a site sees them. */
  struct View
  {
    Index site = noIndex;
    double squared[3] = {};     ///< distances
    double values[3] = {};      ///< relative to the reference
    std::vector<double> points; ///< 3 x d
  };

  /** The sites that own a facet's corners, three in their order; of two the one with two first. */
  struct Owners
  {
    int count;
    Index sites[3];
  };

  struct PartReach
  {
    double radius = 0.0;
    double sum = 0.0;
  };

  Owners distinctOwners(const Triple& corners) const;
  Index bestOwner(const Triple& corners, const Owners& owners) const;
  bool seesAll(const View& view, double& farthest) const;
  bool isAway(const View& view) const;
  void look(Index site, const Triple& corners, View& view) const;
  void lookFrom(Index site, const Triple& corners);
  void addSite(Index site, const double values[3]);
  template <class Accept>
  bool addNeighbors(const View& view, double farthest, const Accept& accept);
  const View& addOwners(Index facet, const Owners& owners);
  bool integrateLarge(Index facet, const Owners& owners);
  Index nearestToCenter() const;
  bool checkCells(Index facet, bool& grown);
  bool meets(Index site, Index facet);
  bool addListed(Index site, Index facet, double farthest);
  bool addNearby(Index site, Index facet, double distance);
  void findReach(const FacetConstants& facet, PartReach reach[]) const;
  bool winsSomewhere(const double values[3]) const;
  PieceIntegral integralOf(int slot, const FacetConstants& facet) const;

  const EmbeddedSurface& m_surface;
  const Sites& m_sites;
  const NeighborLists& m_lists;
  const std::vector<Index>& m_owners;
  std::vector<Index>& m_centers;
  BisectorEvaluation m_evaluate;
  EnvelopeTracing m_trace;

  BisectorPacks m_packs;
  int m_stride;                       ///< of the packs
  std::vector<double> m_values;       ///< 3 x m_stride
  std::vector<std::uint8_t> m_chosen; ///< m_stride / lanes
  View m_views[maxViews];             ///< the reference, then other owners of corners
  int m_numberOfViews = 0;
  View m_cellView;

  std::vector<Index> m_facetOfSite; ///< per site, the last large facet it was met on
  std::vector<Index> m_expanded;    ///< the sites whose neighbours are in
  std::vector<Neighbor> m_near;
  Envelope m_envelope;
  Index m_ids[Envelope::maxSites];
};

extern template class FacetIntegration<3>;
extern template class FacetIntegration<6>;
extern template class FacetIntegration<Eigen::Dynamic>;
}

#endif
