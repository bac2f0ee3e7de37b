/**
 * @file ReserveRelease.h
 * @brief Takes sites that repairs added and the topology can do without back to where they matter.
 *
 * Delaunay refinement closes in on a small handle from far away: most of the sites it adds on the
 * way are of no use once the handle is found, and are missed elsewhere. So some of them, no
 * neighbours of each other, go to the cells with the most energy. Where the certificate fails
 * without them, they stay the next time.
 */
#ifndef remesh_ReserveRelease_h
#define remesh_ReserveRelease_h

#include "Repair/SiteCandidate.h"

#include <map>
#include <set>
#include <vector>

namespace remesh
{
class ReserveRelease : public SiteProposal
{
public:
  /** Where the topology is right, and some sites were added for it. */
  bool answers(const SiteCandidate& candidate) const override;

  /** Declines where too few of these sites have small cells to matter. O(P + K log K). */
  Status edit(SiteCandidate& candidate, int edit, const RunControl& control, bool& done) override;

  /** Where the topology is still right: the number of vertices can be adjusted. */
  bool hopes(const SiteCandidate& candidate) const override;

  /** Which of the sites and places have led to faults. */
  bool learn(const SiteCandidate& candidate) override;

private:
  using Place = std::vector<double>; ///< d scaled coordinates

  std::vector<Index> findCandidates(const SiteCandidate& candidate) const;
  void choose(const SiteCandidate& candidate, const std::vector<Index>& candidates);
  std::vector<Place> findPlaces(const SiteCandidate& candidate) const;
  Offset numberOfPlaces(const SiteCandidate& candidate) const;
  int failuresOf(const SiteCandidate& candidate, Index site) const;

  std::map<Place, int> m_failures; ///< of sites: how often they were missed
  std::set<Place> m_badPlaces;     ///< at which faults arose
  std::set<Place> m_batch;         ///< of sites that failed together, those not to blame

  // Of the last edit, in the numbers of the sites before it.
  Index m_added = 0;
  Index m_firstAdded = 0;
  std::vector<Index> m_gone;
  std::vector<Index> m_stayed;                 ///< of those added
  std::vector<std::vector<Index>> m_neighbors; ///< of each that is gone
  std::vector<Place> m_rows;                   ///< of those that are gone
  std::vector<Place> m_places;                 ///< where sites came instead
};
}

#endif
