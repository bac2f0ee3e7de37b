#include "Voronoi/OwnerSearch.h"

#include "Support/Lanes.h"
#include "Voronoi/SecurityRadius.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
/** Far above the rounding of values, in parts of the largest squared distance that matters. */
constexpr double roundingOfTie = 1e-12;
}

template <int D>
OwnerSearch<D>::OwnerSearch(
  const Sites& sites, const NeighborLists& lists, bool packs, InstructionSet instructions)
  : m_sites(sites)
  , m_lists(lists)
  , m_least(bisectorMinimum(instructions))
{
  if (packs && sites.dimension <= BisectorPacks::maxDimensions)
  {
    m_packs.emplace(sites, lists, instructions);
    m_offset.resize(static_cast<std::size_t>(sites.dimension));
    m_values.resize(static_cast<std::size_t>(m_packs->stride()));
  }
}

template <int D>
typename OwnerSearch<D>::Owner OwnerSearch<D>::find(const double* point, Index start)
{
  Owner owner;
  owner.site = start == noIndex ? this->startOf(point) : start;
  Nearer nearer;
  while (true)
  {
    if (!this->findNearerPacked(point, owner.site, nearer))
    {
      nearer = this->findNearer(point, owner.site);
    }
    if (nearer.site == noIndex)
    {
      break;
    }
    owner.site = nearer.site;
  }
  m_last = owner.site;
  owner.squared = nearer.owned;
  owner.others = nearer.others;
  return owner;
}

/**
 * A site to walk from: the last point's owner, if the point lies among the sites of its list; else
 * far from there, or in another patch, the way would be longer than a search.
 */
template <int D>
Index OwnerSearch<D>::startOf(const double* point) const
{
  return m_last != noIndex &&
      std::sqrt(squaredDistance<D>(m_sites.site(m_last), point, m_sites.dimension)) <
        m_lists.reach(m_last)
    ? m_last
    : m_lists.search().nearest(point);
}

/** False: cannot be told this way. */
template <int D>
bool OwnerSearch<D>::findNearerPacked(const double* point, Index owner, Nearer& result)
{
  if (!m_packs)
  {
    return false;
  }
  const int d = D == Eigen::Dynamic ? m_sites.dimension : D;
  const double* x = m_sites.site(owner);
  double squared = 0.0;
  for (int m = 0; m < d; ++m)
  {
    m_offset[m] = point[m] - x[m];
    squared += m_offset[m] * m_offset[m];
  }
  const double radius = std::sqrt(squared);
  double farthest = 0.0;
  if (!m_lists.holds(owner, 2.0 * radius * aboveRounding, farthest))
  {
    return false;
  }
  const NeighborList list = m_lists.list(owner);
  Index count = 0; // of whole lanes
  while (count < list.count && list.distances[count] <= farthest)
  {
    count += lanes;
  }
  const double least = m_least(
    { m_packs->of(owner, count), m_packs->stride(), count, m_offset.data(), d, m_values.data() });
  if (std::abs(least) <= roundingOfTie * farthest * farthest)
  {
    return false;
  }
  result.owned = squared;
  if (least < 0.0)
  {
    result.site = list.sites[std::find(m_values.begin(), m_values.end(), least) - m_values.begin()];
    return true;
  }
  result.site = noIndex;
  const double unseen = count < list.count
    ? std::min(list.distances[count] - m_lists.approachOfListed(owner), m_lists.reach(owner))
    : m_lists.reach(owner);
  result.others = std::min(std::sqrt(squared + least), unseen - radius);
  return true;
}

/**
 * A site nearer to the point than `owner`. Sites farther than twice the owner's distance from the
 * owner cannot be.
 */
template <int D>
typename OwnerSearch<D>::Nearer OwnerSearch<D>::findNearer(const double* point, Index owner)
{
  const int d = m_sites.dimension;
  const SecurityRadius security(d);
  Nearer result;
  result.owned = squaredDistance<D>(m_sites.site(owner), point, d);
  const double radius = std::sqrt(result.owned);
  double second = std::numeric_limits<double>::infinity(); // squared
  NeighborWalk walk(m_lists, m_longer, owner);
  int steps = 0;
  while (walk.next([&](double least) { return security.excludes(least, radius, radius); }))
  {
    if (++steps > longestWalk)
    {
      return this->findNearest(point, owner);
    }
    const double other = squaredDistance<D>(m_sites.site(walk.site()), point, d);
    if (other < result.owned || (other == result.owned && walk.site() < owner))
    {
      result.site = walk.site();
      return result;
    }
    second = std::min(second, other);
  }
  result.others = std::min(std::sqrt(second), walk.minDistance() - radius);
  return result;
}

/** The nearest site, or `owner`, from the tree: its first answer tells how far to look. */
template <int D>
typename OwnerSearch<D>::Nearer OwnerSearch<D>::findNearest(const double* point, Index owner)
{
  const int d = m_sites.dimension;
  const double owned = squaredDistance<D>(m_sites.site(owner), point, d);
  const double first = squaredDistance<D>(m_sites.site(m_lists.search().nearest(point)), point, d);
  std::vector<Neighbor> found;
  m_lists.sitesNear(point, std::sqrt(std::min(owned, first)), found);
  Nearer result;
  Index best = owner;
  result.owned = owned;
  for (const Neighbor& neighbor : found)
  {
    const double other = squaredDistance<D>(m_sites.site(neighbor.site), point, d);
    if (other < result.owned || (other == result.owned && neighbor.site < best))
    {
      result.owned = other;
      best = neighbor.site;
    }
  }
  result.site = best == owner ? noIndex : best;
  return result;
}

template class OwnerSearch<3>;
template class OwnerSearch<6>;
template class OwnerSearch<Eigen::Dynamic>;
}
