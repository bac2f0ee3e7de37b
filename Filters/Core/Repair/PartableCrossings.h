/**
 * @file PartableCrossings.h
 * @brief Tells which crossing triangles can be parted.
 *
 * Where the surface goes through itself, so must the mesh. To part triangles there would be
 * hundreds of tries in vain.
 */
#ifndef remesh_PartableCrossings_h
#define remesh_PartableCrossings_h

#include "Placement/PlacementProblem.h"
#include "Repair/CrossingSearch.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

#include <utility>
#include <vector>

namespace remesh
{
/**
 * Finds the pairs that can be parted. Each triangle has the facets that the cells of its corners
 * meet. A pair can be parted if no facet of one triangle goes through a facet of the other.
 *
 * @param most the search ends when it has found more pairs than this: they are too many to part.
 * @param pairs the lower number first, ascending: all of them, or the first `most` + 1. Replaced.
 * @return Cancelled, then `pairs` is of no use; or success.
 * Deterministic. Cost: that of `search`, and for each pair of crossing triangles a sort of their
 * facets and a test of those facets whose boxes meet; in parallel.
 */
Status findPartable(const PlacementProblem& problem, const CrossingSearch& search, Offset most,
  const RunControl& control, CrossingSearch::Pairs& pairs);
}

#endif
