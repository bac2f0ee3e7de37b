/**
 * @file Quadric.h
 * @brief Each vertex where its cell's facets, as planes, are closest.
 */
#ifndef remesh_Quadric_h
#define remesh_Quadric_h

#include "Placement/CellForms.h"

namespace remesh
{
/**
 * For each vertex, the minimiser of the area-weighted squared distances to the planes of its cell's
 * facets (M. Garland, P. Heckbert, "Surface simplification using quadric error metrics", 1997),
 * closest to the centroid where the planes leave a choice: eigenvalues below a share of the largest
 * are cut off (P. Lindstrom, "Out-of-core simplification of large polygonal models", 2000). It
 * stays within the ball around the centroid that holds the centroids of the cell's pieces.
 *
 * @param positions K, of the centroids; replaced but at fixed vertices. R^3, unit of the points.
 * @return false when cancelled.
 * Cost: O(K). Parallel, deterministic.
 */
[[nodiscard]] bool placeByQuadrics(const PlacementProblem& problem, const CellQuadrics& planes,
  const RunControl& control, std::vector<Point3>& positions);
}

#endif
