/**
 * @file PartableCrossings.h
 * @brief Which triangles that go through each other can be parted.
 *
 * Where the surface goes through itself, so must the mesh: to part its triangles takes hundreds of
 * tries, in vain.
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
 * Finds the pairs that can be parted: those where no facet that the cells of the one triangle meet
 * goes through one that the cells of the other meet.
 *
 * @param search of the same triangles.
 * @param most with more pairs than this there is no use in any: the search ends.
 * @param pairs the lower number first, ascending: all of them, or the first `most` + 1. Replaced.
 * @return Cancelled; then `pairs` is of no use.
 * Deterministic. Cost: that of the search, and for each pair of crossing triangles the facets of
 * their cells, and those pairs of these whose boxes are not apart along an axis; in parallel. Of
 * pairs that can be parted, about a hundred more than `most` are tried, however many there are.
 */
Status findPartable(const PlacementProblem& problem, const CrossingSearch& search,
  const std::vector<Triple>& triangles, Offset most, const RunControl& control,
  std::vector<std::pair<Index, Index>>& pairs);
}

#endif
