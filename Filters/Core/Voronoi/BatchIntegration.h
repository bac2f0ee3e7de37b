/**
 * @file BatchIntegration.h
 * @brief Integrates a block's facets that two or three sites share, a batch after the other.
 *
 * Which facets these are is a guess by the owners of their corners: two or three different ones.
 * Those that turn out to be shared in another way are collected again for that pattern
 * (FacetBatch.h). A facet is refused, and goes to FacetIntegration, where yet another site may have
 * a part, where the reference's list is too short to tell, or where the sites do not part in a
 * plain way.
 */
#ifndef remesh_BatchIntegration_h
#define remesh_BatchIntegration_h

#include "Embedding/EmbeddedSurface.h"
#include "Voronoi/BisectorPacks.h"
#include "Voronoi/FacetBatch.h"
#include "Voronoi/NeighborLists.h"

#include <vector>

namespace remesh
{
/** One thread's working memory. D: see dispatchDimension. */
template <int D>
class BatchIntegration
{
public:
  /** @param packs of the same sites and lists. */
  BatchIntegration(const EmbeddedSurface& surface, const Sites& sites, const NeighborLists& lists,
    const std::vector<Index>& owners, BisectorPacks& packs, InstructionSet instructions);

  /** Whether the surface has few enough coordinates for batches. */
  bool serves() const { return m_surface.dimension <= maxBatchDimensions; }

  /**
   * Facets with so many different owners, two or three: calls `add(site, sums, lane)` for each
   * part, with sums as in FacetBatch, and appends those that are refused.
   */
  template <class Add>
  void integrate(const std::vector<Index>& facets, int numberOfOwners, const Add& add,
    std::vector<Index>& refused)
  {
    Collection& collection =
      this->of(numberOfOwners == 2 ? FacetPattern::TwoCells : FacetPattern::Meeting);
    for (const Index facet : facets)
    {
      this->collect(facet, collection);
      this->emptyIfFull(collection, add, refused);
    }
    this->empty(collection, add, refused);
    for (Collection& later : m_collections)
    {
      this->empty(later, add, refused); // facets that were found to be shared in another way
    }
  }

private:
  /** Facets that wait for their batch to be full. */
  struct Collection
  {
    FacetPattern pattern;
    int parts;
    FacetKernels<D> kernels;
    int count = 0;
    Index facets[lanes];
    int first[lanes]; ///< corner
    Index sites[3][lanes];
    int rivals[lanes]; ///< of the reference, if the sites part in the plain way
    Index seen[lanes]; ///< neighbours that were asked
    FacetBatch<D> batch;
  };

  Collection& of(FacetPattern pattern) { return m_collections[static_cast<int>(pattern)]; }
  void collect(Index facet, Collection& collection) const;
  void put(Index facet, int first, const Index sites[3], Collection& collection) const;
  Collection* collectAgain(const Collection& collection, int lane);
  Collection* collectStrip(const Collection& collection, int lane);
  Collection* collectThird(const Collection& collection, int lane);
  Index findThird(const Collection& collection, int lane, bool below[2]);
  unsigned work(Collection& collection);
  int countRivals(Collection& collection, int lane);

  template <class Add>
  void emptyIfFull(Collection& collection, const Add& add, std::vector<Index>& refused)
  {
    if (collection.count == lanes)
    {
      this->empty(collection, add, refused);
    }
  }

  template <class Add>
  void empty(Collection& collection, const Add& add, std::vector<Index>& refused)
  {
    const unsigned clear = this->work(collection);
    for (int lane = 0; lane < collection.count; ++lane)
    {
      if ((clear >> lane & 1U) != 0)
      {
        for (int part = 0; part < collection.parts; ++part)
        {
          add(collection.sites[part][lane], collection.batch.sums[part], lane);
        }
      }
      else if (Collection* other = this->collectAgain(collection, lane))
      {
        this->emptyIfFull(*other, add, refused);
      }
      else
      {
        refused.push_back(collection.facets[lane]);
      }
    }
    collection.count = 0;
  }

  const EmbeddedSurface& m_surface;
  const Sites& m_sites;
  const NeighborLists& m_lists;
  const std::vector<Index>& m_owners;
  BisectorPacks& m_packs;
  Collection m_collections[numberOfPatterns]; ///< by pattern
};

extern template class BatchIntegration<3>;
extern template class BatchIntegration<6>;
extern template class BatchIntegration<Eigen::Dynamic>;
}

#endif
