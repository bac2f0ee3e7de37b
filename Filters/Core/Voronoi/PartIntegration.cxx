#include "Voronoi/PartIntegration.h"

#include "Embedding/SurfacePart.h"

namespace remesh
{
namespace
{
template <class T>
T take(Packet& packet)
{
  T value = 0;
  packet.take(value);
  return value;
}
}

PartIntegration::PartIntegration(Packet& part)
  : m_blockLength(take<Offset>(part))
  , m_share(take<double>(part))
  , m_surface(takeSurface(part))
  , m_voronoi(m_surface)
{
  m_voronoi.beShare(m_share);
}

Status PartIntegration::integrate(Packet& sites, Packet& answer)
{
  sites.take(m_sites.dimension);
  sites.take(m_sites.fixed);
  sites.take(m_sites.coordinates);
  Status status = m_voronoi.integrateBlocks(m_sites, m_blockLength, RunControl(), m_blocks);
  if (!status.ok())
  {
    return status;
  }
  answer.add(m_blocks.size());
  for (const BlockSums& block : m_blocks)
  {
    answer.add(block.sites);
    answer.add(block.values);
  }
  return status;
}
}
