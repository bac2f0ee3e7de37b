#include "Voronoi/RestrictedVoronoi.h"

#include "Embedding/Distance.h"
#include "Support/Parallel.h"
#include "Voronoi/FacetDecomposition.h"
#include "Voronoi/Ownership.h"

#include <algorithm>
#include <string>

namespace remesh
{
namespace
{
/** Pieces of one block of facets, in the order of the facets. */
struct BlockPieces
{
  std::vector<Index> sites;
  std::vector<Index> facets;
  std::vector<PieceIntegral> integrals;
  std::vector<Index> sizes; ///< vertices of each piece
  std::vector<DiagramVertex> vertices;

  void add(Index facet, Index site, const PieceIntegral& integral, const Polygon& polygon,
    const FacetTiling& tiling)
  {
    this->sites.push_back(site);
    this->facets.push_back(facet);
    this->integrals.push_back(integral);
    this->sizes.push_back(static_cast<Index>(polygon.size()));
    for (const PieceVertex& vertex : polygon)
    {
      const Index across = vertex.edge < 0 ? vertex.edge : tiling.site(vertex.edge).id;
      this->vertices.push_back({ { vertex.b[0], vertex.b[1], vertex.b[2] }, across });
    }
  }
};

/** Strings the blocks together; what a block held is freed on the way. */
Status joinBlocks(std::vector<BlockPieces>& blocks, Index numberOfFacets, Diagram& diagram)
{
  diagram = Diagram{};
  diagram.facetBegin.assign(static_cast<std::size_t>(numberOfFacets) + 1, 0);
  diagram.vertexBegin.push_back(0);
  std::size_t pieces = 0;
  std::size_t vertices = 0;
  for (const BlockPieces& block : blocks)
  {
    pieces += block.sites.size();
    vertices += block.vertices.size();
  }
  if (pieces > static_cast<std::size_t>(maximumIndex))
  {
    return Status::invalid("The diagram has " + std::to_string(pieces) + " pieces, more than the " +
      std::to_string(maximumIndex) + " that can be held.");
  }
  diagram.sites.reserve(pieces);
  diagram.facets.reserve(pieces);
  diagram.integrals.reserve(pieces);
  diagram.vertexBegin.reserve(pieces + 1);
  diagram.vertices.reserve(vertices);
  const auto append = [](auto& to, const auto& from)
  { to.insert(to.end(), from.begin(), from.end()); };
  for (BlockPieces& block : blocks)
  {
    append(diagram.sites, block.sites);
    append(diagram.facets, block.facets);
    append(diagram.integrals, block.integrals);
    append(diagram.vertices, block.vertices);
    for (const Index size : block.sizes)
    {
      diagram.vertexBegin.push_back(diagram.vertexBegin.back() + size);
    }
    block = BlockPieces{};
  }
  for (const Index facet : diagram.facets)
  {
    ++diagram.facetBegin[static_cast<std::size_t>(facet) + 1];
  }
  for (std::size_t f = 1; f < diagram.facetBegin.size(); ++f)
  {
    diagram.facetBegin[f] += diagram.facetBegin[f - 1];
  }
  return Status::success();
}

/** One thread's tools for a block. */
template <int D>
struct BlockScratch
{
  FacetDecomposition<D> decomposition;
  BlockAccumulator<D> accumulator;
};

/** Adds a facet that two cells share, without making polygons. */
template <int D>
void addTwoPieces(Index facet, const FacetConstants& constants, const Triple& corners,
  const std::vector<Index>& owners, BlockScratch<D>& scratch)
{
  const FacetTiling& tiling = scratch.decomposition.tiling();
  int k = 0; // the corner that one cell owns alone
  while (owners[corners[(k + 1) % 3]] != owners[corners[(k + 2) % 3]])
  {
    ++k;
  }
  const int single = tiling.site(0).id == owners[corners[k]] ? 0 : 1;
  const auto pieces = integrateTwoPieces(tiling, constants, single, k);
  scratch.accumulator.add(facet, tiling.site(single).id, pieces[0]);
  scratch.accumulator.add(facet, tiling.site(1 - single).id, pieces[1]);
}

/** Cuts the facets [begin, end) and hands each piece to the sums and, if wanted, the pieces. */
template <int D>
void cutBlock(Offset begin, Offset end, const EmbeddedSurface& surface,
  const std::vector<Index>& owners, BlockScratch<D>& scratch, BlockPieces* pieces)
{
  FacetDecomposition<D>& decomposition = scratch.decomposition;
  decomposition.beginBlock();
  for (Offset f = begin; f < end; ++f)
  {
    const auto facet = static_cast<Index>(f);
    const FacetConstants& constants = surface.constants[facet];
    const Triple& corners = surface.facetCorners[facet];
    const Index owner = owners[corners[0]];
    const bool whole = owner == owners[corners[1]] && owner == owners[corners[2]];
    if (whole && !pieces)
    {
      scratch.accumulator.addWholeFacet(facet, owner);
      continue;
    }
    decomposition.gather(facet);
    if (decomposition.twoSites() && !pieces)
    {
      addTwoPieces(facet, constants, corners, owners, scratch);
      continue;
    }
    decomposition.tile(facet);
    const FacetTiling& tiling = decomposition.tiling();
    for (const FacetPiece& piece : decomposition)
    {
      const FacetSite& site = tiling.site(piece.slot);
      const PieceIntegral integral = whole
        ? integrateWholeFacet(constants, site.h)
        : integratePiece(tiling, constants, piece.polygon, piece.slot);
      scratch.accumulator.add(facet, site.id, integral);
      if (pieces)
      {
        pieces->add(facet, site.id, integral, piece.polygon, tiling);
      }
    }
  }
}
}

Status RestrictedVoronoi::locate(const Sites& sites, const RunControl& control)
{
  if (Status status = m_lists.update(sites, control.step(0, 4)); !status.ok())
  {
    return status;
  }
  for (Index& owner : m_owners)
  {
    owner = std::min(owner, static_cast<Index>(sites.count() - 1));
  }
  return findOwners(m_surface, sites, m_lists, control.step(1, 4), m_owners);
}

template <int D>
Status RestrictedVoronoi::evaluate(
  const Sites& sites, const RunControl& control, CellSums& sums, Diagram* diagram)
{
  ++m_evaluations;
  if (Status status = this->locate(sites, control); !status.ok())
  {
    return status;
  }
  const Blocks blocks = Blocks::cut(m_surface.numberOfFacets(), 1024, 4096);
  std::vector<BlockSums> blockSums(static_cast<std::size_t>(blocks.count()));
  std::vector<BlockPieces> blockPieces(
    diagram ? static_cast<std::size_t>(blocks.count()) : std::size_t{ 0 });
  ScratchPool<BlockScratch<D>> pool(
    [&]()
    {
      return std::unique_ptr<BlockScratch<D>>(
        new BlockScratch<D>{ FacetDecomposition<D>(m_surface, sites, m_lists, m_owners),
          BlockAccumulator<D>(m_surface, sites) });
    });
  const bool done = forEachBlock(blocks.count(), control.step(2, 4),
    [&](Offset block)
    {
      const auto scratch = pool.borrow();
      scratch->accumulator.begin(blockSums[block]);
      cutBlock<D>(blocks.begin(block), blocks.end(block), m_surface, m_owners, *scratch,
        diagram ? &blockPieces[block] : nullptr);
    });
  if (!done)
  {
    return Status::cancelled();
  }
  if (diagram)
  {
    if (Status status = joinBlocks(blockPieces, m_surface.numberOfFacets(), *diagram); !status.ok())
    {
      return status;
    }
  }
  return reduceBlocks(blockSums, sites.count(), m_surface.dimension, control.step(3, 4), sums);
}

Status RestrictedVoronoi::integrate(const Sites& sites, const RunControl& control, CellSums& sums)
{
  return dispatchDimension(m_surface.dimension,
    [&](auto dimension)
    { return this->evaluate<decltype(dimension)::value>(sites, control, sums, nullptr); });
}

Status RestrictedVoronoi::decompose(
  const Sites& sites, const RunControl& control, CellSums& sums, Diagram& diagram)
{
  return dispatchDimension(m_surface.dimension,
    [&](auto dimension)
    { return this->evaluate<decltype(dimension)::value>(sites, control, sums, &diagram); });
}
}
