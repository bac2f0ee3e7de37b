/**
 * @file Retreat.h
 * @brief Where one placement leaves triangles flipped, the places of another that does not.
 */
#ifndef remesh_Retreat_h
#define remesh_Retreat_h

#include "Placement/NearbySurface.h"
#include "Placement/PlacementProblem.h"
#include "Support/RunControl.h"

namespace remesh
{
/**
 * Gives the vertices of each flipped triangle, and of up to a few rings around, their places in
 * another placement: the fewest rings with which none of the triangles that change is flipped.
 * Where there are none such, nothing changes.
 *
 * @param others K, places that flip fewer triangles.
 * @param flipped ascending.
 * @param control when it cancels, some have not moved.
 * @param positions K; changed.
 * @return the vertices given other places, again for each triangle.
 * Cost: O(K + T), and some hundred triangles are judged for each that is flipped.
 */
Offset retreat(const PlacementProblem& problem, const NearbySurface& surface,
  const std::vector<Point3>& others, const std::vector<Index>& flipped, const RunControl& control,
  std::vector<Point3>& positions);

/**
 * Gives the vertices of the flipped triangles, and of so many rings around, their other places,
 * whatever that flips. O(K + T).
 */
void retreatAround(const PlacementProblem& problem, const std::vector<Point3>& others,
  const std::vector<Index>& flipped, int rings, std::vector<Point3>& positions);
}

#endif
