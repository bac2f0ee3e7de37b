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
 * With more inverted triangles than this, of so many, the surface has no sides to tell, or far too
 * few points: steps that take long are left out, as they would help nothing.
 */
inline Offset maxInverted(Offset triangles)
{
  return std::max<Offset>(100, triangles / 20);
}

/** What may change. */
enum class MeshSteps
{
  Move,        ///< vertices
  MoveAndFlip, ///< vertices, and edges of triangles
  Refill       ///< these, and cavities (CavityRepair.h)
};

/** What inverted triangles are told and turned back by. All must outlive it. */
struct MeshTask
{
  const PlacementProblem& problem;
  const NearbySurface& surface;             ///< triangles are not to face against it
  const std::vector<Point3>& surfacePlaces; ///< K, the surface's points closest to the centroids
  const std::vector<Point3>& shapes; ///< K, positions whose triangles' shapes are kept, roughly
  const RunControl& control;
};

/**
 * Improves the mesh (Improve.h) by a table of passes over its inverted triangles, in order: they
 * are few. First each step must turn a triangle back: vertices move alone, then together
 * (Untangling.h), then edges flip (not those along features), if the topology stays. Later steps
 * need only lower what triangles deviate from the surface's normals, around a triangle, too, and
 * cavities are filled anew (CavityRepair.h). In the end edges are flipped back where that inverts
 * nothing (DualEdges.h).
 *
 * @param search of the same mesh at other times, or a new one.
 * @param triangles T, of `task.problem.triangles`; changed by edge flips.
 * @param positions K; changed.
 */
Status repairMesh(const MeshTask& task, MeshSteps steps, InvertedSearch& search,
  std::vector<Triple>& triangles, std::vector<Point3>& positions, MeshEdits& edits);
}

#endif
