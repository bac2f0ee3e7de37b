/**
 * @file PlacedCandidate.h
 * @brief A mesh whose vertices have been placed, as repairs see and change it.
 */
#ifndef remesh_PlacedCandidate_h
#define remesh_PlacedCandidate_h

#include "Placement/NearbySurface.h"
#include "Placement/PlacementProblem.h"
#include "Placement/WholeSurface.h"
#include "Repair/CrossingSearch.h"
#include "Repair/InvertedSearch.h"
#include "Repair/MeshRepair.h"
#include "Run/PlacedVertices.h"
#include "Run/Verdict.h"

#include <optional>
#include <vector>

namespace remesh
{
/** What repairs of a placed mesh read. All must outlive the candidate. */
struct PlacedTask
{
  const PlacementProblem& problem; ///< of its diagram only the pieces' facets are read
  const NearbySurface& own;        ///< the facets of the cells
  const WholeSurface& whole;
  const std::vector<Point3>& surfacePlaces; ///< K, points of the surface closest to the centroids
  const std::vector<Point3>& shapes;        ///< K, as in MeshTask
  const RunControl& control;
};

/** What may be wrong with a placed mesh, the worst first. */
enum class MeshFault
{
  Inverted, ///< triangles that face against the facets of their own cells
  Stray,    ///< triangles that face against a closer part of the surface (StrayTriangles.h)
  Crossing  ///< pairs of triangles that could be parted (PartableCrossings.h)
};

/**
 * The candidate of Improve.h that repairs of the placed mesh make better.
 *
 * To look for a fault takes time, and most meshes have none. So a fault is counted from when its
 * repair has its turn (`count`), and not while others are repaired before it. If nothing is wrong,
 * each fault is looked for once. Later judgements are cheaper: which way a triangle faces is found
 * out again only where it has changed.
 */
class PlacedCandidate
{
public:
  /** All that edits change. */
  struct State
  {
    std::vector<Triple> triangles;
    PlacedVertices placed;
  };

  /** @param triangles, placed the mesh: changed in place. Both must outlive the candidate. */
  PlacedCandidate(const PlacedTask& task, std::vector<Triple>& triangles, PlacedVertices& placed);

  /**
   * Counts a fault, now and whenever the candidate is judged. To be called for each fault in its
   * order.
   *
   * @return Cancelled, or success.
   * Cost, in parallel: `Inverted` O(pieces), `Stray` O(T log F), `Crossing` O(T log T).
   */
  Status count(MeshFault fault);

  /** Counts what `count` was called for, after edits. */
  Status judge(const RunControl& control);
  /** `inverted`, `strays` and `crossings`; 0 where they are not counted yet. */
  Verdict verdict() const;
  State state() const { return { m_triangles, m_placed }; }
  void restore(const State& state);

  Offset numberOfTriangles() const { return static_cast<Offset>(m_triangles.size()); }

  /** Turns back the triangles that are counted as inverted or as strays (MeshRepair.h). */
  Status turnBack();
  /** Parts crossing triangles (CrossingRepair.h). Returns whether anything has changed. */
  bool partCrossings();

private:
  const NearbySurface& surface() const { return m_whole ? *m_whole : m_task.own; }
  Status findStrays();
  Status findCrossings();
  Status findPairs(const RunControl& control);
  void lookAtWhole();
  void countWrong();

  const PlacedTask& m_task;
  std::vector<Triple>& m_triangles;
  PlacedVertices& m_placed;
  std::optional<NearbySurface> m_whole;   ///< once more than the facets of the cells is looked at
  std::optional<InvertedSearch> m_search; ///< on `surface()`
  std::vector<Index> m_wrong;             ///< triangles that face against `surface()`, ascending
  bool m_countsCrossings = false;
  std::optional<CrossingSearch> m_crossing; ///< in the mesh as it was judged last
  CrossingSearch::Pairs m_pairs;            ///< that cross there; as in findPartable if too many
};
}

#endif
