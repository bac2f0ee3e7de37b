#include "Voronoi/Ownership.h"

#include "Embedding/CornerReader.h"
#include "Embedding/Distance.h"
#include "Support/Parallel.h"
#include "Voronoi/NeighborWalk.h"
#include "Voronoi/SecurityRadius.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
/** Far above the rounding of distances, far below the spacing of sites. */
constexpr double relativeRounding = 1e-12;
constexpr float noLead = -1.0F;
/** With fewer corners to a site, looking after the sites costs more than it saves. */
constexpr Index fewestCorners = 4;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr float told = std::numeric_limits<float>::infinity();

struct Nearer
{
  Index site = noIndex; ///< one that is nearer than the owner, or noIndex
  double owned = 0.0;   ///< squared distance of the owner
  double others = 0.0;  ///< no other site is known to be nearer than this, if there is none
};

/** The nearest site, or `owner`, from the tree: its first answer tells how far to look. */
template <int D>
Nearer findNearest(const double* point, Index owner, const Sites& sites, const NeighborLists& lists)
{
  const int d = sites.dimension;
  const double owned = squaredDistance<D>(sites.site(owner), point, d);
  const double first = squaredDistance<D>(sites.site(lists.search().nearest(point)), point, d);
  std::vector<Neighbor> found;
  lists.sitesNear(point, std::sqrt(std::min(owned, first)), found);
  Nearer result;
  Index best = owner;
  result.owned = owned;
  for (const Neighbor& neighbor : found)
  {
    const double other = squaredDistance<D>(sites.site(neighbor.site), point, d);
    if (other < result.owned || (other == result.owned && neighbor.site < best))
    {
      result.owned = other;
      best = neighbor.site;
    }
  }
  result.site = best == owner ? noIndex : best;
  return result;
}

/**
 * A site nearer to the point than `owner`. Sites farther than twice the owner's distance from the
 * owner cannot be.
 */
template <int D>
Nearer findNearer(const double* point, Index owner, const Sites& sites, const NeighborLists& lists,
  LongerLists& longer)
{
  const int d = sites.dimension;
  const SecurityRadius security(d);
  Nearer result;
  result.owned = squaredDistance<D>(sites.site(owner), point, d);
  const double radius = std::sqrt(result.owned);
  double second = infinity; // squared
  NeighborWalk walk(lists, longer, owner);
  int steps = 0;
  while (walk.next([&](double least) { return security.excludes(least, radius, radius); }))
  {
    if (++steps > longestWalk)
    {
      return findNearest<D>(point, owner, sites, lists);
    }
    const double other = squaredDistance<D>(sites.site(walk.site()), point, d);
    if (other < result.owned || (other == result.owned && walk.site() < owner))
    {
      result.site = walk.site();
      return result;
    }
    second = std::min(second, other);
  }
  result.others = std::min(std::sqrt(second), walk.leastDistance() - radius);
  return result;
}

/**
 * A site to walk from: the last corner's owner, if the point lies among the sites of its list; else
 * far from there, or in another patch, the way would be longer than a search.
 */
template <int D>
Index startOf(const double* point, Index last, const Sites& sites, const NeighborLists& lists)
{
  return last != noIndex &&
      std::sqrt(squaredDistance<D>(sites.site(last), point, sites.dimension)) < lists.reach(last)
    ? last
    : lists.search().nearest(point);
}

/** The sum of a lead and the drift, to be compared with later drifts. */
float kept(double owned, double others, double radius, double drift)
{
  const double lead = std::min(others - owned - relativeRounding * (others + owned), radius);
  if (owned > radius || lead <= 0.0)
  {
    return noLead;
  }
  return std::nextafter(static_cast<float>(lead + drift), noLead);
}
}

template <int D>
void Ownership::updateRange(Index begin, Index end, const EmbeddedSurface& surface,
  const Sites& sites, const NeighborLists& lists)
{
  LongerLists longer;
  CornerReader<D> reader(surface);
  Index last = noIndex;
  for (Index corner = begin; corner < end; ++corner)
  {
    Index owner = m_owners[corner];
    if (owner != noIndex && m_leads[corner] > m_drift.drift(owner))
    {
      if (!m_squared.empty())
      {
        m_squared[corner] =
          squaredDistance<D>(sites.site(owner), reader.corner(corner), sites.dimension);
      }
      continue;
    }
    const double* point = reader.corner(corner);
    if (owner == noIndex)
    {
      owner = startOf<D>(point, last, sites, lists);
    }
    Nearer nearer;
    do
    {
      owner = nearer.site != noIndex ? nearer.site : owner;
      nearer = findNearer<D>(point, owner, sites, lists, longer);
    } while (nearer.site != noIndex);
    m_owners[corner] = owner;
    last = owner;
    m_leads[corner] =
      kept(std::sqrt(nearer.owned), nearer.others, m_drift.radius(owner), m_drift.drift(owner));
    if (!m_squared.empty())
    {
      m_squared[corner] = nearer.owned;
    }
  }
}

void Ownership::begin(std::vector<Index> owners, const Sites& sites)
{
  m_owners = std::move(owners);
  m_leads.assign(m_owners.size(), noLead);
  m_squared.resize(sites.dimension >= manyDimensions ? m_owners.size() : 0);
  m_drift = SiteDrift();
  m_numberOfSites = sites.count();
}

void Ownership::know(std::vector<Index> owners, const Sites& sites)
{
  this->begin(std::move(owners), sites);
  std::transform(m_owners.begin(), m_owners.end(), m_leads.begin(),
    [](Index owner) { return owner == noIndex ? noLead : told; });
  m_someKnown = true;
}

Status Ownership::update(const EmbeddedSurface& surface, const Sites& sites,
  const NeighborLists& lists, const RunControl& control)
{
  const auto corners = static_cast<std::size_t>(surface.numberOfCorners());
  if (m_owners.size() != corners || m_numberOfSites != sites.count())
  {
    this->begin(std::vector<Index>(corners, noIndex), sites);
  }
  const bool keepsLeads = surface.numberOfCorners() / fewestCorners >= sites.count();
  if (Status status =
        keepsLeads ? m_drift.update(sites, lists, control.silent()) : Status::success();
      !status.ok())
  {
    m_owners.clear(); // what is told of some holds for these sites alone
    return status;
  }
  const bool done = forEachRange(Blocks::cut(surface.numberOfCorners(), 1024, 4096), control,
    [&](Offset begin, Offset end)
    {
      dispatchDimension(sites.dimension,
        [&](auto dimension)
        {
          this->updateRange<decltype(dimension)::value>(
            static_cast<Index>(begin), static_cast<Index>(end), surface, sites, lists);
        });
    });
  if (m_someKnown)
  {
    std::replace(m_leads.begin(), m_leads.end(), told, noLead);
    m_someKnown = false;
  }
  return done ? Status::success() : Status::cancelled();
}
}
