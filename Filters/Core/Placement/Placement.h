/**
 * @file Placement.h
 * @brief Where in R^3 the vertices of the dual go.
 */
#ifndef remesh_Placement_h
#define remesh_Placement_h

#include "Delaunay/SurfaceLocation.h"
#include "Placement/FlipRepair.h"
#include "Placement/PlacementProblem.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

#include <algorithm>

namespace remesh
{
enum class VertexPlacement
{
  Centroid, ///< of the cell, by mass in R^d
  Surface,  ///< the point of the cell's facets closest to the centroid
  Quadric,  ///< see Quadric.h
  Fit,      ///< see SurfaceFit.h
  HeldFit   ///< the same, with vertices held along the surface where their cells are
};

struct Placement
{
  std::vector<Point3> positions; ///< K, R^3, the unit of the points
  FlipRepair repair;
  /**
   * Triangles left that face the closest part of the whole surface the wrong way, before crossing
   * ones were parted: that flips none.
   */
  Offset wrongWay = 0;

  /** Those of them that face their own cells' facets along (StrayTriangles.h). */
  Offset strays() const
  {
    return std::max(this->wrongWay - this->repair.flippedTriangles, Offset(0));
  }
};

/**
 * Places the vertices; triangles may be flipped then (`mendPlaces`).
 *
 * @param locations K, the points of the surface closest to the centroids.
 * @param positions if there are K, where the fixed vertices are (to the bit); else they are at
 *        their centroids. Replaced.
 * Deterministic. Cost: O(pieces + K); a round of the fit about as much as two of Lloyd's.
 */
Status choosePlaces(const PlacementProblem& problem, VertexPlacement way, const RunControl& control,
  const std::vector<SurfaceLocation>& locations, std::vector<Point3>& positions);

/**
 * Turns flipped triangles back (FlipRepair.h): first vertices move, then some retreat to where they
 * come to from the centroids (Retreat.h), then edges turn. Last, moves and turns are tried for
 * triangles that face other parts of the surface the wrong way, where these are closer than their
 * own; and triangles that go through each other are parted (CrossingRepair.h), if they are few.
 *
 * @param problem of its diagram only the pieces' facets are read.
 * @param locations K, the points of the surface closest to the centroids; replaced by those closest
 *        to the places, among the facets of the vertex's cell and those around it.
 * @param triangles of `problem.triangles`; a few may change to turn flipped ones back.
 * @param placement with the chosen places; a few may change.
 * Deterministic. Cost: O(pieces + K).
 */
Status mendPlaces(const PlacementProblem& problem, VertexPlacement way, const RunControl& control,
  std::vector<SurfaceLocation>& locations, std::vector<Triple>& triangles, Placement& placement);
}

#endif
