/**
 * @file StarRepair.h
 * @brief Turns one inverted triangle back: moves its corners, and flips edges.
 */
#ifndef remesh_StarRepair_h
#define remesh_StarRepair_h

#include "Repair/RepairedMesh.h"
#include "Run/PlacedVertices.h"
#include "Support/RunControl.h"

#include <vector>

namespace remesh
{
/** What the steps of a pass read. */
struct RepairContext
{
  const PlacementProblem& problem;
  const std::vector<Point3>& surfacePlaces; ///< K, points of the surface closest to the centroids
  const RunControl& control;
  bool mayFlip; ///< whether edges may flip
  /** A step must lower the cost (RepairedMesh.h) by at least half of this. */
  double gain;
};

/**
 * Places to try for a vertex: the centroid of its cell, the point of the surface closest to that,
 * and the mean of its neighbours.
 *
 * @param many whether there are more: the mean brought to the surface, points of the surface
 *        halfway to each neighbour, and the middles of up to twelve facets of the cell.
 */
std::vector<Point3> placesFor(
  const RepairContext& context, Index vertex, bool many, RepairedMesh& mesh);

/**
 * Moves the corners of an inverted triangle, one after the other, and then flips its edges if the
 * context allows it. Ends when the triangle is turned back.
 */
void mendTriangle(
  const RepairContext& context, Index triangle, RepairedMesh& mesh, MeshEdits& edits);

/**
 * For an inverted triangle that `mendTriangle` could not turn back: moves its corners, and flips
 * edges of all triangles around them. All is undone if the triangle stays inverted.
 */
void mendAround(const RepairContext& context, Index triangle, RepairedMesh& mesh, MeshEdits& edits);
}

#endif
