/**
 * @file Ownership.h
 * @brief The site nearest to each corner of the surface, while the sites move.
 *
 * Starts from each corner's last owner (OwnerSearch.h): exact, and a few distances when it is
 * nearly right. By how much an owner is nearer than all other sites is kept: as long as the sites
 * have moved by less (SiteDrift.h), it is still the owner, and no distance is computed.
 */
#ifndef remesh_Ownership_h
#define remesh_Ownership_h

#include "Support/InstructionSet.h"
#include "Voronoi/SiteDrift.h"

#include <limits>

namespace remesh
{
template <int D>
class OwnerSearch;

class Ownership
{
public:
  explicit Ownership(InstructionSet instructions = widestInstructionSet())
    : m_instructions(instructions)
  {
  }

  /**
   * From now on only the first so many corners are asked for, which are about this share of the
   * surface, and so of what the sites own. Others keep their owners of before.
   */
  void lookAfter(Index corners, double share)
  {
    m_corners = corners;
    m_share = share;
  }

  /** Tells the next update owners (C) that it need not find; noIndex at other corners. */
  void know(std::vector<Index> owners, const Sites& sites);

  /** Starts from the last owners; else from that of the corner before, or a search in the tree. */
  Status update(const EmbeddedSurface& surface, const Sites& sites, const NeighborLists& lists,
    const RunControl& control);

  /** C sites. */
  const std::vector<Index>& owners() const { return m_owners; }
  /** C squared distances to them, in `manyDimensions` only, where they are worth keeping. */
  const std::vector<double>& squared() const { return m_squared; }

private:
  template <int D>
  void updateRange(Index begin, Index end, const EmbeddedSurface& surface, const Sites& sites,
    OwnerSearch<D>& search);

  void begin(std::vector<Index> owners, const Sites& sites);

  InstructionSet m_instructions;
  std::vector<Index> m_owners;
  std::vector<double> m_squared;
  SiteDrift m_drift;
  Index m_corners = std::numeric_limits<Index>::max(); ///< that are looked after
  double m_share = 1.0;
  Index m_numberOfSites = 0;
  std::vector<float> m_leads; ///< C, and the owner's drift when it was found; rounded down
  bool m_someKnown = false;   ///< infinite leads stand for owners that are told, for one update
};
}

#endif
