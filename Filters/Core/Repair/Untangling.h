/**
 * @file Untangling.h
 * @brief Moves the vertices around an inverted triangle together, until none there is inverted.
 */
#ifndef remesh_Untangling_h
#define remesh_Untangling_h

#include "Repair/RepairedMesh.h"

namespace remesh
{
/**
 * Moves the free vertices within a few rings of a triangle.
 *
 * 1. Each triangle there has an area as it is seen along the surface's normal. It is below 0 where
 *    the triangle is inverted, and linear in each of its corners.
 * 2. Each triangle is to have a small positive area. What it lacks is squared, and the sum of the
 *    squares is minimised, vertex by vertex, again and again.
 * 3. In the end, vertices go back towards where they were, as far as no triangle is inverted.
 *
 * Vertices keep their height above the surface. The untangling is that of L. Freitag, P. Plassmann,
 * "Local optimization-based simplicial mesh untangling and improvement", 2000, with a smooth
 * measure.
 *
 * @param rings 1: the corners of the triangle move; 2: their neighbours, too; and so on.
 * @return the number of vertices that have moved. 0 and no change if a triangle around is still
 *         inverted, if the surface would be much farther away, or if the run is cancelled.
 * Cost: up to some thousand searches for the closest facet, each among the pieces of a few cells.
 */
Offset untangle(const NearbySurface& surface, Index triangle, int rings, const RunControl& control,
  RepairedMesh& mesh);
}

#endif
