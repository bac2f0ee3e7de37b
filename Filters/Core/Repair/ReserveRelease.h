/**
 * @file ReserveRelease.h
 * @brief Moves sites that the topology does not need any more to where they are of use.
 *
 * The sites that repairs have added are the *reserve*. Delaunay refinement closes in on a small
 * handle from far away. Once the handle is found, most of the reserve is of no use there, and is
 * missed elsewhere. Some of it, no neighbours of each other, is moved to the cells with the most
 * energy. If the certificate fails then, the edit is undone, and those that were missed stay the
 * next time.
 */
#ifndef remesh_ReserveRelease_h
#define remesh_ReserveRelease_h

#include "Repair/SiteCandidate.h"

#include <map>
#include <set>
#include <vector>

namespace remesh
{
/** Answers `reserve` of the verdict. */
class ReserveRelease : public SiteProposal
{
public:
  /** Whether the topology is right, a number of points is kept, and repairs have added sites. */
  bool answers(const SiteCandidate& candidate) const override;

  /**
   * Moves some of the added sites whose cells have little energy. Does nothing if these are too few
   * to be worth a diagram. O(P + K log K).
   */
  Status edit(SiteCandidate& candidate, int edit, const RunControl& control, bool& done) override;

  /** Whether the topology is still right: later edits can put the number of vertices right. */
  bool hopes(const SiteCandidate& candidate) const override;

  /** Finds out which sites were missed, and which places were bad. True if it found any. */
  bool learn(const SiteCandidate& candidate) override;

private:
  using Place = std::vector<double>; ///< d scaled coordinates

  std::vector<Index> findCandidates(const SiteCandidate& candidate) const;
  void choose(const SiteCandidate& candidate, const std::vector<Index>& candidates);
  std::vector<Place> findPlaces(const SiteCandidate& candidate) const;
  Offset numberOfPlaces(const SiteCandidate& candidate) const;
  Sites exchanged(const Sites& before);
  int failuresOf(const SiteCandidate& candidate, Index site) const;

  std::map<Place, int> m_failures; ///< of a site: how often faults arose where it was missing
  std::set<Place> m_badPlaces;     ///< where a site was put, and faults arose
  /** Sites of the last edit that no fault was next to. If there are any, the next edit has these.
   */
  std::set<Place> m_batch;

  // Of the last edit. Sites have the numbers that they had before it.
  Index m_added = 0;      ///< how many sites repairs had added; they are the last ones
  Index m_firstAdded = 0; ///< the first of these
  std::vector<Index> m_gone;
  std::vector<Index> m_stayed;                 ///< of the added sites
  std::vector<std::vector<Index>> m_neighbors; ///< of each site that is gone
  std::vector<Place> m_rows;                   ///< where those that are gone were
  std::vector<Place> m_places;                 ///< where sites are put instead
};
}

#endif
