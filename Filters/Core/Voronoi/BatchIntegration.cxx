#include "Voronoi/BatchIntegration.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
template <int D>
BatchIntegration<D>::BatchIntegration(const EmbeddedSurface& surface, const Sites& sites,
  const NeighborLists& lists, const std::vector<Index>& owners, BisectorPacks& packs,
  InstructionSet instructions)
  : m_surface(surface)
  , m_sites(sites)
  , m_lists(lists)
  , m_owners(owners)
  , m_packs(packs)
{
  for (const FacetPattern pattern :
    { FacetPattern::TwoCells, FacetPattern::Meeting, FacetPattern::Strip })
  {
    Collection& collection = this->of(pattern);
    collection.pattern = pattern;
    collection.parts = pattern == FacetPattern::TwoCells ? 2 : 3;
    collection.kernels = FacetKernels<D>::of(pattern, instructions);
    collection.batch.dimension = surface.dimension;
  }
}

/** Puts the facet into a lane, with this corner as the first, and these sites. */
template <int D>
void BatchIntegration<D>::put(
  Index facet, int first, const Index sites[3], Collection& collection) const
{
  FacetBatch<D>& batch = collection.batch;
  const int lane = collection.count++;
  const Triple& corners = m_surface.facetCorners[facet];
  const FacetConstants& constants = m_surface.constants[facet];
  collection.facets[lane] = facet;
  batch.mass[lane] = constants.mass;
  for (int k = 0; k < 3; ++k)
  {
    const int corner = (first + k) % 3;
    batch.corners[k][lane] = m_surface.corner(corners[corner]);
    batch.edge2[k][lane] = constants.edge2[corner];
    collection.sites[k][lane] = sites[k];
    batch.sites[k][lane] = m_sites.site(sites[k]);
  }
}

template <int D>
void BatchIntegration<D>::collect(Index facet, Collection& collection) const
{
  const Triple& corners = m_surface.facetCorners[facet];
  const Index owners[3] = { m_owners[corners[0]], m_owners[corners[1]], m_owners[corners[2]] };
  if (collection.pattern == FacetPattern::Meeting)
  {
    this->put(facet, 0, owners, collection);
    return;
  }
  const int single = owners[1] == owners[2] ? 0 : owners[2] == owners[0] ? 1 : 2;
  const Index shared = owners[(single + 1) % 3];
  const Index sites[3] = { shared, owners[single], shared };
  this->put(facet, single, sites, collection);
}

/** Of three that do not meet, one may lie between the others: the one that has a part of the edge
 *  between them. */
template <int D>
bool BatchIntegration<D>::collectStrip(const Collection& collection, int lane)
{
  if (collection.pattern != FacetPattern::Meeting)
  {
    return false;
  }
  int middle = -1;
  for (int k = 0; k < 3; ++k)
  {
    if (collection.batch.leads[k][lane] < 0.0)
    {
      if (middle >= 0)
      {
        return false;
      }
      middle = (k + 2) % 3;
    }
  }
  if (middle < 0)
  {
    return false;
  }
  const Index sites[3] = { collection.sites[middle][lane], collection.sites[(middle + 1) % 3][lane],
    collection.sites[(middle + 2) % 3][lane] };
  this->put(collection.facets[lane], middle, sites, this->of(FacetPattern::Strip));
  return true;
}

/** Whether none but the owners has a part: seen from the reference, those alone are so near. */
template <int D>
bool BatchIntegration<D>::isClear(const Collection& collection, int lane)
{
  const FacetBatch<D>& batch = collection.batch;
  double squared = std::max(batch.squared[0][lane], batch.squared[1][lane]);
  if (collection.parts == 3)
  {
    squared = std::max({ squared, batch.squared[2][lane], batch.squared[3][lane] });
  }
  const Index reference = collection.sites[0][lane];
  double farthest = 0.0;
  if (!m_lists.holds(reference, 2.0 * std::sqrt(squared) * aboveRounding, farthest))
  {
    return false;
  }
  const NeighborList list = m_lists.list(reference);
  Index count = 0;
  while (count < list.count && list.distances[count] <= farthest)
  {
    count += lanes;
  }
  return collection.kernels.countRivals({ batch, lane, m_packs.of(reference, count),
           m_packs.stride(), count }) == collection.parts - 1;
}

/** Returns a bit for each facet that is done. */
template <int D>
unsigned BatchIntegration<D>::work(Collection& collection)
{
  if (collection.count == 0)
  {
    return 0;
  }
  FacetBatch<D>& batch = collection.batch;
  for (int lane = collection.count; lane < lanes; ++lane)
  {
    batch.mass[lane] = batch.mass[0];
    for (int k = 0; k < 3; ++k)
    {
      batch.corners[k][lane] = batch.corners[k][0];
      batch.edge2[k][lane] = batch.edge2[k][0];
      batch.sites[k][lane] = batch.sites[k][0];
    }
  }
  unsigned clear = collection.kernels.share(batch);
  for (int lane = 0; lane < collection.count; ++lane)
  {
    if ((clear >> lane & 1U) != 0 && !this->isClear(collection, lane))
    {
      clear &= ~(1U << lane);
    }
  }
  return clear;
}

template class BatchIntegration<3>;
template class BatchIntegration<6>;
template class BatchIntegration<Eigen::Dynamic>;
}
