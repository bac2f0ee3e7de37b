#include "Voronoi/BatchIntegration.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
  for (int k = 0; k < numberOfPatterns; ++k)
  {
    const auto pattern = static_cast<FacetPattern>(k);
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
  collection.first[lane] = first;
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
  // No branch: none can foresee which corner it is.
  const int single = (owners[2] == owners[0]) + 2 * (owners[0] == owners[1]);
  const Index shared = owners[(single + 1) % 3];
  const Index sites[3] = { shared, owners[single], shared };
  this->put(facet, single, sites, collection);
}

/** Where a facet is put that is shared in another way than its collection's; null: nowhere. */
template <int D>
typename BatchIntegration<D>::Collection* BatchIntegration<D>::collectAgain(
  const Collection& collection, int lane)
{
  switch (collection.pattern)
  {
    case FacetPattern::TwoCells:
      return collection.rivals[lane] == 2 ? this->collectThird(collection, lane) : nullptr;
    case FacetPattern::Meeting:
      return this->collectStrip(collection, lane);
    default:
      return nullptr;
  }
}

/** Of three that do not meet, one may lie between the others: the one that has a part of the edge
 *  between them. */
template <int D>
typename BatchIntegration<D>::Collection* BatchIntegration<D>::collectStrip(
  const Collection& collection, int lane)
{
  int middle = -1;
  for (int k = 0; k < 3; ++k)
  {
    if (collection.batch.leads[k][lane] < 0.0)
    {
      if (middle >= 0)
      {
        return nullptr;
      }
      middle = (k + 2) % 3;
    }
  }
  if (middle < 0)
  {
    return nullptr;
  }
  const Index sites[3] = { collection.sites[middle][lane], collection.sites[(middle + 1) % 3][lane],
    collection.sites[(middle + 2) % 3][lane] };
  Collection& strips = this->of(FacetPattern::Strip);
  this->put(collection.facets[lane], middle, sites, strips);
  return &strips;
}

/** A third site may have one end of the border between two, or all of it. */
template <int D>
typename BatchIntegration<D>::Collection* BatchIntegration<D>::collectThird(
  const Collection& collection, int lane)
{
  bool below[2];
  const Index third = this->findThird(collection, lane, below);
  if (third == noIndex)
  {
    return nullptr;
  }
  const Index facet = collection.facets[lane];
  const Index sites[3] = { collection.sites[0][lane], collection.sites[1][lane], third };
  Collection& to = this->of(below[0] && below[1] ? FacetPattern::Band : FacetPattern::Notch);
  this->put(facet, collection.first[lane], sites, to);
  if (!below[0])
  {
    // The end is on the other edge: a mirror image.
    const int last = to.count - 1;
    std::swap(to.batch.corners[1][last], to.batch.corners[2][last]);
    std::swap(to.batch.edge2[0][last], to.batch.edge2[2][last]);
  }
  return &to;
}

/** The neighbour that is below at one of the two vertices, and not the second site. */
template <int D>
Index BatchIntegration<D>::findThird(const Collection& collection, int lane, bool below[2])
{
  const FacetBatch<D>& batch = collection.batch;
  const NeighborList list = m_lists.list(collection.sites[0][lane]);
  const Index count = std::min(collection.seen[lane], list.count);
  const double* offsets = m_packs.of(collection.sites[0][lane], count);
  const int stride = m_packs.stride();
  for (Index entry = 0; entry < count; ++entry)
  {
    for (int v = 0; v < 2; ++v)
    {
      double value = offsets[m_surface.dimension * stride + entry];
      for (int m = 0; m < m_surface.dimension; ++m)
      {
        value -= batch.vertices[v][m][lane] * offsets[m * stride + entry];
      }
      below[v] = value < batch.levels[v][lane];
    }
    if ((below[0] || below[1]) && list.sites[entry] != collection.sites[1][lane])
    {
      return list.sites[entry];
    }
  }
  return noIndex;
}

/** How many may have a part beside the reference; more than all if its list is too short to tell.
 */
template <int D>
int BatchIntegration<D>::countRivals(Collection& collection, int lane)
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
    return m_lists.longest() + 1;
  }
  const NeighborList list = m_lists.list(reference);
  Index count = 0;
  while (count < list.count && list.distances[count] <= farthest)
  {
    count += lanes;
  }
  collection.seen[lane] = count;
  return collection.kernels.countRivals(
    { batch, lane, m_packs.of(reference, count), m_packs.stride(), count });
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
    const bool plain = (clear >> lane & 1U) != 0;
    collection.rivals[lane] = plain ? this->countRivals(collection, lane) : 0;
    if (collection.rivals[lane] != collection.parts - 1)
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
