/**
 * @file OwnerSearch.h
 * @brief The site nearest to a point, from one that is near: the lower id wins a tie.
 *
 * A site that is nearer than `owner` is within twice the owner's distance of it. Those are looked
 * at many at once where the owner's list holds them all and none comes as near as rounding; else
 * one by one, by increasing distance from the owner; where that becomes long, the tree is asked.
 */
#ifndef remesh_OwnerSearch_h
#define remesh_OwnerSearch_h

#include "Voronoi/BisectorPacks.h"
#include "Voronoi/NeighborWalk.h"

#include <limits>
#include <optional>
#include <vector>

namespace remesh
{
/** One thread's working memory. D: see dispatchDimension. */
template <int D>
class OwnerSearch
{
public:
  struct Owner
  {
    Index site = noIndex;
    double squared = 0.0; ///< its squared distance
    double others = 0.0;  ///< no other site is known to be nearer than this
  };

  /** @param packs whether so many points are asked for that packing the neighbours pays. */
  OwnerSearch(
    const Sites& sites, const NeighborLists& lists, bool packs, InstructionSet instructions);

  /** Starts a range of points: what is found does not depend on those before. */
  void begin()
  {
    m_longer.clear();
    m_last = noIndex;
  }

  /** From `start`, or from a site found to walk from if it is noIndex. */
  Owner find(const double* point, Index start);

private:
  struct Nearer
  {
    Index site = noIndex; ///< one that is nearer than the owner, or noIndex
    double owned = 0.0;   ///< squared distance of the owner
    double others = 0.0;  ///< no other site is known to be nearer than this, if there is none
  };

  Index startOf(const double* point) const;
  bool findNearerPacked(const double* point, Index owner, Nearer& result);
  Nearer findNearer(const double* point, Index owner);
  Nearer findNearest(const double* point, Index owner);

  const Sites& m_sites;
  const NeighborLists& m_lists;
  LongerLists m_longer;
  Index m_last = noIndex; ///< owner of the last point
  std::optional<BisectorPacks> m_packs;
  BisectorMinimum m_least;
  std::vector<double> m_offset; ///< d, of the point from the owner
  std::vector<double> m_values;
};

extern template class OwnerSearch<3>;
extern template class OwnerSearch<6>;
extern template class OwnerSearch<Eigen::Dynamic>;
}

#endif
