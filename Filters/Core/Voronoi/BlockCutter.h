/**
 * @file BlockCutter.h
 * @brief A block of facets is cut by the cells, and its integrals are added up.
 */
#ifndef remesh_BlockCutter_h
#define remesh_BlockCutter_h

#include "Voronoi/BatchIntegration.h"
#include "Voronoi/CellSums.h"
#include "Voronoi/DiagramBlocks.h"
#include "Voronoi/FacetDecomposition.h"
#include "Voronoi/FacetIntegration.h"
#include "Voronoi/KeptPieces.h"
#include "Voronoi/Ownership.h"

namespace remesh
{
/** What all blocks of an evaluation share; it must outlive their cutters. */
struct CutTask
{
  const EmbeddedSurface& surface;
  const Sites& sites;
  const NeighborLists& lists;
  const Ownership& ownership;
  std::vector<Index>& centers; ///< see FacetIntegration
  InstructionSet instructions;
  Decisions decisions;
};

/** One thread's working memory. D: see dispatchDimension. */
template <int D>
class BlockCutter
{
public:
  explicit BlockCutter(const CutTask& task);

  /** The sums over the facets [begin, end). */
  void integrate(Offset begin, Offset end, BlockSums& sums);

  /** The same, and the pieces but of the facets that keep theirs, if there are any. */
  void decompose(
    Offset begin, Offset end, const KeptPieces* kept, BlockSums& sums, DiagramBlock& pieces);

private:
  /** The site that owns the first corner of a facet. */
  Index ownerOf(Index facet) const
  {
    return m_task.ownership.owners()[m_task.surface.facetCorners[facet][0]];
  }
  /** The site that owns all corners of a facet, or noIndex. */
  Index ownerOfAll(Index facet) const
  {
    const Triple& corners = m_task.surface.facetCorners[facet];
    const std::vector<Index>& owners = m_task.ownership.owners();
    const Index owner = owners[corners[0]];
    return owner == owners[corners[1]] && owner == owners[corners[2]] ? owner : noIndex;
  }
  void sortFacets(Index begin, Index end);
  void addWholeFacets();
  void addWholeFacets(const Index* begin, const Index* end, Index owner);
  void addSharedFacet(Index facet);
  PieceIntegral integralOf(Index facet, const FacetPiece& piece, bool whole) const;

  const CutTask& m_task;
  FacetIntegration<D> m_integration;
  BatchIntegration<D> m_batches;
  FacetDecomposition<D> m_decomposition;
  BlockAccumulator<D> m_accumulator;
  std::vector<Index> m_facets[4]; ///< of a block, see sortFacets
};

extern template class BlockCutter<3>;
extern template class BlockCutter<6>;
extern template class BlockCutter<Eigen::Dynamic>;
}

#endif
