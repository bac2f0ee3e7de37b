/**
 * @file BisectorPacks.h
 * @brief The neighbours of the sites that are met, packed for BisectorValues; kept while in use.
 */
#ifndef remesh_BisectorPacks_h
#define remesh_BisectorPacks_h

#include "Voronoi/BisectorValues.h"
#include "Voronoi/NeighborLists.h"

#include <vector>

namespace remesh
{
/** One thread's packs, of sites and lists that stay as they are. */
class BisectorPacks
{
public:
  /** More coordinates than this, and packing them costs more than it saves. */
  static constexpr int maxDimensions = 16;

  BisectorPacks(const Sites& sites, const NeighborLists& lists, InstructionSet instructions);

  /** Offsets of the first `count` neighbours, in rows of `stride()`; valid until the next call. */
  const double* of(Index site, Index count);

  /** The longest list, rounded up to whole lanes. */
  int stride() const { return m_stride; }

private:
  static constexpr std::size_t numberOfPacks = 128;

  struct Pack
  {
    Index site = noIndex;
    int packed = 0;              ///< lanes, so far
    std::vector<double> offsets; ///< (d + 1) x m_stride
  };

  const Sites& m_sites;
  const NeighborLists& m_lists;
  BisectorPacking m_pack;
  int m_stride;
  std::vector<Pack> m_packs; ///< by site modulo their number
};
}

#endif
