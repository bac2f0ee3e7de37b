#include "Voronoi/BisectorPacks.h"

#include "Support/Lanes.h"

namespace remesh
{
BisectorPacks::BisectorPacks(
  const Sites& sites, const NeighborLists& lists, InstructionSet instructions)
  : m_sites(sites)
  , m_lists(lists)
  , m_pack(bisectorPacking(instructions))
  , m_stride(wholeLanes(lists.longest()))
  , m_packs(numberOfPacks)
{
}

const double* BisectorPacks::of(Index site, Index count)
{
  Pack& pack = m_packs[static_cast<std::size_t>(site) % numberOfPacks];
  if (pack.site != site)
  {
    pack.site = site;
    pack.packed = 0;
    pack.offsets.resize(
      (static_cast<std::size_t>(m_sites.dimension) + 1) * static_cast<std::size_t>(m_stride));
  }
  const int wanted = wholeLanes(count);
  if (pack.packed < wanted)
  {
    const NeighborList list = m_lists.list(site);
    m_pack({ m_sites.site(site), m_sites.coordinates.data(), list.sites, list.count, pack.packed,
      wanted, m_sites.dimension, m_stride, pack.offsets.data() });
    pack.packed = wanted;
  }
  return pack.offsets.data();
}
}
