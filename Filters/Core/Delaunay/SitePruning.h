/**
 * @file SitePruning.h
 * @brief Takes sites that repairs added and the topology can do without back to where they matter.
 *
 * Delaunay refinement closes in on a small handle from far away: most of the sites it adds on the
 * way are of no use once the handle is found, and are missed elsewhere. So some of them, no
 * neighbours of each other, go to the cells with the most energy, and come back where the
 * certificate fails without them, until there are none left to try.
 */
#ifndef remesh_SitePruning_h
#define remesh_SitePruning_h

#include "Delaunay/Certificate.h"
#include "Voronoi/VertexPlaces.h"

#include <memory>

namespace remesh
{
/** A state in which the certificate holds. */
struct PruningBase
{
  std::shared_ptr<const Sites> sites;
  Index added = 0;        ///< by repairs; the last sites there are
  Offset vertices = 0;    ///< of the mesh
  Offset wanted = 0;      ///< of them, extra ones included
  Offset extraPoints = 0; ///< of those wanted; given back first
};

class SitePruning
{
public:
  /** What is tried next. */
  struct Trial
  {
    Sites sites;
    Index added = 0;
    Offset extraPoints = 0;
  };

  /** Whether the sites at hand are a trial's. */
  bool isTrying() const { return !m_batch.empty(); }

  /** Whether there has been a trial. */
  bool hasTried() const { return m_rounds > 0; }

  /**
   * Chooses sites to do without: added ones whose cells have a small part of the mean energy, if
   * there are enough of them to matter. O(P + K log K).
   *
   * @param places of the diagram of the base's sites.
   * @return whether there is something to try.
   */
  bool choose(
    const VertexPlaces& places, const Components& components, const Dual& dual, PruningBase base);

  /** The base without the sites chosen, with others where energy is. O(n). */
  Trial next() const;

  /**
   * Judges the trial's outcome: accepts it, or leaves out what may have broken it. Where the number
   * of the base's vertices is not the one wanted, one that is nearer will do.
   *
   * @param holds whether the certificate does.
   * @param failing sites of the trial where it fails; ascending.
   * @param vertices of the trial's mesh.
   * @return whether it is accepted. If not, and if nothing is left to try, next() is the base.
   */
  bool judge(bool holds, const std::vector<Index>& failing, Offset vertices);

private:
  Index firstAdded() const { return m_base.sites->count() - m_base.added; }
  Offset extraPoints() const;    ///< of the next trial
  Offset wanted() const;         ///< vertices of it
  Offset numberOfPlaces() const; ///< that it uses
  std::vector<Index> addedThatStay() const;
  bool blameSites(const std::vector<Index>& failing, Offset placed);
  bool blamePlaces(const std::vector<Index>& failing, Offset placed);
  bool correct(Offset surplus);
  void giveUp();

  PruningBase m_base;
  std::vector<Index> m_batch;                  ///< sites of the base that go
  std::vector<std::vector<Index>> m_neighbors; ///< of each, sites of the base
  std::vector<double> m_places;                ///< where others come instead, best ones first
  std::vector<char> m_failures;                ///< of the added sites: how often tried in vain
  Offset m_correction = 0;                     ///< of their number, where parts of cells changed
  int m_corrections = 0;
  int m_rounds = 0;
};
}

#endif
