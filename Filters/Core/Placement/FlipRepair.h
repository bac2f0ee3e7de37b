/**
 * @file FlipRepair.h
 * @brief Turns back triangles that face against the surface.
 */
#ifndef remesh_FlipRepair_h
#define remesh_FlipRepair_h

#include "Placement/NearbySurface.h"
#include "Placement/PlacementProblem.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

namespace remesh
{
struct FlipRepair
{
  Offset flippedTriangles = 0; ///< that are left
  Offset movedVertices = 0;
  Offset flippedEdges = 0; ///< each changes two triangles of the dual
};

/**
 * 1. Finds the triangles whose normal makes more than 90 degrees with that of the closest facet
 *    (NearbySurface.h). Parallel.
 * 2. For each, tries other places for its vertices (not fixed ones): the cell's centroid, its point
 *    on the surface, the mean of the neighbours, and the ways there; takes what leaves the fewest
 *    flipped triangles around, and among those what faces the surface best.
 * 3. Where that does not help, turns an edge of it over, if that leaves fewer flipped triangles and
 *    makes no edge that is there already; for at most one triangle in 2000, as the mesh is to stay
 *    the dual of the diagram.
 *
 * Steps 2 and 3 go from triangle to triangle in order, up to four times: flipped ones are few.
 *
 * @param surfacePlaces K, the points of the surface closest to the centroids.
 * @param shapes K, the positions whose triangles' shapes are to be kept, roughly.
 * @param triangles T, of `problem.triangles`; changed by turned edges.
 * @param positions K; changed.
 */
Status repairFlips(const PlacementProblem& problem, const NearbySurface& surface,
  const std::vector<Point3>& surfacePlaces, const std::vector<Point3>& shapes,
  const RunControl& control, std::vector<Triple>& triangles, std::vector<Point3>& positions,
  FlipRepair& repair);
}

#endif
