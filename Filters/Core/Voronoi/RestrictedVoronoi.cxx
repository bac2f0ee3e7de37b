#include "Voronoi/RestrictedVoronoi.h"

#include "Embedding/Distance.h"
#include "Support/Parallel.h"
#include "Voronoi/BlockCutter.h"
#include "Voronoi/DiagramUpdate.h"

#include <algorithm>
#include <memory>
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
  const CutTask task{ m_surface, sites, m_lists, m_ownership, m_centers, m_instructions,
    m_decisions };
  ScratchPool<BlockCutter<D>> pool([&]() { return std::make_unique<BlockCutter<D>>(task); });
  const auto cutWindow = [&](Offset first, Offset last, const RunControl& part)
  {
    return forEachBlock(last - first, part,
      [&](Offset k)
      {
        const Offset block = first + k;
        const auto cutter = pool.borrow();
        if (diagram)
        {
          cutter->decompose(
            blocks.begin(block), blocks.end(block), kept, m_blockSums[k], pieces[k]);
        }
        else
        {
          cutter->integrate(blocks.begin(block), blocks.end(block), m_blockSums[k]);
        }
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
  return status.ok() && kept ? updateDiagram(*kept, changes, control.silent(), diagram) : status;
}
}
