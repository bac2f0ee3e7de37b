/**
 * @file FlipRepair.h
 * @brief Turns back triangles that face against the surface.
 */
#ifndef remesh_FlipRepair_h
#define remesh_FlipRepair_h

#include "Placement/FlipSearch.h"
#include "Placement/PlacementProblem.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

#include <algorithm>

namespace remesh
{
struct FlipRepair
{
  Offset flippedTriangles = 0; ///< that are left
  Offset movedVertices = 0;
  Offset flippedEdges = 0; ///< in the place of the dual's, as many
  Offset refilled = 0; ///< triangles turned back by CavityRepair.h, at most: again, if they flip
};

/**
 * With more flipped triangles than this, of so many, the surface has no sides to tell, or far too
 * few points: steps that take long are left out, as they would help nothing.
 */
inline Offset mostFlipped(Offset triangles)
{
  return std::max<Offset>(100, triangles / 20);
}

/** With more than these left, less is tried: each costs as much, and points are too few. */
constexpr Offset fewFlipped = 10;

enum class FlipSteps
{
  Move,        ///< vertices
  MoveAndTurn, ///< vertices, and edges of triangles
  Refill       ///< these, and cavities (CavityRepair.h)
};

/** What flipped triangles are told and mended by. All must outlive it. */
struct FlipTask
{
  const PlacementProblem& problem;
  const NearbySurface& surface;             ///< triangles are not to face against it
  const std::vector<Point3>& surfacePlaces; ///< K, the surface's points closest to the centroids
  const std::vector<Point3>& shapes; ///< K, positions whose triangles' shapes are kept, roughly
  const RunControl& control;
};

/**
 * 1. Finds the flipped triangles.
 * 2. For each, tries other places for its vertices (not fixed ones): the cell's centroid, its point
 *    on the surface, the mean of the neighbours, and the ways there. Each step must turn a triangle
 *    back.
 * 3. Moves the vertices around what is left over together (Untangling.h), unless it is very much;
 *    likewise in each pass of step 5.
 * 4. Turns edges of what is left then (not those along features), if the topology stays.
 * 5. What is left after that gets more places to try, and what is around it may move and turn:
 *    steps need only lower what the triangles deviate from the surface's normals. Those around it
 *    are undone if the triangle stays flipped, until all else has been tried; and all of them since
 *    the number of flipped triangles last fell. What that does not help gets other edges together
 *    with some around it, if such steps are allowed (CavityRepair.h).
 * 6. Turns edges back where that flips nothing (TurnedEdges.h).
 *
 * Without turned edges, it ends after step 3; so it does where more than `mostFlipped` are left,
 * and before where a pass does not halve them.
 *
 * Steps 2 to 5 go from triangle to triangle in order: flipped ones are few. They end when nothing
 * is flipped, or nothing helps (FlipPasses.h); where more than `fewFlipped` are left, nothing has
 * in a few passes.
 *
 * @param search of the same mesh at other times, or a new one.
 * @param triangles T, of `task.problem.triangles`; changed by turned edges.
 * @param positions K; changed.
 */
Status repairFlips(const FlipTask& task, FlipSteps steps, FlipSearch& search,
  std::vector<Triple>& triangles, std::vector<Point3>& positions, FlipRepair& repair);
}

#endif
