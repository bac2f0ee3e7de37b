/**
 * @file NeighborSearch.h
 * @brief Exact nearest sites in R^d: the one seam to nanoflann.
 */
#ifndef remesh_NeighborSearch_h
#define remesh_NeighborSearch_h

#include "Embedding/EmbeddedSurface.h"

#include <memory>
#include <vector>

namespace remesh
{
struct Neighbor
{
  Index site;
  double distance; ///< in R^d, scaled units
};

/** k-d trees over the sites, at least one. The sites must outlive it and not move. */
class NeighborSearch
{
public:
  explicit NeighborSearch(const Sites& sites);
  ~NeighborSearch();
  NeighborSearch(NeighborSearch&&) noexcept;
  NeighborSearch& operator=(NeighborSearch&&) noexcept;

  /** A site nearest to a point of R^d. O(log n). */
  Index nearest(const double* point) const;

  /**
   * The `count` sites nearest to a site, itself left out, by increasing distance (fewer if there
   * are no more that are nearer than `limit`). The order among equal distances is fixed but
   * arbitrary.
   */
  void neighbors(Index site, Index count, double limit, std::vector<Neighbor>& result) const;

  /** The sites nearer to a point of R^d than `radius`, in an order that is fixed but arbitrary. */
  void within(const double* point, double radius, std::vector<Neighbor>& result) const;

  Index numberOfSites() const { return m_sites->count(); }

private:
  class Forest;
  template <int D>
  class ForestOf;

  const Sites* m_sites;
  std::unique_ptr<Forest> m_forest;
};
}

#endif
