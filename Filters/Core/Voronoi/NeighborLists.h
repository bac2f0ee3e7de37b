/**
 * @file NeighborLists.h
 * @brief The neighbours of each site by increasing distance, in lists that grow on demand and
 *        survive small moves.
 *
 * A list that ends before a radius of security is reached is extended by a longer query, never cut
 * off ([Levy12], Theorem 1 holds for any number of neighbours).
 *
 * Lists are kept while the sites move little (Verlet lists, as in molecular dynamics): with d0 the
 * distance when the list was built and delta the displacement since, the distance now is at least
 * d0 - delta_i - delta_max. All stopping tests use that lower bound, so they stay exact.
 */
#ifndef remesh_NeighborLists_h
#define remesh_NeighborLists_h

#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/NeighborSearch.h"

#include <optional>
#include <unordered_map>

namespace remesh
{
/** First neighbours of every site, shared by all threads and read only. */
class NeighborLists
{
public:
  NeighborLists() = default;
  NeighborLists(const NeighborLists&) = delete; // the tree points into this object
  NeighborLists& operator=(const NeighborLists&) = delete;

  /** Makes the lists valid for these sites: builds them if the sites have moved too far. */
  Status update(const Sites& sites, const RunControl& control);

  /** Builds the tree and the lists for these sites. */
  Status build(const Sites& sites, const RunControl& control);

  /** The list of a site, with distances when it was built. */
  const Neighbor* begin(Index site) const { return m_neighbors.data() + this->offset(site); }
  Index length() const { return m_length; }
  /** Whether the lists hold all sites. */
  bool complete() const { return m_length == m_search->numberOfSites() - 1; }

  /** At most by so much is a neighbour of this site nearer now than when the list was built. */
  double approach(Index site) const { return m_displacements[site] + m_largestDisplacement; }

  /** The tree over the sites as they were when the lists were built. */
  const NeighborSearch& search() const { return *m_search; }

private:
  Status measureDisplacements(const Sites& sites, const RunControl& control);
  std::size_t offset(Index site) const
  {
    return static_cast<std::size_t>(site) * static_cast<std::size_t>(m_length);
  }

  Sites m_built; ///< the sites when the lists were built
  std::optional<NeighborSearch> m_search;
  std::vector<Neighbor> m_neighbors; ///< n x length
  Index m_length = 0;
  double m_spacing = 0.0; ///< mean distance to the nearest neighbours when built

  std::vector<double> m_displacements; ///< n, since then
  double m_largestDisplacement = 0.0;
};

/** One thread's longer lists, kept while it works on a block. */
class LongerLists
{
public:
  /** A list of more than `count` neighbours of the site (or all there are). */
  const std::vector<Neighbor>& longerThan(Index count, Index site, const NeighborLists& lists);

  void clear() { m_lists.clear(); }

private:
  std::unordered_map<Index, std::vector<Neighbor>> m_lists;
};

/**
 * Walks through all other sites by increasing distance from one of them when the lists were built.
 * Sites at equal distances at the end of a list may come twice; none is missed.
 */
class NeighborWalk
{
public:
  NeighborWalk(const NeighborLists& lists, LongerLists& longer, Index site)
    : m_lists(lists)
    , m_longer(longer)
    , m_site(site)
    , m_next(lists.begin(site))
    , m_end(m_next + lists.length())
    , m_count(lists.length())
    , m_approach(lists.approach(site))
  {
  }

  /** Steps to the next neighbour; false when there is none. */
  bool next()
  {
    if (m_next == m_end && !this->extend())
    {
      return false;
    }
    m_current = m_next++;
    return true;
  }

  Index site() const { return m_current->site; }

  /** No site from here on is nearer than this. */
  double leastDistance() const { return m_current->distance - m_approach; }

private:
  bool extend();

  const NeighborLists& m_lists;
  LongerLists& m_longer;
  Index m_site;
  const Neighbor* m_next;
  const Neighbor* m_end;
  const Neighbor* m_current = nullptr;
  Index m_count;
  double m_approach;
};
}

#endif
