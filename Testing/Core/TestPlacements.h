/**
 * @file TestPlacements.h
 * @brief Meshes of generated surfaces in all placements, and how far they are from the surface.
 */
#ifndef remesh_TestPlacements_h
#define remesh_TestPlacements_h

#include "Embedding/Embedding.h"
#include "Mesh/ClosestPoint.h"
#include "Mesh/Extent.h"
#include "Mesh/FacetGeometry.h"
#include "Mesh/Normals.h"
#include "Remesh.h"
#include "Repair/PlacedMesh.h"
#include "TestSupport.h"

#include <algorithm>
#include <limits>

namespace remesh::test
{
/** Position and normal times `anisotropy` times the diagonal. */
inline EmbeddedSurface gaussMapOf(const SurfaceMesh& mesh, double anisotropy)
{
  const double s = anisotropy * boundingBoxDiagonal(mesh);
  EmbeddedSurface surface;
  CHECK(embedSurface(mesh,
    s > 0.0 ? gaussMapCoordinates(mesh, estimateCornerNormals(mesh, 0), s)
            : positionCoordinates(mesh),
    RunControl(), surface)
          .ok());
  return surface;
}

inline RemeshResult remeshed(
  const SurfaceMesh& mesh, double anisotropy, Offset sites, VertexPlacement placement)
{
  RemeshOptions options;
  options.numberOfSites = sites;
  options.placement = placement;
  RemeshResult result;
  CHECK(
    remesh({ mesh, gaussMapOf(mesh, anisotropy), nullptr, options }, RunControl(), result).ok());
  return result;
}

inline Status placeVertices(const PlacementProblem& problem, VertexPlacement way,
  const RunControl& control, std::vector<SurfaceLocation>& locations,
  std::vector<Triple>& triangles, PlacedVertices& placement)
{
  const Status status =
    choosePlaces(problem, way, control.step(0, 2), locations, placement.positions);
  return status.ok()
    ? repairPlacedMesh(problem, way, control.step(1, 2), locations, triangles, placement)
    : status;
}

/** The same mesh with its vertices placed another way. */
inline RemeshResult placedAnew(const SurfaceMesh& mesh, double anisotropy,
  const RemeshResult& centroids, VertexPlacement placement)
{
  const EmbeddedSurface surface = gaussMapOf(mesh, anisotropy);
  const std::vector<char> none;
  RemeshResult result = centroids;
  result.placement = {};
  const PlacementProblem problem{ mesh, surface, centroids.sites, centroids.diagram,
    centroids.components, centroids.dual.triangles, none };
  CHECK(placeVertices(
    problem, placement, RunControl(), result.locations, result.dual.triangles, result.placement)
          .ok());
  return result;
}

inline double distanceTo(
  const std::vector<Triple>& triangles, const std::vector<Point3>& points, const Point3& place)
{
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : triangles)
  {
    least = std::min(least, closestOnTriangle(place, points[a], points[b], points[c]).squared);
  }
  return std::sqrt(least);
}

/** Root mean square distance from the facets' middles to the mesh, weighted by area: brute force.
 */
inline double rmsDistance(const SurfaceMesh& mesh, const RemeshResult& result, int step)
{
  double squares = 0.0, area = 0.0;
  for (Index f = 0; f < mesh.numberOfFacets(); f += step)
  {
    const auto& [a, b, c] = mesh.facetPoints[f];
    const Point3 middle = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0;
    const double weight = facetArea(mesh.points[a], mesh.points[b], mesh.points[c]);
    const double distance = distanceTo(result.dual.triangles, result.placement.positions, middle);
    squares += weight * distance * distance;
    area += weight;
  }
  return std::sqrt(squares / area);
}

/**
 * Triangles whose normal makes more than 90 degrees with that of the facet closest to their
 * centroid, among all facets. By definition.
 */
inline Offset countInverted(const SurfaceMesh& mesh, const RemeshResult& result)
{
  Offset flipped = 0;
  for (const auto& [i, j, k] : result.dual.triangles)
  {
    const std::vector<Point3>& at = result.placement.positions;
    const Point3 middle = (at[i] + at[j] + at[k]) / 3.0;
    double least = std::numeric_limits<double>::infinity();
    Point3 normal = Point3::Zero();
    for (const auto& [a, b, c] : mesh.facetPoints)
    {
      const double squared =
        closestOnTriangle(middle, mesh.points[a], mesh.points[b], mesh.points[c]).squared;
      if (squared < least)
      {
        least = squared;
        normal = facetNormal(mesh.points[a], mesh.points[b], mesh.points[c]);
      }
    }
    flipped += normal.dot(facetNormal(at[i], at[j], at[k])) < 0.0;
  }
  return flipped;
}
}

#endif
