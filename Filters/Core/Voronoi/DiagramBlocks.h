/**
 * @file DiagramBlocks.h
 * @brief The pieces of blocks of facets, and how they are strung together to a diagram.
 */
#ifndef remesh_DiagramBlocks_h
#define remesh_DiagramBlocks_h

#include "Support/Status.h"
#include "Voronoi/Diagram.h"

namespace remesh
{
/** Pieces of one block of facets, in the order of the facets. */
struct DiagramBlock
{
  std::vector<Index> sites;
  std::vector<Index> facets;
  std::vector<PieceWeights> weights;
  std::vector<double> energies;
  std::vector<Index> sizes; ///< vertices of each piece
  std::vector<Index> across;

  void add(Index facet, Index site, const PieceIntegral& integral, const Polygon& polygon,
    const FacetTiling& tiling);

  /** Forgets the pieces and keeps the memory for others. */
  void clear();
};

/** Whether the pieces of a diagram may have so many vertices; else InvalidInput. */
Status checkNumberOfVertices(std::size_t vertices);

/** Makes an empty diagram that blocks can be appended to. */
void beginDiagram(Diagram& diagram);

/**
 * Appends the blocks of the next facets and clears them.
 *
 * @param share of the surface's facets that is done with these blocks: memory for the rest is
 *        reserved in proportion, so that as little as possible is moved later.
 * @return InvalidInput if the pieces have more vertices than an Index counts.
 */
Status appendBlocks(std::vector<DiagramBlock>& blocks, double share, Diagram& diagram);

/** Makes the index of the facets, when all blocks are there. */
void finishDiagram(Index numberOfFacets, Diagram& diagram);
}

#endif
