#include "Voronoi/RestrictedVoronoi.h"

#include "Embedding/Distance.h"
#include "Support/Parallel.h"
#include "Voronoi/BlockCutter.h"
#include "Voronoi/DiagramUpdate.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

namespace remesh
{
namespace
{
/**
 * Blocks of facets that are added up at once. A diagram is strung together so that hardly any of it
 * is held twice; with many sites, neither are their sums. As each window looks at all sites, there
 * are a few only.
 */
Offset windowFor(Offset blocks, const Sites& sites, bool forDiagram)
{
  constexpr Offset maxWindows = 8;
  constexpr Offset windowsOfMany = 4;
  constexpr std::size_t manyCoordinates = 1U << 21U;
  const Offset windows = forDiagram              ? maxWindows
    : sites.coordinates.size() > manyCoordinates ? windowsOfMany
                                                 : 1;
  return (blocks + windows - 1) / windows;
}

/** Adds to `sums` those of the blocks from `first` on. False: cancelled. */
template <int D>
bool integrateEach(ScratchPool<BlockCutter<D>>& pool, const Blocks& blocks, Offset first,
  const RunControl& control, std::vector<BlockSums>& sums)
{
  return forEachBlock(static_cast<Offset>(sums.size()), control,
    [&](Offset k)
    {
      const Offset block = first + k;
      pool.borrow()->integrate(blocks.begin(block), blocks.end(block), sums[k]);
    });
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
  m_ownership.lookAfter(m_shared ? m_shared->ownCorners() : m_surface.numberOfCorners(),
    m_shared ? m_shared->ownShare() : m_share);
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
  m_ownership.lookAfter(m_surface.numberOfCorners(), 1.0);
  return m_ownership.update(m_surface, sites, m_lists, control.step(1, 4));
}

template <int D>
Status RestrictedVoronoi::cut(const Sites& sites, const KeptPieces* kept, const RunControl& control,
  CellSums& sums, Diagram* diagram)
{
  PhaseTimer timer(m_times.clipping);
  const Blocks blocks = facetBlocks(m_surface);
  const Offset count = m_shared && !diagram ? m_shared->ownBlocks() : blocks.count();
  const Offset window =
    std::clamp<Offset>(m_window > 0 ? m_window : windowFor(count, sites, diagram != nullptr), 1,
      std::max<Offset>(count, 1));
  m_blockSums.resize(static_cast<std::size_t>(window));
  std::vector<DiagramBlock> pieces(diagram ? static_cast<std::size_t>(window) : std::size_t{ 0 });
  beginSums(sites.count(), m_surface.dimension, sums);
  const CutTask task{ m_surface, sites, m_lists, m_ownership, m_centers, m_instructions,
    m_decisions };
  ScratchPool<BlockCutter<D>> pool([&]() { return std::make_unique<BlockCutter<D>>(task); });
  const auto cutWindow = [&](Offset first, const RunControl& part)
  {
    return !diagram ? integrateEach(pool, blocks, first, part, m_blockSums)
                    : forEachBlock(static_cast<Offset>(m_blockSums.size()), part,
                        [&](Offset k)
                        {
                          const Offset block = first + k;
                          pool.borrow()->decompose(blocks.begin(block), blocks.end(block), kept,
                            m_blockSums[k], pieces[k]);
                        });
  };
  const auto windows = static_cast<int>((count + window - 1) / window);
  for (int k = 0; k < windows; ++k)
  {
    const RunControl part = control.step(1, 2).step(k, windows);
    const Offset last = std::min(count, (k + 1) * window);
    m_blockSums.resize(static_cast<std::size_t>(last - k * window));
    if (!cutWindow(k * window, part.step(0, 2)))
    {
      return Status::cancelled();
    }
    const double share = static_cast<double>(last) / static_cast<double>(count);
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
  if (diagram)
  {
    pieces = std::vector<DiagramBlock>(); // which frees it; {} would keep the memory
    finishDiagram(m_surface.numberOfFacets(), *diagram);
  }
  return Status::success();
}

Status RestrictedVoronoi::finish(const RunControl& control, CellSums& sums)
{
  const PhaseTimer timer(m_times.reduction);
  return finishSums(m_surface.dimension, control.silent(), sums);
}

Status RestrictedVoronoi::beginOthers(const Sites& sites)
{
  try
  {
    if (m_ranks && !m_shared)
    {
      m_shared = std::make_unique<SharedIntegration>(*m_ranks, m_surface, sites.count());
    }
    if (m_shared)
    {
      m_shared->begin(sites);
    }
    return Status::success();
  }
  catch (const std::runtime_error& error)
  {
    return Status::invalid(error.what());
  }
}

Status RestrictedVoronoi::endOthers(const RunControl& control, CellSums* sums)
{
  try
  {
    const PhaseTimer timer(m_times.reduction);
    return m_shared ? m_shared->end(m_surface.dimension, control, sums) : Status::success();
  }
  catch (const std::runtime_error& error)
  {
    return Status::invalid(error.what());
  }
}

Status RestrictedVoronoi::prepare(const Sites& sites, const RunControl& control)
{
  ++m_evaluations;
  if (m_numberOfSites != sites.count())
  {
    m_centers.assign(static_cast<std::size_t>(m_surface.numberOfFacets()), noIndex);
    m_numberOfSites = sites.count();
  }
  return this->locate(sites, control);
}

Status RestrictedVoronoi::integrate(const Sites& sites, const RunControl& control, CellSums& sums)
{
  if (Status status = this->beginOthers(sites); !status.ok())
  {
    return status;
  }
  Status status = this->prepare(sites, control);
  if (status.ok())
  {
    status = dispatchDimension(m_surface.dimension,
      [&](auto dimension)
      { return this->cut<decltype(dimension)::value>(sites, nullptr, control, sums, nullptr); });
  }
  // In any case: they are not to be left waiting.
  Status others = this->endOthers(control, status.ok() ? &sums : nullptr);
  if (status.ok())
  {
    status = std::move(others);
  }
  return status.ok() ? this->finish(control, sums) : status;
}

Status RestrictedVoronoi::integrateBlocks(
  const Sites& sites, Offset blockLength, const RunControl& control, std::vector<BlockSums>& blocks)
{
  if (Status status = this->prepare(sites, control); !status.ok())
  {
    return status;
  }
  const PhaseTimer timer(m_times.clipping);
  const Blocks facets{ m_surface.numberOfFacets(), blockLength };
  blocks.resize(static_cast<std::size_t>(facets.count()));
  const CutTask task{ m_surface, sites, m_lists, m_ownership, m_centers, m_instructions,
    m_decisions };
  const bool done = dispatchDimension(m_surface.dimension,
    [&](auto dimension)
    {
      using Cutter = BlockCutter<decltype(dimension)::value>;
      ScratchPool<Cutter> pool([&]() { return std::make_unique<Cutter>(task); });
      return integrateEach(pool, facets, 0, control, blocks);
    });
  return done ? Status::success() : Status::cancelled();
}

Status RestrictedVoronoi::decompose(const Sites& sites, const RunControl& control, CellSums& sums,
  Diagram& diagram, const EarlierSites* earlier)
{
  ++m_evaluations;
  sums = CellSums{};
  Diagram changes; // the pieces of the facets that are not kept
  Diagram& made = earlier ? changes : diagram;
  beginDiagram(made);
  std::optional<KeptPieces> pieces;
  if (earlier)
  {
    PhaseTimer timer(m_times.neighbors);
    pieces.emplace(m_surface, *earlier, diagram);
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
  Status status = dispatchDimension(m_surface.dimension,
    [&](auto dimension)
    { return this->cut<decltype(dimension)::value>(sites, kept, control, sums, &made); });
  status = status.ok() ? this->finish(control, sums) : status;
  return status.ok() && kept ? updateDiagram(*kept, changes, control.silent(), diagram) : status;
}
}
