#include "Voronoi/SharedIntegration.h"

#include "Embedding/SurfacePart.h"
#include "Support/RankTree.h"
#include "Voronoi/RankWork.h"

#include <algorithm>
#include <exception>

namespace remesh
{
namespace
{
/**
 * An evaluation spends as long on a site as on so many facets, as measured: 1.5 us for a site, 0.06
 * for a facet (Speed.md). On a torus, whose outer half has more sites for as many facets, the
 * slower of two ranks takes a twentieth less with it than with as many facets for each.
 */
constexpr double facetsPerSite = 25.0;

double siteMeasureOf(const EmbeddedSurface& surface, Offset begin, Offset end)
{
  double measure = 0.0;
  for (Offset facet = begin; facet < end; ++facet)
  {
    measure += surface.siteMeasureOf(static_cast<Index>(facet));
  }
  return measure;
}

/** The first block of each rank, and their number: so that all take as long. */
std::vector<Offset> divideBlocks(
  const Blocks& blocks, int ranks, const EmbeddedSurface& surface, Index numberOfSites)
{
  const double sites = static_cast<double>(numberOfSites) / surface.siteMeasure;
  std::vector<double> work = { 0.0 }; // up to each block
  for (Offset block = 0; block < blocks.count(); ++block)
  {
    const double measure = siteMeasureOf(surface, blocks.begin(block), blocks.end(block));
    work.push_back(work.back() + static_cast<double>(blocks.end(block) - blocks.begin(block)) +
      facetsPerSite * sites * measure);
  }
  std::vector<Offset> first;
  for (int rank = 0; rank <= ranks; ++rank)
  {
    const double before = work.back() * rank / ranks;
    first.push_back(std::lower_bound(work.begin(), work.end() - 1, before) - work.begin());
  }
  return first;
}
}

Blocks facetBlocks(const EmbeddedSurface& surface)
{
  // Each block has d sums for each site it meets: in many dimensions, fewer blocks hold less.
  constexpr Offset most = 512;
  const Offset wanted = std::clamp<Offset>(most * manyDimensions / surface.dimension, 64, most);
  return Blocks::cut(surface.numberOfFacets(), wanted, most / wanted * 4096);
}

SharedIntegration::SharedIntegration(
  Ranks& ranks, const EmbeddedSurface& surface, Index numberOfSites)
  : m_ranks(ranks)
  , m_next(1)
{
  const Blocks blocks = facetBlocks(surface);
  const std::vector<Offset> first = divideBlocks(blocks, ranks.count(), surface, numberOfSites);
  m_ownBlocks = first[1];
  const auto shareOf = [&](Offset begin, Offset end)
  { return siteMeasureOf(surface, begin, end) / surface.siteMeasure; };
  const Offset own = std::min(blocks.size, blocks.begin(m_ownBlocks));
  m_ownShare = shareOf(0, own);
  for (Offset facet = 0; facet < own; ++facet)
  {
    for (const Index corner : surface.facetCorners[facet])
    {
      m_ownCorners = std::max(m_ownCorners, corner + 1);
    }
  }
  handOn(ranks, Packet::of(RankOrder::TakeSurface));
  for (int rank = 1; rank < ranks.count(); ++rank)
  {
    const Offset begin = std::min(blocks.size, blocks.begin(first[rank]));
    const Offset end = std::min(blocks.size, blocks.begin(first[rank + 1]));
    Packet packet;
    packet.add(blocks.length);
    packet.add(shareOf(begin, end));
    addSurface(partOf(surface, begin, end), packet);
    ranks.send(rank, packet);
  }
}

SharedIntegration::~SharedIntegration()
{
  for (; m_next < m_ranks.count(); ++m_next)
  {
    try
    {
      m_ranks.receive(m_next);
    }
    catch (const std::exception&)
    {
      continue; // whoever hears from it next finds it out
    }
  }
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
  m_order.clear();
  m_order.add(RankOrder::Integrate);
  m_order.add(sites.dimension);
  m_order.add(sites.fixed);
  m_order.add(sites.coordinates);
  m_next = 1; // even where one cannot be reached, others answer
  handOn(m_ranks, m_order);
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
  m_blocks.resize(count);
  for (BlockSums& block : m_blocks)
  {
    packet.take(block.sites);
    packet.take(block.values);
  }
  return sums ? addBlocks(m_blocks, dimension, control.silent(), *sums) : Status::success();
}
}
