/**
 * @file SpatialOrder.h
 * @brief An order that keeps neighbours in space close in memory.
 */
#ifndef remesh_SpatialOrder_h
#define remesh_SpatialOrder_h

#include "Support/RunControl.h"
#include "Support/Types.h"

#include <vector>

namespace remesh
{
/**
 * Points in the order of the Hilbert curve of their bounding cube; ties stay in the given order.
 *
 * @param points N finite points of R^3, N <= maximumIndex.
 * @param control asked for cancellation; the result of a cancelled run is of no use.
 * @return N point ids.
 * Cost: O(N), in parallel. Deterministic.
 */
std::vector<Index> orderAlongHilbertCurve(
  const std::vector<Point3>& points, const RunControl& control = RunControl());
}

#endif
