#include "Voronoi/Ownership.h"

#include "Embedding/CornerReader.h"
#include "Embedding/Distance.h"
#include "Support/FloatBounds.h"
#include "Support/Parallel.h"
#include "Voronoi/OwnerSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
/** Far above the rounding of distances, far below the spacing of sites. */
constexpr double roundingOfLead = 1e-12;
constexpr float noLead = -1.0F;
/** With fewer corners to a site, looking after the sites costs more than it saves. */
constexpr Index minCorners = 4;
constexpr float told = std::numeric_limits<float>::infinity();

/** The sum of a lead and the drift, to be compared with later drifts. */
float kept(double owned, double others, double radius, double drift)
{
  const double lead = std::min(others - owned - roundingOfLead * (others + owned), radius);
  if (owned > radius || lead <= 0.0)
  {
    return noLead;
  }
  return below(lead + drift);
}
}

template <int D>
void Ownership::updateRange(Index begin, Index end, const EmbeddedSurface& surface,
  const Sites& sites, OwnerSearch<D>& search)
{
  CornerReader<D> reader(surface);
  for (Index corner = begin; corner < end; ++corner)
  {
    const Index owner = m_owners[corner];
    if (owner != noIndex && m_leads[corner] > m_drift.drift(owner))
    {
      if (!m_squared.empty())
      {
        m_squared[corner] =
          squaredDistance<D>(sites.site(owner), reader.corner(corner), sites.dimension);
      }
      continue;
    }
    const typename OwnerSearch<D>::Owner found = search.find(reader.corner(corner), owner);
    m_owners[corner] = found.site;
    m_leads[corner] = kept(std::sqrt(found.squared), found.others, m_drift.radius(found.site),
      m_drift.drift(found.site));
    if (!m_squared.empty())
    {
      m_squared[corner] = found.squared;
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
  const Index asked = std::min(m_corners, surface.numberOfCorners());
  const bool keepsLeads = asked / minCorners >= m_share * sites.count();
  if (Status status =
        keepsLeads ? m_drift.update(sites, lists, control.silent()) : Status::success();
      !status.ok())
  {
    m_owners.clear(); // what is told of some holds for these sites alone
    return status;
  }
  const bool done = dispatchDimension(sites.dimension,
    [&](auto dimension)
    {
      using Search = OwnerSearch<decltype(dimension)::value>;
      ScratchPool<Search> pool(
        [&]() { return std::make_unique<Search>(sites, lists, keepsLeads, m_instructions); });
      return forEachRange(Blocks::cut(asked, 1024, 4096), control,
        [&](Offset begin, Offset end)
        {
          const auto search = pool.borrow();
          search->begin();
          this->updateRange(
            static_cast<Index>(begin), static_cast<Index>(end), surface, sites, *search);
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
