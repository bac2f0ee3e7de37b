/**
 * @file Placement.h
 * @brief Where in R^3 the vertices of the dual go.
 */
#ifndef remesh_Placement_h
#define remesh_Placement_h

#include "Delaunay/SurfaceLocation.h"
#include "Placement/NearbySurface.h"
#include "Placement/PlacementProblem.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

#include <vector>

namespace remesh
{
enum class VertexPlacement
{
  Centroid, ///< of the cell, by mass in R^d
  Surface,  ///< the point of the cell's facets closest to the centroid
  Quadric,  ///< see Quadric.h
  Fit,      ///< see SurfaceFit.h
  HeldFit,  ///< the same, with vertices held along the surface where their cells are
  FirmFit   ///< the same, held as firmly as can be: they move across the surface alone
};

/** Centroids but at the fixed vertices, which are where `given`, if there are K, has them. */
std::vector<Point3> startingPlaces(
  const PlacementProblem& problem, const std::vector<Point3>& given);

/** The points of the surface at these locations, but for fixed vertices, which are at `start`. */
std::vector<Point3> placesOnSurface(const PlacementProblem& problem,
  const std::vector<SurfaceLocation>& locations, const std::vector<Point3>& start);

/** The points of the surface closest to the places, but where these are among known ones. */
Status locatePlaces(const NearbySurface& surface, const std::vector<Point3>& known,
  const std::vector<Point3>& positions, const RunControl& control,
  std::vector<SurfaceLocation>& locations);

/**
 * Places the vertices; triangles may be inverted then (`repairPlacedMesh`).
 *
 * @param locations K, the points of the surface closest to the centroids.
 * @param positions if there are K, where the fixed vertices are (to the bit); else they are at
 *        their centroids. Replaced.
 * Deterministic. Cost: O(pieces + K); a round of the fit about as much as two of Lloyd's.
 */
Status choosePlaces(const PlacementProblem& problem, VertexPlacement way, const RunControl& control,
  const std::vector<SurfaceLocation>& locations, std::vector<Point3>& positions);
}

#endif
