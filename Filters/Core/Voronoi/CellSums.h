/**
 * @file CellSums.h
 * @brief Integrals over the restricted cells, summed in an order that does not depend on threads.
 *
 * Accumulate: each block of facets fills its own sparse sums. Reduce: each site adds up the sums of
 * its blocks in the order of the blocks. (A distributed version would put its exchange between.)
 */
#ifndef remesh_CellSums_h
#define remesh_CellSums_h

#include "Embedding/CornerReader.h"
#include "Support/Lanes.h"
#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/PieceIntegral.h"

namespace remesh
{
/** Per site, in scaled units, weighted by density. */
struct CellSums
{
  std::vector<double> mass;   ///< n, of the cell: density times area in R^d
  std::vector<double> energy; ///< n, integral of |x - x_i|^2 over the cell
  std::vector<double> moment; ///< n x d, integral of x - x_i over the cell

  bool isEmpty(Index site) const { return !(this->mass[site] > 0.0); }

  double totalEnergy = 0.0;
  /** 2-norm of the gradient, grad_i = 2 m_i (x_i - g_i) = -2 moment_i. */
  double gradientNorm = 0.0;
};

/** Sums of one block, for the sites it meets. */
struct BlockSums
{
  std::vector<Index> sites;
  std::vector<double> values; ///< per site: mass, energy, then d of moment
};

/** Collects the sums of one block after the other; one per thread. D: see dispatchDimension. */
template <int D>
class BlockAccumulator
{
public:
  BlockAccumulator(const EmbeddedSurface& surface, const Sites& sites);

  void begin(BlockSums& sums);
  void add(Index facet, Index site, const PieceIntegral& piece);

  /** A part with these sums, mass, energy and moment: a column of a batch (FacetBatch.h). */
  void addColumn(Index site, const double (*sums)[lanes], int lane)
  {
    double* values = this->valuesOf(site);
    for (int k = 0; k < this->stride(); ++k)
    {
      values[k] += sums[k][lane];
    }
  }

  /** Facets that are wholly in one cell: centroid and second moment say all. */
  void addWholeFacets(const Index* begin, const Index* end, Index site);

  /** Ends the block. */
  void finish();

private:
  /**
   * What a corner contributes to a moment. In many dimensions, adding d numbers for each piece is
   * most of the work: so the weights are summed, and each corner's row is read once in a block.
   */
  struct CornerWeight
  {
    Index corner;
    Index slot;
    double weight;
  };

  /** Where a site's sums are in a block; side by side, as both are read for each part. */
  struct Slot
  {
    Index block = 0;
    Index place = 0;
  };

  int dimension() const { return D == Eigen::Dynamic ? m_surface.dimension : D; }
  /** Numbers for a site: mass, energy, moment. */
  int stride() const { return 2 + this->dimension(); }
  double* valuesOf(Index site)
  {
    const Slot& slot = m_slots[site];
    return slot.block == m_block
      ? m_sums->values.data() + static_cast<std::ptrdiff_t>(slot.place) * this->stride()
      : this->addSite(site);
  }
  double* addSite(Index site);

  const EmbeddedSurface& m_surface;
  const Sites& m_sites;
  CornerReader<D> m_corners;
  BlockSums* m_sums = nullptr;
  std::vector<Slot> m_slots; ///< n, of the sites
  Index m_block = 0;         ///< counts the calls of begin()
  bool m_gathers;            ///< whether moments wait for finish()
  std::vector<CornerWeight> m_weights;
};

extern template class BlockAccumulator<3>;
extern template class BlockAccumulator<6>;
extern template class BlockAccumulator<Eigen::Dynamic>;

/** Sums that blocks can be added to. */
void beginSums(Index numberOfSites, int dimension, CellSums& sums);

/** Adds the blocks of the next facets, parallel over sites. O(entries d). */
Status addBlocks(
  const std::vector<BlockSums>& blocks, int dimension, const RunControl& control, CellSums& sums);

/** The sums over all sites, when all blocks are there. Cancelled: then they are of no use. */
Status finishSums(int dimension, const RunControl& control, CellSums& sums);
}

#endif
