/**
 * @file SiteDrift.h
 * @brief How much the lead of a site over all others may have shrunk while the sites moved.
 *
 * The lead of a site at a point is the distance from the point to the nearest other site less that
 * to the site. It shrinks by no more than the site and another one move (Hamerly, "Making k-means
 * even faster", 2010). Here only the neighbours' moves count, and not the farthest move of all
 * sites: within `radius()` of a site, all sites that are not in its list are known to be so far
 * that their lead is more than any that is kept.
 */
#ifndef remesh_SiteDrift_h
#define remesh_SiteDrift_h

#include "Voronoi/NeighborLists.h"

namespace remesh
{
class SiteDrift
{
public:
  /** Adds what the sites moved since the last call. The lists must be those of these sites. */
  Status update(const Sites& sites, const NeighborLists& lists, const RunControl& control);

  /** The shrinkage up to now at the points within radius() of the site; it only grows. */
  double drift(Index site) const { return m_places.empty() ? 0.0 : m_places[site].drift; }

  /** A lead must not be kept at points farther away, nor if it is larger. */
  double radius(Index site) const { return m_places.empty() ? 0.0 : m_places[site].radius; }

private:
  struct Place
  {
    double drift = 0.0;
    double radius = 0.0;
  };

  bool measureMoves(const Sites& sites, const RunControl& control);

  Sites m_last;
  std::vector<double> m_moves; ///< n, of the last update
  std::vector<Place> m_places; ///< n
};
}

#endif
