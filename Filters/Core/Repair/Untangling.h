/**
 * @file Untangling.h
 * @brief Gives all triangles around an inverted one a positive area, seen from the surface.
 */
#ifndef remesh_Untangling_h
#define remesh_Untangling_h

#include "Repair/RepairedMesh.h"

namespace remesh
{
/**
 * Moves the free vertices within a few rings of a triangle together. A triangle's area as it is
 * projected along the surface's normal is linear in each of its corners; vertex by vertex, again
 * and again, the squares of what the areas lack to a small positive value are minimised (untangling
 * as in Freitag and Plassmann, Local optimization-based simplicial mesh untangling and improvement,
 * 2000, with a smooth measure). Vertices move about along the surface, and then back as far as they
 * can.
 *
 * @param rings how far around the triangle, from 1.
 * @return the number of vertices moved; 0, and nothing is changed, unless no triangle around is
 *         inverted after, and the surface is about as near; or the run is cancelled.
 * Cost: up to some thousand searches for the surface's closest facet, each among the pieces of a
 * few cells.
 */
Offset untangle(const PlacementProblem& problem, const NearbySurface& surface, Index triangle,
  int rings, const RunControl& control, RepairedMesh& mesh);
}

#endif
