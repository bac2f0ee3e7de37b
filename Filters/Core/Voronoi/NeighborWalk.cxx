#include "Voronoi/NeighborWalk.h"

#include <algorithm>
#include <limits>

namespace remesh
{
const std::vector<Neighbor>& LongerLists::longerThan(
  Index count, Index site, const NeighborLists& lists)
{
  std::vector<Neighbor>& list = m_lists[site];
  if (static_cast<Index>(list.size()) <= count)
  {
    const Offset doubled = 2 * static_cast<Offset>(count) + 2;
    const Offset all = lists.search().numberOfSites();
    lists.search().neighbors(site, static_cast<Index>(std::min(doubled, all)),
      std::numeric_limits<double>::infinity(), list);
  }
  return list;
}

bool NeighborWalk::extend()
{
  if (m_count >= m_lists.search().numberOfSites() - 1)
  {
    return false;
  }
  // The order at the end may be another in the longer list: go back to the first that is as far.
  const double reached = m_count == 0 ? 0.0
    : m_extended                      ? m_extended->back().distance
                                      : m_list.distances[m_count - 1];
  const std::vector<Neighbor>& longer = m_longer.longerThan(m_count, m_site, m_lists);
  if (static_cast<Index>(longer.size()) <= m_count)
  {
    return false;
  }
  m_extended = &longer;
  const auto first = std::lower_bound(m_extended->begin(), m_extended->end(), reached,
    [](const Neighbor& neighbor, double distance) { return neighbor.distance < distance; });
  m_current = static_cast<Index>(first - m_extended->begin());
  m_count = static_cast<Index>(m_extended->size());
  return true;
}
}
