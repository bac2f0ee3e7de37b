/**
 * @file NeighborWalk.h
 * @brief Walks from site to site by increasing distance, beyond the ends of lists.
 *
 * A list that ends before a radius of security is reached is extended by a longer query, never cut
 * off ([Levy12], Theorem 1 holds for any number of neighbours).
 */
#ifndef remesh_NeighborWalk_h
#define remesh_NeighborWalk_h

#include "Voronoi/NeighborLists.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace remesh
{
/**
 * Of a walk through sites. Who is far from all sites against their spacing would meet them all: the
 * tree finds those near a point sooner then.
 */
constexpr int longestWalk = 100;

/** One thread's longer lists, kept while it works on a block. */
class LongerLists
{
public:
  /** A list of more than `count` neighbours of the site, or of all whose distance is finite. */
  const std::vector<Neighbor>& longerThan(Index count, Index site, const NeighborLists& lists);

  void clear() { m_lists.clear(); }

private:
  std::unordered_map<Index, std::vector<Neighbor>> m_lists;
};

/**
 * Walks through all other sites by increasing distance from one of them when the lists were built.
 * Sites near the end of a list may come twice; none is missed but those so far away that the square
 * of their distance was not finite.
 */
class NeighborWalk
{
public:
  NeighborWalk(const NeighborLists& lists, LongerLists& longer, Index site)
    : m_lists(lists)
    , m_longer(longer)
    , m_site(site)
    , m_list(lists.list(site))
    , m_count(m_list.count)
  {
  }

  /**
   * Steps to the next neighbour; false when there is none, or `excludes(distance)` rules out all
   * sites from the next one's least distance on.
   */
  template <class Excludes>
  bool next(const Excludes& excludes)
  {
    ++m_current;
    if (m_current == m_count)
    {
      const double unlisted = m_extended ? m_least : m_lists.reach(m_site);
      if (unlisted > m_least && excludes(unlisted))
      {
        m_least = unlisted;
        return false;
      }
      if (!this->extend())
      {
        m_least = std::numeric_limits<double>::infinity();
        return false;
      }
    }
    m_least = m_extended
      ? std::max(m_least, m_lists.minNow(m_site, (*m_extended)[m_current].distance))
      : std::min(
          m_list.distances[m_current] - m_lists.approachOfListed(m_site), m_lists.reach(m_site));
    return !excludes(m_least);
  }

  Index site() const
  {
    return m_extended ? (*m_extended)[m_current].site : m_list.sites[m_current];
  }

  /** No site from here on is nearer than this; infinity at the end of all. */
  double minDistance() const { return m_least; }

private:
  /** Goes on in a longer list; false when there is none. */
  bool extend();

  const NeighborLists& m_lists;
  LongerLists& m_longer;
  Index m_site;
  NeighborList m_list;
  const std::vector<Neighbor>* m_extended = nullptr; ///< instead of the list
  Index m_current = -1;
  double m_least = 0.0;
  Index m_count; ///< of what is walked through
};
}

#endif
