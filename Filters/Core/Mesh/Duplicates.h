/**
 * @file Duplicates.h
 * @brief Facets that repeat an earlier one.
 */
#ifndef remesh_Duplicates_h
#define remesh_Duplicates_h

#include "Support/Types.h"

#include <vector>

namespace remesh
{
/**
 * 1 for each facet on the same three points as an earlier facet, whatever the sense of rotation.
 *
 * @param facetPoints F x 3, ids from 0; buckets are kept up to the highest.
 * Cost: O(F log k), k the most facets around a point. Deterministic.
 */
std::vector<unsigned char> findDuplicates(const std::vector<Triple>& facetPoints);
}

#endif
