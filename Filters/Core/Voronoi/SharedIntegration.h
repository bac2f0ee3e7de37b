/**
 * @file SharedIntegration.h
 * @brief The integrals over the cells, with the facets divided among ranks: the first one's side.
 *
 * Each rank has the blocks of a range of facets and keeps them; the first has the whole surface as
 * well. For each evaluation the first sends the sites to all, and gets back the sums of their
 * blocks, which it adds up in the order of the blocks: how many ranks there are changes no bit.
 * Neighbour lists are made by each rank for itself, from the same sites, as its facets ask for
 * them.
 *
 * Sent for an evaluation: to each rank n d doubles, handed on from rank to rank (RankTree.h), so
 * that the first of p ranks sends them ceil(log2 p) times; back from each, for each block and each
 * site that the block meets, d + 2 doubles and an index.
 */
#ifndef remesh_SharedIntegration_h
#define remesh_SharedIntegration_h

#include "Embedding/EmbeddedSurface.h"
#include "Support/Parallel.h"
#include "Support/RankOrders.h"
#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/CellSums.h"

namespace remesh
{
/** How the facets are cut into blocks, by which their sums are added up. */
Blocks facetBlocks(const EmbeddedSurface& surface);

class SharedIntegration
{
public:
  /**
   * Sends the parts of the surface, which are to take equally long.
   *
   * @param ranks more than one. They must outlive it.
   * @param numberOfSites about as many as will be there.
   */
  SharedIntegration(Ranks& ranks, const EmbeddedSurface& surface, Index numberOfSites);

  /** The first so many blocks are this rank's. */
  Offset ownBlocks() const { return m_ownBlocks; }
  /** None of a higher number is used by their facets. */
  Index ownCorners() const { return m_ownCorners; }
  /** Of the surface, and so of the sites. */
  double ownShare() const { return m_ownShare; }

  /** The others begin, unless one of them could not take its part: `end` tells. */
  void begin(const Sites& sites);

  /**
   * Waits for them.
   *
   * @param sums of the own blocks, to which theirs are added; nullptr: they are not wanted any
   * more.
   */
  Status end(int dimension, const RunControl& control, CellSums* sums);

private:
  Status addNext(int dimension, const RunControl& control, CellSums* sums);

  OtherRanks m_others;
  Packet m_packet;                 ///< this and the next are kept for their memory
  std::vector<BlockSums> m_blocks; ///< of another rank
  Offset m_ownBlocks = 0;
  Index m_ownCorners = 0;
  double m_ownShare = 0.0;
  Status m_taken = Status::success(); ///< whether all have their parts
};
}

#endif
