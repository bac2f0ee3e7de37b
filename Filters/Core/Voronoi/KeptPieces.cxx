#include "Voronoi/KeptPieces.h"

#include "Embedding/CornerReader.h"
#include "Embedding/Distance.h"
#include "Support/Parallel.h"
#include "Voronoi/SiteChanges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace remesh
{
namespace
{

/** Sites whose ids would come in another order count as gone and added: ties go by the order. */
void keepOrder(SiteChanges& changes)
{
  Index last = noIndex;
  const std::size_t before = changes.added.size();
  for (Index& later : changes.later)
  {
    if (later == noIndex)
    {
      continue;
    }
    if (later < last)
    {
      changes.added.push_back(later);
      later = noIndex;
      continue;
    }
    last = later;
  }
  if (changes.added.size() > before)
  {
    std::sort(changes.added.begin(), changes.added.end());
  }
}

Sites chosen(const Sites& sites, const std::vector<Index>& ids)
{
  Sites some;
  some.dimension = sites.dimension;
  for (const Index id : ids)
  {
    some.coordinates.insert(
      some.coordinates.end(), sites.site(id), sites.site(id) + sites.dimension);
  }
  return some;
}
}

template <int D>
void KeptPieces::findRange(
  Index begin, Index end, const NeighborSearch* added, const Sites& addedSites)
{
  const int d = m_surface.dimension;
  CornerReader<D> corners(m_surface);
  std::vector<double> center(static_cast<std::size_t>(d));
  for (Index facet = begin; facet < end; ++facet)
  {
    const auto first = m_diagram.sites.begin() + m_diagram.facetBegin[facet];
    const auto last = m_diagram.sites.begin() + m_diagram.facetBegin[facet + 1];
    if (std::any_of(first, last, [&](Index site) { return m_later[site] == noIndex; }))
    {
      continue;
    }
    bool isNear = false;
    if (added)
    {
      findCenter(corners.facet(facet), center);
      double nearest = std::numeric_limits<double>::infinity();
      for (auto site = first; site != last; ++site)
      {
        nearest =
          std::min(nearest, squaredDistance<D>(m_earlier.sites.site(*site), center.data(), d));
      }
      // No point of the facet is farther than one radius from the centre.
      const double bound =
        (std::sqrt(nearest) + 2.0 * m_surface.constants[facet].radius()) * aboveRounding;
      const Index other = added->nearest(center.data());
      isNear = !(squaredDistance<D>(addedSites.site(other), center.data(), d) > bound * bound);
    }
    m_keeps[facet] = !isNear;
  }
}

Status KeptPieces::find(const Sites& sites, const RunControl& control)
{
  SiteChanges changes = compareSites(m_earlier.sites, sites);
  keepOrder(changes);
  m_later = std::move(changes.later);
  m_added = std::move(changes.added);
  const Index facets = m_surface.numberOfFacets();
  m_keeps.assign(static_cast<std::size_t>(facets), 0);
  if (m_surface.dimension >= manyDimensions)
  {
    return Status::success();
  }
  const Sites added = chosen(sites, m_added);
  std::optional<NeighborSearch> search;
  if (!m_added.empty())
  {
    search.emplace(added);
  }
  const bool done = forEachRange(Blocks::cut(facets, 1024, 4096), control,
    [&](Offset begin, Offset end)
    {
      dispatchDimension(sites.dimension,
        [&](auto dimension)
        {
          this->findRange<decltype(dimension)::value>(
            static_cast<Index>(begin), static_cast<Index>(end), search ? &*search : nullptr, added);
        });
    });
  return done ? Status::success() : Status::cancelled();
}

std::vector<Index> KeptPieces::owners() const
{
  std::vector<Index> owners(m_earlier.owners.size(), noIndex);
  for (Index facet = 0; facet < m_surface.numberOfFacets(); ++facet)
  {
    if (this->keeps(facet))
    {
      for (const Index corner : m_surface.facetCorners[facet])
      {
        owners[corner] = m_later[m_earlier.owners[corner]];
      }
    }
  }
  return owners;
}

std::vector<Index> KeptPieces::sitesAround(const Sites& sites) const
{
  std::vector<char> isAround(static_cast<std::size_t>(sites.count()), 0);
  for (const Index site : m_added)
  {
    isAround[site] = 1;
  }
  for (Offset piece = 0; piece < m_diagram.numberOfPieces(); ++piece)
  {
    const Index site = m_later[m_diagram.sites[piece]];
    if (site != noIndex && !this->keeps(m_diagram.facets[piece]))
    {
      isAround[site] = 1;
    }
  }
  std::vector<Index> around;
  for (Index site = 0; site < sites.count(); ++site)
  {
    if (isAround[site])
    {
      around.push_back(site);
    }
  }
  return around;
}
}
