#include "Voronoi/SharedIntegration.h"

#include "Embedding/SurfacePart.h"
#include "Voronoi/RankWork.h"

#include <algorithm>
#include <exception>

namespace remesh
{
namespace
{
/** The first block of a rank. */
Offset firstBlock(Offset blocks, int rank, int ranks)
{
  return blocks * rank / ranks;
}
}

Blocks facetBlocks(const EmbeddedSurface& surface)
{
  // Each block has d sums for each site it meets: in many dimensions, fewer blocks hold less.
  constexpr Offset most = 512;
  const Offset wanted = std::clamp<Offset>(most * manyDimensions / surface.dimension, 64, most);
  return Blocks::cut(surface.numberOfFacets(), wanted, most / wanted * 4096);
}

SharedIntegration::SharedIntegration(Ranks& ranks, const EmbeddedSurface& surface)
  : m_ranks(ranks)
  , m_next(1)
{
  const Blocks blocks = facetBlocks(surface);
  m_blocks = blocks.count();
  const auto shareOf = [&](Offset begin, Offset end)
  { return static_cast<double>(end - begin) / static_cast<double>(blocks.size); };
  const Offset own = std::min(blocks.size, blocks.begin(this->ownBlocks()));
  m_ownShare = shareOf(0, own);
  for (Offset facet = 0; facet < own; ++facet)
  {
    for (const Index corner : surface.facetCorners[facet])
    {
      m_ownCorners = std::max(m_ownCorners, corner + 1);
    }
  }
  for (int rank = 1; rank < ranks.count(); ++rank)
  {
    const Offset begin = blocks.begin(firstBlock(m_blocks, rank, ranks.count()));
    const Offset end =
      std::min(blocks.size, blocks.begin(firstBlock(m_blocks, rank + 1, ranks.count())));
    Packet packet;
    packet.add(RankOrder::TakeSurface);
    packet.add(blocks.length);
    packet.add(shareOf(begin, end));
    addSurface(partOf(surface, begin, end), packet);
    ranks.send(rank, packet);
  }
}

SharedIntegration::~SharedIntegration()
{
  try
  {
    for (; m_next < m_ranks.count(); ++m_next)
    {
      m_ranks.receive(m_next);
    }
  }
  catch (const std::exception&)
  {
    return; // whoever hears from them next finds it out
  }
}

Offset SharedIntegration::ownBlocks() const
{
  return firstBlock(m_blocks, 1, m_ranks.count());
}

void SharedIntegration::begin(const Sites& sites)
{
  while (m_next < m_ranks.count()) // answers to their parts
  {
    Status status;
    this->takeNext(status);
    m_taken = m_taken.ok() ? status : m_taken;
  }
  if (!m_taken.ok())
  {
    return;
  }
  Packet packet;
  packet.add(RankOrder::Integrate);
  packet.add(sites.dimension);
  packet.add(sites.fixed);
  packet.add(sites.coordinates);
  for (int rank = 1; rank < m_ranks.count(); ++rank)
  {
    m_ranks.send(rank, packet);
  }
  m_next = 1;
}

Status SharedIntegration::end(int dimension, const RunControl& control, CellSums* sums)
{
  Status status = m_taken;
  while (m_next < m_ranks.count())
  {
    Status next = this->addNext(dimension, control, sums);
    status = status.ok() ? next : status;
  }
  return status;
}

Packet SharedIntegration::takeNext(Status& status)
{
  const int rank = m_next++;
  Packet packet = m_ranks.receive(rank);
  packet.take(status.code);
  packet.take(status.message);
  if (!status.ok())
  {
    status.message = "Process " + std::to_string(rank) + ": " + status.message;
  }
  return packet;
}

Status SharedIntegration::addNext(int dimension, const RunControl& control, CellSums* sums)
{
  Status status;
  Packet packet = this->takeNext(status);
  if (!status.ok())
  {
    return status;
  }
  std::size_t count = 0;
  packet.take(count);
  std::vector<BlockSums> blocks(count);
  for (BlockSums& block : blocks)
  {
    packet.take(block.sites);
    packet.take(block.values);
  }
  return sums ? addBlocks(blocks, dimension, control.silent(), *sums) : Status::success();
}
}
