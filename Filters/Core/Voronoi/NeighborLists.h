/**
 * @file NeighborLists.h
 * @brief The neighbours of each site by increasing distance, in lists that survive small moves.
 *
 * Lists are kept while the sites move little (Verlet lists, as in molecular dynamics). Let d0 be the
 * distance when the list was built, and delta the displacement since. The distance now is at least
 * d0 - delta_i - delta_max. For sites in the list, delta_max is the largest of theirs; for others it
 * is the largest of all sites. The few that moved farthest are measured instead. All stopping
 * tests use that lower bound, so they stay exact. Lists are built anew when too many have become
 * too short to be of use; how far each reached tells how far to look then.
 */
#ifndef remesh_NeighborLists_h
#define remesh_NeighborLists_h

#include "Embedding/Distance.h"
#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/NeighborSearch.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

namespace remesh
{
class NearbySites;

/** The first neighbours of a site, itself left out, by distances when the list was built. */
struct NeighborList
{
  const Index* sites;
  const float* distances; ///< increasing; rounded down, and never above
  Index count;

  /** The largest of these sites' numbers, and 0. @param numbers n, of all sites. */
  double largestOf(const std::vector<double>& numbers) const
  {
    double largest = 0.0;
    for (Index entry = 0; entry < this->count; ++entry)
    {
      largest = std::max(largest, numbers[this->sites[entry]]);
    }
    return largest;
  }
};

/** The lists of all sites, or of some, shared by all threads and read only. */
class NeighborLists
{
public:
  /** @param limit no site this far or farther is put into a list: it is another patch's. */
  explicit NeighborLists(double limit = std::numeric_limits<double>::infinity())
    : m_limit(limit)
  {
  }
  NeighborLists(const NeighborLists&) = delete; // the tree points to the sites, which may be here
  NeighborLists& operator=(const NeighborLists&) = delete;

  /** Makes the lists valid for these sites: builds them if too many sites have moved too far. */
  Status update(const Sites& sites, const RunControl& control);

  /** Builds the tree and the lists for these sites. */
  Status build(const Sites& sites, const RunControl& control);

  /**
   * The same without a copy of the sites: they must stay where they are while this is in use.
   *
   * @param some if given, only these sites get lists; those of others are empty, and longer ones
   *        are made where they are walked through.
   */
  Status buildInPlace(
    const Sites& sites, const RunControl& control, const std::vector<Index>* some = nullptr);

  NeighborList list(Index site) const
  {
    const std::size_t first = static_cast<std::size_t>(site) * static_cast<std::size_t>(m_length);
    return { m_ids.get() + first, m_distances.get() + first, m_places[site].count };
  }
  /** No list has more entries. */
  Index longest() const { return m_length; }

  /**
   * Whether the list holds all sites that are now nearer than `distance` to this one. They are
   * among its entries up to the distance `farthest`.
   */
  bool holds(Index site, double distance, double& farthest) const
  {
    farthest = distance + m_approaches[site];
    return distance <= this->reach(site);
  }

  /**
   * Sites that are not in the list are no nearer than this now, which may be negative. Infinity
   * says that there are none; where there are none, it may yet be finite.
   */
  double reach(Index site) const { return this->minNow(site, m_places[site].reach); }

  /**
   * Sites that were no nearer than `distance` when the lists were built are no nearer than this
   * now: all may have come by the largest displacement, or the few that moved farthest are where
   * they are, and the others came by the largest of theirs.
   */
  double minNow(Index site, double distance) const
  {
    const double own = distance - m_displacements[site];
    return std::max(own - m_largestDisplacement,
      std::min(own - m_usualDisplacement, static_cast<double>(m_leapers[site])));
  }
  /** Sites in the list have come nearer by no more than this since the lists were built. */
  double approachOfListed(Index site) const { return m_approaches[site]; }

  /** All sites that may now be within `distance` of a point of R^d, and few others. */
  void sitesNear(const double* point, double distance, std::vector<Neighbor>& found) const
  {
    m_search->within(point, aboveRounding * (distance + m_largestDisplacement), found);
  }

  /** The tree over the sites as they were when the lists were built. */
  const NeighborSearch& search() const { return *m_search; }

private:
  /** How far the list of a site can be trusted. */
  struct Place
  {
    float reach = 0.0F;  ///< sites that are not in the list are no nearer than this
    float needed = 0.0F; ///< a list that holds the sites within less than this is worn
    Index count = 0;
  };

  Status buildFor(const Sites& sites, const std::vector<Index>& listed, const RunControl& control);
  void makeRoom(std::size_t entries);
  Status measureDisplacements(const Sites& sites, const RunControl& control);
  std::vector<Index> findLeapers();
  bool measureLeapers(
    const Sites& sites, const std::vector<Index>& leapers, const RunControl& control);
  double meanReach() const;
  bool worn() const;
  double radiusLike(const Place& like) const;
  void buildList(Index site, double radius, NearbySites& nearby, std::vector<Neighbor>& found);

  double m_limit;
  Sites m_built; ///< the sites when the lists were built, if they may move
  std::optional<NeighborSearch> m_search;
  // n x length; not even zero, and so without memory of its own, where a list has no entries.
  std::unique_ptr<Index[]> m_ids;
  std::unique_ptr<float[]> m_distances;
  std::size_t m_room = 0;      ///< of these
  std::vector<Place> m_places; ///< n
  Index m_length = 0;

  std::vector<double> m_displacements; ///< n, since the lists were built
  std::vector<double> m_approaches;    ///< n, of the sites in each list
  double m_largestDisplacement = 0.0;
  double m_usualDisplacement = 0.0; ///< the largest but for those of a few sites
  std::vector<float> m_leapers;     ///< n, the distance of the nearest of these; rounded down
};
}

#endif
