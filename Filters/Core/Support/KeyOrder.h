/**
 * @file KeyOrder.h
 * @brief The order that sorts items by an integer key, equal keys in their first order.
 */
#ifndef remesh_KeyOrder_h
#define remesh_KeyOrder_h

#include "Support/Types.h"

#include <vector>

namespace remesh
{
/**
 * Items in ascending order of their keys; stable, hence deterministic.
 *
 * @param keys N keys, N <= maximumIndex.
 * @return N item ids.
 * Cost: O(N), a radix sort with digits of 11 bits; digits that all keys share are skipped.
 */
std::vector<Index> orderByKey(const std::vector<std::uint64_t>& keys);
}

#endif
