#include "Voronoi/SharedIntegration.h"

#include "Embedding/SurfacePart.h"

#include <algorithm>

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
  : m_others(ranks)
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
  const auto partFor = [&](int rank)
  {
    const Offset begin = std::min(blocks.size, blocks.begin(first[rank]));
    const Offset end = std::min(blocks.size, blocks.begin(first[rank + 1]));
    Packet packet;
    packet.add(blocks.length);
    packet.add(shareOf(begin, end));
    addSurface(partOf(surface, begin, end), packet);
    return packet;
  };
  m_others.tell(RankOrder::TakeSurface, Packet(), partFor);
}

void SharedIntegration::begin(const Sites& sites)
{
  while (m_others.moreAnswers()) // to their parts
  {
    Status status;
    m_others.takeAnswer(status);
    m_taken = m_taken.ok() ? status : m_taken;
  }
  if (!m_taken.ok())
  {
    return;
  }
  m_packet.clear();
  m_packet.add(sites.dimension);
  m_packet.add(sites.fixed);
  m_packet.add(sites.coordinates);
  m_others.tell(RankOrder::Integrate, m_packet, nullptr);
}

Status SharedIntegration::end(int dimension, const RunControl& control, CellSums* sums)
{
  Status status = m_taken;
  while (m_others.moreAnswers())
  {
    Status next = this->addNext(dimension, control, sums);
    status = status.ok() ? next : status;
  }
  return status;
}

Status SharedIntegration::addNext(int dimension, const RunControl& control, CellSums* sums)
{
  Status status;
  Packet packet = m_others.takeAnswer(status);
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
