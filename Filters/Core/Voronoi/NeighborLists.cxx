#include "Voronoi/NeighborLists.h"

#include "Embedding/Distance.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
/** Enough for most cells of a relaxed sampling; the rest is extended. */
constexpr Index firstLength = 20;
/** Neighbours whose mean distance tells the spacing of the sites. */
constexpr Index nearNeighbors = 3;
/** Lists are built anew when a site has moved by more than this part of the spacing. */
constexpr double farthestMove = 0.4;
/** Covers the rounding of the distances that the displacements are compared with. */
constexpr double aboveRounding = 1.0 + 1e-12;

const Blocks blocksOf(const Sites& sites)
{
  return Blocks::cut(sites.count(), 1024, 4096);
}
}

Status NeighborLists::update(const Sites& sites, const RunControl& control)
{
  if (!m_search || m_built.coordinates.size() != sites.coordinates.size())
  {
    return this->build(sites, control);
  }
  if (Status status = this->measureDisplacements(sites, control.silent()); !status.ok())
  {
    return status;
  }
  return m_largestDisplacement > farthestMove * m_spacing ? this->build(sites, control)
                                                          : Status::success();
}

Status NeighborLists::measureDisplacements(const Sites& sites, const RunControl& control)
{
  const bool done = forEachRange(blocksOf(sites), control,
    [&](Offset begin, Offset end)
    {
      for (Offset k = begin; k < end; ++k)
      {
        const auto site = static_cast<Index>(k);
        m_displacements[k] = aboveRounding *
          std::sqrt(
            squaredDistance<Eigen::Dynamic>(sites.site(site), m_built.site(site), sites.dimension));
      }
    });
  m_largestDisplacement = *std::max_element(m_displacements.begin(), m_displacements.end());
  return done ? Status::success() : Status::cancelled();
}

Status NeighborLists::build(const Sites& sites, const RunControl& control)
{
  m_built = sites;
  m_search.emplace(m_built);
  const Index count = sites.count();
  m_length = std::min(firstLength, count - 1);
  m_neighbors.resize(static_cast<std::size_t>(count) * static_cast<std::size_t>(m_length));
  m_displacements.assign(static_cast<std::size_t>(count), 0.0);
  m_largestDisplacement = 0.0;
  const Blocks blocks = blocksOf(sites);
  std::vector<double> nearDistances(static_cast<std::size_t>(blocks.count()), 0.0);
  const Index near = std::min(nearNeighbors, m_length);
  const bool done = forEachBlock(blocks.count(), control,
    [&](Offset block)
    {
      std::vector<Neighbor> found;
      for (Offset site = blocks.begin(block); site < blocks.end(block); ++site)
      {
        const auto id = static_cast<Index>(site);
        m_search->neighbors(id, m_length, found);
        std::copy(found.begin(), found.end(), m_neighbors.begin() + this->offset(id));
        for (Index k = 0; k < near; ++k)
        {
          nearDistances[block] += found[k].distance;
        }
      }
    });
  double sum = 0.0;
  for (const double distance : nearDistances)
  {
    sum += distance;
  }
  m_spacing = near > 0 ? sum / (static_cast<double>(near) * count) : 0.0;
  if (!done)
  {
    m_search.reset(); // half-filled lists are none
    return Status::cancelled();
  }
  return Status::success();
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
