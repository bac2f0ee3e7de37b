/**
 * @file KeyOrder.h
 * @brief The order that sorts items by an integer key, equal keys in their first order.
 */
#ifndef remesh_KeyOrder_h
#define remesh_KeyOrder_h

#include "Support/RunControl.h"
#include "Support/Types.h"

#include <vector>

namespace remesh
{
/**
 * Items in ascending order of their keys; stable, hence deterministic.
 *
 * @param keys N keys, N <= maximumIndex.
 * @param control asked for cancellation; the result of a cancelled run is of no use.
 * @return N item ids.
 * Cost: O(N), a radix sort in parallel with digits of 11 bits; digits that all keys share are
 * skipped. 32 N bytes beside the result.
 */
std::vector<Index> orderByKey(
  const std::vector<std::uint64_t>& keys, const RunControl& control = RunControl());
}

#endif
