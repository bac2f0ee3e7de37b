/**
 * @file StarRepair.h
 * @brief Turns one inverted triangle back by what is around it.
 */
#ifndef remesh_StarRepair_h
#define remesh_StarRepair_h

#include "Repair/RepairedMesh.h"
#include "Run/PlacedVertices.h"
#include "Support/RunControl.h"

#include <vector>

namespace remesh
{
/** What a repair reads, and the least gain of a step in the pass it is in. */
struct RepairContext
{
  const PlacementProblem& problem;
  const std::vector<Point3>& surfacePlaces;
  const RunControl& control;
  bool mayFlip;
  double gain;
};

/** Places for a vertex: around its cell, and between its neighbours. */
std::vector<Point3> placesFor(
  const RepairContext& context, Index vertex, bool many, RepairedMesh& mesh);

/** Moves the corners of a triangle, then turns its edges, until it is turned back. */
void mendTriangle(
  const RepairContext& context, Index triangle, RepairedMesh& mesh, MeshEdits& edits);

/**
 * Moves the corners of a triangle that nothing helps alone, and flips the edges of their stars;
 * undone if it stays inverted.
 */
void mendAround(const RepairContext& context, Index triangle, RepairedMesh& mesh, MeshEdits& edits);
}

#endif
