/**
 * @file Duplicates.h
 * @brief Facets that repeat an earlier one, and flaps that are folded onto themselves.
 */
#ifndef remesh_Duplicates_h
#define remesh_Duplicates_h

#include "Support/RunControl.h"
#include "Support/Types.h"

#include <vector>

namespace remesh
{
struct Duplicates
{
  /** F: 1 for facets on the same three points as an earlier one, whatever the sense of rotation. */
  std::vector<unsigned char> repeats;
  /** F: 1 for the first of facets on the same three points that face both ways. */
  std::vector<unsigned char> folded;
};

/**
 * @param facetPoints F x 3, ids from 0; buckets are kept up to the highest.
 * @param control asked for cancellation; the result of a cancelled run is of no use.
 * Cost: O(F log k), k the most facets around a point, in parallel. Deterministic.
 */
Duplicates findDuplicates(
  const std::vector<Triple>& facetPoints, const RunControl& control = RunControl());

/**
 * 1 for each facet of a flap: folded facets, joined by edges, that hang on others which close the
 * surface without them. A folded part that hangs on nothing is a sheet that is there twice, and one
 * that continues a border is a sheet, too: these stay.
 *
 * @param facetPoints F x 3, without repeats.
 * @param folded F, as in Duplicates.
 * Cost: O(F) if any is folded, else nothing. Deterministic.
 */
std::vector<unsigned char> findFlaps(const std::vector<Triple>& facetPoints,
  const std::vector<unsigned char>& folded, const RunControl& control = RunControl());
}

#endif
