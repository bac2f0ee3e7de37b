/**
 * @file NeighborLists.h
 * @brief The neighbours of each site by increasing distance, in lists that grow on demand.
 *
 * A list that ends before a radius of security is reached is extended by a longer query, never cut
 * off ([Levy12], Theorem 1 holds for any number of neighbours).
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
  /** Builds the tree and the lists for sites that stay in place while the lists are used. */
  Status build(const Sites& sites, const RunControl& control);

  const Neighbor* begin(Index site) const { return m_neighbors.data() + this->offset(site); }
  Index length() const { return m_length; }
  /** Whether the lists hold all sites. */
  bool complete() const { return m_length == m_search->numberOfSites() - 1; }
  const NeighborSearch& search() const { return *m_search; }

private:
  std::size_t offset(Index site) const
  {
    return static_cast<std::size_t>(site) * static_cast<std::size_t>(m_length);
  }

  std::optional<NeighborSearch> m_search;
  std::vector<Neighbor> m_neighbors; ///< n x length
  Index m_length = 0;
};

/** One thread's longer lists, kept while it works on a block. */
class LongerLists
{
public:
  /** A list of more than `count` neighbours of the site (or all there are). */
  const std::vector<Neighbor>& longerThan(
    Index count, Index site, const NeighborLists& lists);

  void clear() { m_lists.clear(); }

private:
  std::unordered_map<Index, std::vector<Neighbor>> m_lists;
};

/**
 * Walks through all sites by increasing distance from one of them. Sites at equal distances at the
 * end of a list may come twice; none is missed.
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
  {
  }

  /** The next neighbour, or nullptr when there is none. Valid until the next call. */
  const Neighbor* next() { return m_next != m_end || this->extend() ? m_next++ : nullptr; }

private:
  bool extend();

  const NeighborLists& m_lists;
  LongerLists& m_longer;
  Index m_site;
  const Neighbor* m_next;
  const Neighbor* m_end;
  Index m_count;
};
}

#endif
