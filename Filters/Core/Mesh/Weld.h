/**
 * @file Weld.h
 * @brief Which points of a surface are one and the same.
 */
#ifndef remesh_Weld_h
#define remesh_Weld_h

#include "Support/RunControl.h"
#include "Support/Types.h"

#include <vector>

namespace remesh
{
/**
 * For each point the lowest point with the same coordinates (-0 equals +0).
 *
 * @param points P finite points of R^3, P <= maximumIndex.
 * @param control asked for cancellation; the result of a cancelled run is of no use.
 * Cost: O(P) but for points that share a hash (at worst O(P log P)), in parallel. Deterministic.
 */
std::vector<Index> weldEqualPoints(
  const std::vector<Point3>& points, const RunControl& control = RunControl());

/**
 * For each point the lowest point of its cluster. Points nearer than `distance` are in one cluster,
 * and so, transitively, are chains of them.
 *
 * @param points P finite points of R^3, P <= maximumIndex.
 * @param distance above 0, in the unit of the points; strict: points just that far apart stay two.
 * @param control asked for cancellation; the result of a cancelled run is of no use.
 * Cost: O(P log P) while the points are spread out; pairs of crowded grid cells that no pair of
 * points joins are searched point by point. Deterministic.
 */
std::vector<Index> weldNearPoints(
  const std::vector<Point3>& points, double distance, const RunControl& control);
}

#endif
