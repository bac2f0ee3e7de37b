/**
 * @file Duplicates.h
 * @brief Facets that repeat an earlier one.
 */
#ifndef remesh_Duplicates_h
#define remesh_Duplicates_h

#include "Support/RunControl.h"
#include "Support/Types.h"

#include <vector>

namespace remesh
{
/**
 * 1 for each facet on the same three points as an earlier facet, whatever the sense of rotation.
 *
 * @param facetPoints F x 3, ids from 0; buckets are kept up to the highest.
 * @param control asked for cancellation; the result of a cancelled run is of no use.
 * Cost: O(F log k), k the most facets around a point, in parallel. Deterministic.
 */
std::vector<unsigned char> findDuplicates(
  const std::vector<Triple>& facetPoints, const RunControl& control = RunControl());
}

#endif
