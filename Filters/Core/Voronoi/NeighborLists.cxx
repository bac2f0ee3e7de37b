#include "Voronoi/NeighborLists.h"

#include "Support/Parallel.h"

#include <algorithm>

namespace remesh
{
namespace
{
/** Enough for most cells of a relaxed sampling; the rest is extended. */
constexpr Index firstLength = 20;
}

Status NeighborLists::build(const Sites& sites, const RunControl& control)
{
  m_search.emplace(sites);
  const Index count = sites.count();
  m_length = std::min(firstLength, count - 1);
  m_neighbors.resize(static_cast<std::size_t>(count) * static_cast<std::size_t>(m_length));
  const bool done = forEachRange(Blocks::cut(count, 1024, 4096), control,
    [&](Offset begin, Offset end)
    {
      std::vector<Neighbor> found;
      for (Offset site = begin; site < end; ++site)
      {
        const auto id = static_cast<Index>(site);
        m_search->neighbors(id, m_length, found);
        std::copy(found.begin(), found.end(), m_neighbors.begin() + this->offset(id));
      }
    });
  return done ? Status::success() : Status::cancelled();
}

const std::vector<Neighbor>& LongerLists::longerThan(
  Index count, Index site, const NeighborLists& lists)
{
  std::vector<Neighbor>& list = m_lists[site];
  if (static_cast<Index>(list.size()) <= count)
  {
    const Offset doubled = 2 * static_cast<Offset>(count) + 2;
    const Offset all = lists.search().numberOfSites();
    lists.search().neighbors(site, static_cast<Index>(std::min(doubled, all)), list);
  }
  return list;
}

bool NeighborWalk::extend()
{
  if (m_count >= m_lists.search().numberOfSites() - 1)
  {
    return false;
  }
  // Equal distances may be ordered otherwise in the longer list: go back to the first of them.
  const double reached = m_count > 0 ? (m_end - 1)->distance : 0.0;
  const std::vector<Neighbor>& list = m_longer.longerThan(m_count, m_site, m_lists);
  m_next = std::lower_bound(list.data(), list.data() + list.size(), reached,
    [](const Neighbor& neighbor, double distance) { return neighbor.distance < distance; });
  m_end = list.data() + list.size();
  m_count = static_cast<Index>(list.size());
  return true;
}
}
