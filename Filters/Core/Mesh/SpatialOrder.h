/**
 * @file SpatialOrder.h
 * @brief An order that keeps neighbours in space close in memory.
 */
#ifndef remesh_SpatialOrder_h
#define remesh_SpatialOrder_h

#include "Support/Types.h"

#include <vector>

namespace remesh
{
/**
 * Points in the order of the Hilbert curve of their bounding cube; ties stay in the given order.
 *
 * @param points N finite points of R^3, N <= maximumIndex.
 * @return N point ids.
 * Cost: O(N). Deterministic.
 */
std::vector<Index> orderAlongHilbertCurve(const std::vector<Point3>& points);
}

#endif
