/**
 * @file FacetTiling.h
 * @brief The pieces of restricted cells that tile one facet: clipping in barycentric coordinates.
 *
 * [Levy12] Algorithm 2 with the facet's plane as the whole world: a piece starts as the facet and
 * is cut by bisectors (Sutherland-Hodgman). Which vertices a bisector cuts off is decided exactly
 * (Predicates.h); coordinates are only constructed, in a way that all pieces around a vertex share
 * (VertexPlaces.h).
 *
 * Invariant: a piece is convex, counter-clockwise in the facet's orientation, and its
 * combinatorics is that of the perturbed lower envelope.
 */
#ifndef remesh_FacetTiling_h
#define remesh_FacetTiling_h

#include "Embedding/EmbeddedSurface.h"
#include "Voronoi/Predicates.h"

#include <vector>

namespace remesh
{
struct PieceVertex
{
  double b[3]; ///< barycentric coordinates in the facet
  int edge;    ///< edge that starts here: slot of the site across, or -1 - k on the facet's edge k
};

using Polygon = std::vector<PieceVertex>;

/** The sites met on one facet, in slots, and the clipping against them. */
class FacetTiling
{
public:
  explicit FacetTiling(Decisions decisions = Decisions::Exact)
    : m_decisions(decisions)
  {
  }

  /** Starts a facet. `corners` are the ids that make an edge's direction common to both sides. */
  void begin(const Triple& corners, const FacetConstants& constants);

  int numberOfSites() const { return static_cast<int>(m_sites.size()); }
  const FacetSite& site(int slot) const { return m_sites[slot]; }
  int addSite(const FacetSite& site);

  /** The whole facet. */
  void wholeFacet(Polygon& polygon) const;

  /** Removes from the piece of slot i what slot q wins. Returns whether anything was removed. */
  bool clip(Polygon& polygon, int i, int q);

  /** |p(b) - x_i|^2 in R^d. */
  double squaredDistance(int slot, const double b[3]) const;

  /** Largest squared distance from site i to a point of its piece. */
  double squaredRadius(const Polygon& polygon, int slot) const;

private:
  bool beats(const Polygon& polygon, int vertex, int i, int q) const;
  void construct(int i, int incoming, int outgoing, double b[3]) const;

  Decisions m_decisions;
  Triple m_corners{};
  FacetConstants m_constants;
  std::vector<FacetSite> m_sites;
  Polygon m_clipped;
  std::vector<char> m_beaten;
};
}

#endif
