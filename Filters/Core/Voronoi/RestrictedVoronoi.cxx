#include "Voronoi/RestrictedVoronoi.h"

#include "Embedding/Distance.h"
#include "Support/Parallel.h"
#include "Voronoi/DiagramBlocks.h"
#include "Voronoi/FacetDecomposition.h"
#include "Voronoi/FacetIntegration.h"

#include <algorithm>
#include <optional>

namespace remesh
{
namespace
{
/**
 * Blocks of facets that are added up at once. A diagram is strung together so that hardly any of it
 * is held twice; with many sites, neither are their sums. As each window looks at all sites, there
 * are a few only.
 */
Offset windowFor(const Blocks& blocks, const Sites& sites, bool forDiagram)
{
  constexpr Offset mostWindows = 8;
  constexpr Offset windowsOfMany = 4;
  constexpr std::size_t manyCoordinates = 1U << 21U;
  const Offset windows = forDiagram              ? mostWindows
    : sites.coordinates.size() > manyCoordinates ? windowsOfMany
                                                 : 1;
  return (blocks.count() + windows - 1) / windows;
}

/** Each block has d sums for each site it meets: in many dimensions, fewer blocks hold less. */
Blocks cutFacets(const EmbeddedSurface& surface)
{
  constexpr Offset most = 512;
  const Offset wanted = std::clamp<Offset>(most * manyDimensions / surface.dimension, 64, most);
  return Blocks::cut(surface.numberOfFacets(), wanted, most / wanted * 4096);
}

/** One thread's tools for a block. */
template <int D>
struct BlockScratch
{
  FacetIntegration<D> integration;
  FacetDecomposition<D> decomposition;
  BlockAccumulator<D> accumulator;
};

/**
 * Cuts the facets [begin, end) and hands each piece to the sums and, if wanted, the pieces.
 *
 * @param kept pieces that need not be cut, if pieces are wanted.
 */
template <int D>
void cutBlock(Offset begin, Offset end, const EmbeddedSurface& surface,
  const std::vector<Index>& owners, const std::vector<double>& squared, const KeptPieces* kept,
  BlockScratch<D>& scratch, DiagramBlock* pieces)
{
  const bool manyNumbers = D == Eigen::Dynamic && surface.dimension >= manyDimensions;
  FacetDecomposition<D>& decomposition = scratch.decomposition;
  decomposition.beginBlock();
  for (Offset f = begin; f < end; ++f)
  {
    const auto facet = static_cast<Index>(f);
    if (kept && kept->keeps(facet))
    {
      kept->forEachPiece(facet,
        [&](Offset piece)
        {
          pieces->add(kept->diagram(), piece, kept->later());
          scratch.accumulator.add(facet, pieces->sites.back(), pieces->integrals.back());
        });
      continue;
    }
    const FacetConstants& constants = surface.constants[facet];
    const Triple& corners = surface.facetCorners[facet];
    const Index owner = owners[corners[0]];
    const bool whole = owner == owners[corners[1]] && owner == owners[corners[2]];
    if (whole && !pieces)
    {
      if (manyNumbers)
      {
        const double h[3] = { squared[corners[0]], squared[corners[1]], squared[corners[2]] };
        scratch.accumulator.add(facet, owner, integrateWholeFacet(constants, h));
      }
      else
      {
        scratch.accumulator.addWholeFacet(facet, owner);
      }
      continue;
    }
    if (!pieces && scratch.integration.integrate(facet))
    {
      scratch.integration.forEachPart(constants,
        [&](Index site, const PieceIntegral& part) { scratch.accumulator.add(facet, site, part); });
      continue;
    }
    decomposition.gather(facet);
    decomposition.tile();
    if (pieces)
    {
      decomposition.fixFirstVertices();
    }
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
  PhaseTimer timer(m_times.neighbors);
  if (Status status = m_lists.update(sites, control.step(0, 4)); !status.ok())
  {
    return status;
  }
  timer.next(m_times.ownership);
  return m_ownership.update(m_surface, sites, m_lists, control.step(1, 4));
}

Status RestrictedVoronoi::locateOnce(
  const Sites& sites, const KeptPieces* kept, const RunControl& control)
{
  PhaseTimer timer(m_times.neighbors);
  const std::vector<Index> around = kept ? kept->sitesAround(sites) : std::vector<Index>();
  if (Status status = m_lists.buildInPlace(sites, control.step(0, 4), kept ? &around : nullptr);
      !status.ok())
  {
    return status;
  }
  timer.next(m_times.ownership);
  if (kept)
  {
    m_ownership.know(kept->owners(), sites);
  }
  return m_ownership.update(m_surface, sites, m_lists, control.step(1, 4));
}

template <int D>
Status RestrictedVoronoi::cut(const Sites& sites, const KeptPieces* kept, const RunControl& control,
  CellSums& sums, Diagram* diagram)
{
  PhaseTimer timer(m_times.clipping);
  const Blocks blocks = cutFacets(m_surface);
  const Offset window =
    std::clamp<Offset>(m_window > 0 ? m_window : windowFor(blocks, sites, diagram != nullptr), 1,
      std::max<Offset>(blocks.count(), 1));
  m_blockSums.resize(static_cast<std::size_t>(window));
  std::vector<DiagramBlock> pieces(diagram ? static_cast<std::size_t>(window) : std::size_t{ 0 });
  beginSums(sites.count(), m_surface.dimension, sums);
  ScratchPool<BlockScratch<D>> pool(
    [&]()
    {
      return std::unique_ptr<BlockScratch<D>>(new BlockScratch<D>{
        FacetIntegration<D>(m_surface, sites, m_lists, this->owners(), m_centers, m_instructions),
        FacetDecomposition<D>(m_surface, sites, m_lists, this->owners(), m_decisions),
        BlockAccumulator<D>(m_surface, sites) });
    });
  const auto cutWindow = [&](Offset first, Offset last, const RunControl& part)
  {
    return forEachBlock(last - first, part,
      [&](Offset k)
      {
        const Offset block = first + k;
        const auto scratch = pool.borrow();
        scratch->accumulator.begin(m_blockSums[k]);
        cutBlock<D>(blocks.begin(block), blocks.end(block), m_surface, this->owners(),
          m_ownership.squared(), kept, *scratch, diagram ? &pieces[k] : nullptr);
        scratch->accumulator.finish();
      });
  };
  const auto windows = static_cast<int>((blocks.count() + window - 1) / window);
  for (int k = 0; k < windows; ++k)
  {
    const RunControl part = control.step(1, 2).step(k, windows);
    const Offset last = std::min(blocks.count(), (k + 1) * window);
    m_blockSums.resize(static_cast<std::size_t>(last - k * window));
    if (!cutWindow(k * window, last, part.step(0, 2)))
    {
      return Status::cancelled();
    }
    const double share = static_cast<double>(last) / static_cast<double>(blocks.count());
    if (Status status = diagram ? appendBlocks(pieces, share, *diagram) : Status::success();
        !status.ok())
    {
      return status;
    }
    timer.next(m_times.reduction);
    if (Status status = addBlocks(m_blockSums, m_surface.dimension, part.step(1, 2), sums);
        !status.ok())
    {
      return status;
    }
    timer.next(m_times.clipping);
  }
  timer.next(m_times.reduction);
  if (Status status = finishSums(m_surface.dimension, control.silent(), sums); !status.ok())
  {
    return status;
  }
  if (diagram)
  {
    pieces = std::vector<DiagramBlock>(); // which frees it; {} would keep the memory
    finishDiagram(m_surface.numberOfFacets(), *diagram);
  }
  return Status::success();
}

Status RestrictedVoronoi::integrate(const Sites& sites, const RunControl& control, CellSums& sums)
{
  ++m_evaluations;
  if (Status status = this->locate(sites, control); !status.ok())
  {
    return status;
  }
  if (m_numberOfSites != sites.count())
  {
    m_centers.assign(static_cast<std::size_t>(m_surface.numberOfFacets()), noIndex);
    m_numberOfSites = sites.count();
  }
  return dispatchDimension(m_surface.dimension,
    [&](auto dimension)
    { return this->cut<decltype(dimension)::value>(sites, nullptr, control, sums, nullptr); });
}

Status RestrictedVoronoi::decompose(const Sites& sites, const RunControl& control, CellSums& sums,
  Diagram& diagram, const EarlierDiagram* earlier)
{
  ++m_evaluations;
  sums = CellSums{};
  beginDiagram(diagram);
  std::optional<KeptPieces> pieces;
  if (earlier)
  {
    PhaseTimer timer(m_times.neighbors);
    pieces.emplace(m_surface, *earlier);
    if (Status status = pieces->find(sites, control.silent()); !status.ok())
    {
      return status;
    }
  }
  const KeptPieces* kept = pieces ? &*pieces : nullptr;
  if (Status status = this->locateOnce(sites, kept, control); !status.ok())
  {
    return status;
  }
  return dispatchDimension(m_surface.dimension,
    [&](auto dimension)
    { return this->cut<decltype(dimension)::value>(sites, kept, control, sums, &diagram); });
}
}
