/**
 * @file RestrictedVoronoi.h
 * @brief The restricted Voronoi diagram of sites on a surface in R^d.
 *
 * Each evaluation:
 * 1. neighbour lists of the sites (NeighborLists.h);
 * 2. owner of each corner, the site nearest to it, by walking from its last owner;
 * 3. blocks of facets: facets with one owner are taken whole, the others are cut
 *    (FacetDecomposition.h), and each block keeps its own sums;
 * 4. the blocks are added up (CellSums.h), or their pieces are strung together (Diagram.h).
 *
 * A whole diagram may keep pieces of an earlier one and make the rest (KeptPieces.h).
 *
 * Exact (ties included, see Predicates.h) and reproducible: neither the back-end, the threads nor
 * the order of the blocks changes a bit of the result. What is kept from one evaluation to the next
 * changes nothing but the rounding of the integrals, and nothing of a diagram.
 *
 * Facets may be divided among ranks (SharedIntegration.h), as long as only integrals are wanted.
 *
 * Cost about a F + b n.
 */
#ifndef remesh_RestrictedVoronoi_h
#define remesh_RestrictedVoronoi_h

#include "Embedding/EmbeddedSurface.h"
#include "Support/InstructionSet.h"
#include "Support/PhaseTimer.h"
#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/CellSums.h"
#include "Voronoi/Diagram.h"
#include "Voronoi/KeptPieces.h"
#include "Voronoi/NeighborLists.h"
#include "Voronoi/Ownership.h"
#include "Voronoi/SharedIntegration.h"

#include <memory>

namespace remesh
{
/** Time spent so far in the parts of the evaluations. */
struct EvaluationTimes
{
  Elapsed neighbors; ///< the lists, and what an earlier diagram leaves
  Elapsed ownership;
  Elapsed clipping;  ///< and the integrals of each block
  Elapsed reduction; ///< of the blocks to the whole
};

class RestrictedVoronoi
{
public:
  /** The surface must outlive this object. */
  explicit RestrictedVoronoi(const EmbeddedSurface& surface,
    InstructionSet instructions = widestInstructionSet(), Decisions decisions = Decisions::Exact)
    : m_surface(surface)
    , m_instructions(instructions)
    , m_decisions(decisions)
    , m_lists(surface.patches.minDistance())
    , m_ownership(instructions)
  {
  }

  /**
   * Adds up the sums of so many blocks of facets at once, instead of as many as suits the sizes;
   * the sums are the same.
   */
  void addUpAtOnce(Offset blocks) { m_window = blocks; }

  /**
   * From now on, integrals are divided among ranks that wait for orders (RankOrders.h).
   *
   * @param ranks nullptr: none. They must outlive this object.
   */
  void divideAmong(Ranks* ranks)
  {
    m_ranks = ranks && ranks->count() > 1 ? ranks : nullptr;
    if (m_ranks)
    {
      m_lists.makeOnlyAsked();
    }
  }

  /** Tells that the surface is about this share of the one that the sites are spread over. */
  void beShare(double share)
  {
    m_share = share;
    m_lists.makeOnlyAsked();
  }

  /** Integrals over the cells of these sites (at least one). */
  Status integrate(const Sites& sites, const RunControl& control, CellSums& sums);

  /** The sums of each block of so many facets, which are not added up. */
  Status integrateBlocks(const Sites& sites, Offset blockLength, const RunControl& control,
    std::vector<BlockSums>& blocks);

  /**
   * The pieces of all cells and the same integrals. Nothing is kept of the lists: the way that the
   * sites came does not matter, nor does that of later ones.
   *
   * @param diagram of these sites after; unless all went well, of no use.
   * @param earlier the sites, if there are any, whose exact diagram `diagram` is before: what they
   *        share stays there. The result is the same, to the bit, and comes sooner.
   */
  Status decompose(const Sites& sites, const RunControl& control, CellSums& sums, Diagram& diagram,
    const EarlierSites* earlier = nullptr);

  /** Site that owns each corner (C), of the last evaluation. */
  const std::vector<Index>& owners() const { return m_ownership.owners(); }
  /** Of the last evaluation. O(n). */
  Index numberOfNeighborLists() const { return m_lists.numberOfLists(); }
  /** Diagrams computed so far. */
  int evaluations() const { return m_evaluations; }
  const EvaluationTimes& times() const { return m_times; }

private:
  Status beginOthers(const Sites& sites);
  Status endOthers(const RunControl& control, CellSums* sums);
  Status prepare(const Sites& sites, const RunControl& control);
  Status locate(const Sites& sites, const RunControl& control);
  /** The same with lists where the sites stand, and without what `kept` makes needless. */
  Status locateOnce(const Sites& sites, const KeptPieces* kept, const RunControl& control);
  /** The blocks of this rank. */
  template <int D>
  Status cut(const Sites& sites, const KeptPieces* kept, const RunControl& control, CellSums& sums,
    Diagram* diagram);
  Status finish(const RunControl& control, CellSums& sums);

  const EmbeddedSurface& m_surface;
  InstructionSet m_instructions;
  Decisions m_decisions;
  Offset m_window = 0; ///< 0: as suits
  double m_share = 1.0;
  Ranks* m_ranks = nullptr;
  std::unique_ptr<SharedIntegration> m_shared; ///< once the ranks have their parts
  NeighborLists m_lists;
  Ownership m_ownership;
  std::vector<Index> m_centers;       ///< see FacetIntegration
  Index m_numberOfSites = 0;          ///< for which they were found
  std::vector<BlockSums> m_blockSums; ///< kept for their memory
  int m_evaluations = 0;
  EvaluationTimes m_times;
};
}

#endif
