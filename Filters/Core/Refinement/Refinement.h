/**
 * @file Refinement.h
 * @brief Splits the facets of a surface that are too large for what its embedding does on them.
 */
#ifndef remesh_Refinement_h
#define remesh_Refinement_h

#include "Refinement/EdgeSplit.h"

#include <functional>

namespace remesh
{
/**
 * Tells which edges of a surface, as it has been split so far, are too long. It gets an empty
 * `EdgesToSplit` and fills it; the marks need not be closed. Where no edge is, it may leave it
 * empty.
 */
using SplitCriterion =
  std::function<void(const RefinedSurface& surface, const EdgeTable& edges, EdgesToSplit& wanted)>;

struct RefinementLimits
{
  Offset maxFacets = 0;      ///< that the surface may come to have
  int maxRounds = maxSplits; ///< each halves the edges that are too long
  /**
   * If any: pieces are flipped for it after each round. Of facets that are needles by it, the sides
   * are split first, and nothing else with them: edges between their pieces wait.
   */
  const PieceShapes* shapes = nullptr;
};

/**
 * Splits edges, and the facets at them, until the criterion wants no more of them: conforming, as
 * each is split for all facets around it, and the geometry stays as it is. Where there is no room
 * for all that it wants, the longest edges come first, of those that do not wait.
 *
 * To halve longest sides keeps shapes: of a needle it makes pieces all over its inside. They are
 * eight times as many as those between points on its sides, or two times where pieces are flipped
 * (TestMetricLimits.cxx).
 *
 * @param surface of which nothing is split yet (`wholeSurface`).
 * @param control when it cancels, the surface is of no use.
 * @return whether any was split.
 * Cost: O(F) for each round, and that of the criterion.
 */
bool refine(const SplitCriterion& criterion, const RefinementLimits& limits,
  const RunControl& control, RefinedSurface& surface);

/** A surface before any split. The features, if any, must be those that it was cut open along. */
RefinedSurface wholeSurface(const SurfaceMesh& mesh, const Features* features);
}

#endif
