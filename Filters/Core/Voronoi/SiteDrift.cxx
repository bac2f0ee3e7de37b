#include "Voronoi/SiteDrift.h"

#include "Embedding/Distance.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
/** The part of its list's reach that a site starts with as radius; at a third it ends. */
constexpr double partOfReach = 0.26;

double firstRadius(Index site, const NeighborLists& lists)
{
  const NeighborList list = lists.list(site);
  const double reach = lists.reach(site);
  // A list that holds all sites reaches everywhere.
  const double finite = std::isfinite(reach) ? reach
    : list.count > 0                         ? list.distances[list.count - 1]
                                             : 1.0;
  return partOfReach * std::max(finite, 0.0);
}
}

/** From where they were at the last update. */
bool SiteDrift::measureMoves(const Sites& sites, const RunControl& control)
{
  return dispatchDimension(sites.dimension,
    [&](auto dimension)
    {
      return forEachItem(siteBlocks(sites), control,
        [&](Offset k)
        {
          const auto site = static_cast<Index>(k);
          const double squared = squaredDistance<decltype(dimension)::value>(
            sites.site(site), m_last.site(site), sites.dimension);
          m_moves[k] = aboveRounding * std::sqrt(squared);
        });
    });
}

Status SiteDrift::update(const Sites& sites, const NeighborLists& lists, const RunControl& control)
{
  const auto n = static_cast<std::size_t>(sites.count());
  if (m_last.coordinates.size() != sites.coordinates.size())
  {
    m_places.assign(n, Place{});
    m_moves.assign(n, 0.0);
    m_last = sites;
  }
  const bool done = this->measureMoves(sites, control.silent()) &&
    forEachItem(siteBlocks(sites), control.silent(),
      [&](Offset k)
      {
        const auto site = static_cast<Index>(k);
        Place& place = m_places[k];
        if (place.radius == 0.0 && !lists.isListed(site))
        {
          return; // nobody has asked for it
        }
        place.drift += m_moves[k] + lists.list(site).largestOf(m_moves);
        place.radius += m_moves[k];
        // Others are at least 3 radii away, and so 2 from each point: they lead by 1.
        double farthest = 0.0;
        if (place.radius == 0.0 || !lists.holds(site, 3.0 * place.radius, farthest))
        {
          place.drift += place.radius; // more than any lead
          place.radius = firstRadius(site, lists);
        }
      });
  if (!done)
  {
    m_last = Sites{}; // begin anew
    return Status::cancelled();
  }
  m_last = sites;
  return Status::success();
}
}
