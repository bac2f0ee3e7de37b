/**
 * @file NeighborLists.h
 * @brief The neighbours of each site by increasing distance, in lists that survive small moves.
 *
 * Lists are kept while the sites move little (Verlet lists, as in molecular dynamics). Let d0 be
 * the distance when the list was built, and delta the displacement since. The distance now is at
 * least d0 - delta_i - delta_max. For sites in the list, delta_max is the largest of theirs; for
 * others it is the largest of all sites. The few that moved farthest are measured instead. All
 * stopping tests use that lower bound, so they stay exact.
 *
 * A sample of the sites has lists at all times. All are built anew when too many of the sample's
 * have become too short to be of use; how far these reach tells how far to look for the sites
 * around. So a list is the same whenever it is made, and whichever other sites have one: those that
 * nobody asks for need none.
 */
#ifndef remesh_NeighborLists_h
#define remesh_NeighborLists_h

#include "Embedding/Distance.h"
#include "Support/Parallel.h"
#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/Leapers.h"
#include "Voronoi/NeighborSearch.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

namespace remesh
{
class NearbySites;

/** In which what is done for each site is shared out. */
inline Blocks siteBlocks(const Sites& sites)
{
  return Blocks::cut(sites.count(), 1024, 4096);
}

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

/** The lists of all sites, shared by all threads. A list that is missing is made when asked for. */
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

  /**
   * From now on `build` makes lists, beside the sample's, only for the sites that were asked for
   * before; at first for none. For who looks at a part of the sites.
   */
  void makeOnlyAsked() { m_onlyAsked = true; }

  /**
   * Makes the lists valid for these sites, which must stay where they are while the lists are in
   * use: builds them if too many sites have moved too far.
   */
  Status update(const Sites& sites, const RunControl& control);

  /** Builds the tree and the lists for these sites. */
  Status build(const Sites& sites, const RunControl& control);

  /**
   * The same without a copy of the sites: they must stay where they are while this is in use.
   *
   * Without a sample: a list that is made when asked for may be longer or shorter.
   *
   * @param some if given, only these sites get lists now.
   */
  Status buildInPlace(
    const Sites& sites, const RunControl& control, const std::vector<Index>* some = nullptr);

  NeighborList list(Index site) const
  {
    const Index count = this->placeOf(site).count.load(std::memory_order_relaxed);
    const std::size_t first = static_cast<std::size_t>(site) * static_cast<std::size_t>(m_length);
    return { m_ids.get() + first, m_distances.get() + first, count };
  }
  /** Whether the site has a list already. */
  bool isListed(Index site) const
  {
    return m_places[site].count.load(std::memory_order_acquire) != unlisted;
  }
  /** The sites that have lists. O(n). */
  Index numberOfLists() const;
  /** No list has more entries. */
  Index longest() const { return m_length; }

  /**
   * Whether the list holds all sites that are now nearer than `distance` to this one. They are
   * among its entries up to the distance `farthest`.
   */
  bool holds(Index site, double distance, double& farthest) const
  {
    const Place& place = this->placeOf(site);
    farthest = distance + place.approach;
    return distance <= this->minNow(place, site, place.reach);
  }

  /**
   * Sites that are not in the list are no nearer than this now, which may be negative. Infinity
   * says that there are none; where there are none, it may yet be finite.
   */
  double reach(Index site) const
  {
    const Place& place = this->placeOf(site);
    return this->minNow(place, site, place.reach);
  }

  /**
   * Sites that were no nearer than `distance` when the lists were built are no nearer than this
   * now: all may have come by the largest displacement, or the few that moved farthest are where
   * they are, and the others came by the largest of theirs.
   */
  double minNow(Index site, double distance) const
  {
    return this->minNow(this->placeOf(site), site, distance);
  }
  /** Sites in a list that is there have come nearer by no more than this since it was built. */
  double approachOfListed(Index site) const { return m_places[site].approach; }

  /** All sites that may now be within `distance` of a point of R^d, and few others. */
  void sitesNear(const double* point, double distance, std::vector<Neighbor>& found) const
  {
    m_search->within(point, aboveRounding * (distance + m_largestDisplacement), found);
  }

  /** The tree over the sites as they were when the lists were built. */
  const NeighborSearch& search() const { return *m_search; }

private:
  static constexpr Index unlisted = -1;
  static constexpr std::size_t numberOfLocks = 64;

  /** How far the list of a site can be trusted. */
  struct Place
  {
    float radius = 0.0F;   ///< about as many sites as a list is to have are within, then and now
    float reach = 0.0F;    ///< sites that are not in the list are no nearer than this
    float needed = 0.0F;   ///< a list that holds the sites within less than this is worn
    float leapers = 0.0F;  ///< they are no nearer than this now
    double approach = 0.0; ///< of the sites in the list, since it was built
    /** Of the list's entries; unlisted: there is none. Who reads another finds the list made. */
    std::atomic<Index> count{ unlisted };
  };

  /** The place of a site that has a list now. */
  const Place& placeOf(Index site) const
  {
    if (!this->isListed(site))
    {
      this->makeAsked(site);
    }
    return m_places[site];
  }
  double minNow(const Place& place, Index site, double distance) const
  {
    const double own = distance - m_displacements[site];
    return std::max(own - m_largestDisplacement,
      std::min(own - m_usualDisplacement, static_cast<double>(place.leapers)));
  }

  Status measureDisplacements(const Sites& sites, const RunControl& control);
  /** Calls `visit(site)` for the sites that have lists. False: cancelled. */
  template <class Visit>
  bool forEachList(const RunControl& control, const Visit& visit);
  double approachOf(Index site, Index count) const;
  double meanReach() const;
  bool worn() const;

  /** The one of the sample that stands for a site. */
  Index standIn(Index site) const { return site - site % m_stride; }
  double radiusOfStandIn(Index site) const
  {
    return m_stride > 0 ? m_places[this->standIn(site)].radius : 0.0;
  }
  std::vector<Index> othersToList(bool known) const;

  void begin(const Sites& sites);
  Status finish(bool done);
  double radiusAround(double reach, Index count) const;
  Index makeList(
    Index site, double radius, NearbySites& nearby, std::vector<Neighbor>& found) const;
  /** @param radius called with a site and the radius around the site before, or 0. */
  template <class Radius>
  bool makeLists(
    const std::vector<Index>& listed, const RunControl& control, const Radius& radius) const;
  void makeAsked(Index site) const;

  double m_limit;
  bool m_onlyAsked = false;
  Sites m_built;                  ///< the sites when the lists were built, if they may move
  const Sites* m_sites = nullptr; ///< the same, or those in place
  const Sites* m_now = nullptr;   ///< where they have moved to
  std::vector<Index> m_sample;
  Index m_stride = 0; ///< of the sample; 0: there is none
  std::optional<NeighborSearch> m_search;
  // n x length; not even zero, and so without memory of its own, where a list has no entries.
  std::unique_ptr<Index[]> m_ids;
  std::unique_ptr<float[]> m_distances;
  std::size_t m_room = 0;                    ///< of these
  mutable std::vector<Place> m_places;       ///< n
  mutable std::mutex m_locks[numberOfLocks]; ///< for lists that are asked for, by site
  Index m_length = 0;

  std::vector<double> m_displacements; ///< n, since the lists were built
  double m_largestDisplacement = 0.0;
  double m_usualDisplacement = 0.0; ///< the largest but for those of a few sites
  Leapers m_leapers;                ///< these few, where the others' is smaller
};
}

#endif
