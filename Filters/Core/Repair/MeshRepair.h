/**
 * @file MeshRepair.h
 * @brief Turns back triangles that face against the surface.
 */
#ifndef remesh_MeshRepair_h
#define remesh_MeshRepair_h

#include "Placement/PlacementProblem.h"
#include "Repair/InvertedSearch.h"
#include "Run/PlacedVertices.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

#include <algorithm>
#include <vector>

namespace remesh
{
/**
 * The most inverted triangles for which slow steps are worth their time. With more, the surface has
 * no sides to tell, or the mesh has far too few points: edges are not flipped, and cavities not
 * filled.
 *
 * @param triangles of the mesh.
 */
inline Offset maxInverted(Offset triangles)
{
  return std::max<Offset>(100, triangles / 20);
}

/** What a repair may do. Each includes those before it. */
enum class MeshSteps
{
  Move,        ///< move vertices
  MoveAndFlip, ///< flip edges, too
  Refill       ///< replace the triangles of cavities, too (CavityRepair.h)
};

/** What a repair reads. All must outlive it. */
struct MeshTask
{
  const PlacementProblem& problem;
  const NearbySurface& surface;             ///< tells which triangles are inverted
  const std::vector<Point3>& surfacePlaces; ///< K, points of the surface closest to the centroids
  const std::vector<Point3>&
    shapes; ///< K, positions; triangles keep about the shapes they have there
  const RunControl& control;
};

/**
 * Improves the mesh (Improve.h) by a table of passes. Each pass goes over the inverted triangles,
 * with more effort than the one before:
 *
 * 1. Vertices move, one at a time (StarRepair.h).
 * 2. Vertices around a triangle move together (Untangling.h).
 * 3. Edges flip, if the topology stays and no feature is lost.
 * 4. All of this, and what is around the triangle may change, too. Cavities get other triangles
 *    (CavityRepair.h).
 *
 * In 1 to 3 each step must turn a triangle back. In 4 it need only lower the cost of the triangles
 * (RepairedMesh.h). In the end, edges are flipped back to those of the dual, where that inverts
 * nothing (DualEdges.h).
 *
 * @param steps which passes there are, and whether cavities are filled.
 * @param search a new one, or one that has searched earlier states of the same mesh.
 * @param triangles T, those of `task.problem.triangles` or changed ones; edge flips change them.
 * @param placed its positions (K) are changed, its edits replaced.
 */
Status repairMesh(const MeshTask& task, MeshSteps steps, InvertedSearch& search,
  std::vector<Triple>& triangles, PlacedVertices& placed);
}

#endif
