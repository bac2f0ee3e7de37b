/**
 * @file TestPushedBand.h
 * @brief A mesh in which triangles go through each other, that could be parted.
 */
#ifndef remesh_TestPushedBand_h
#define remesh_TestPushedBand_h

#include "Repair/InvertedSearch.h"
#include "Repair/PartableCrossings.h"
#include "TestPlacements.h"

#include <cmath>
#include <limits>

namespace remesh::test
{
/** All pairs that cross. */
inline CrossingSearch::Pairs crossingsOf(
  const std::vector<Triple>& triangles, const std::vector<Point3>& positions)
{
  CrossingSearch::Pairs pairs;
  CHECK(CrossingSearch(triangles, positions, RunControl()).find(RunControl(), pairs).ok());
  return pairs;
}

/** A closed band, thin at its rims, that waves up and down. */
inline SurfaceMesh thinBand(double thickness)
{
  return meshOf(wrappedGrid(160, 48, true,
    [=](int i, int j)
    {
      const double u = 2.0 * pi * i / 160;
      const double v = 2.0 * pi * j / 48;
      const double ring = 1.0 + 0.06 * std::sin(6.0 * u) + 0.5 * thickness * std::cos(v);
      return Point3(ring * std::cos(u), ring * std::sin(u), 0.25 * std::sin(v));
    }));
}

/** Of the facet closest to a place. */
inline Point3 nearestNormal(const SurfaceMesh& mesh, const Point3& place)
{
  double least = std::numeric_limits<double>::infinity();
  Point3 normal = Point3::Zero();
  for (const auto& [i, j, k] : mesh.facetPoints)
  {
    const Point3& a = mesh.points[i];
    const Point3& b = mesh.points[j];
    const Point3& c = mesh.points[k];
    if (const double squared = closestOnTriangle(place, a, b, c).squared; squared < least)
    {
      least = squared;
      normal = facetNormal(a, b, c);
    }
  }
  return normal;
}

/** Vertices of a thin band pushed through its other side; nothing else is wrong. */
struct PushedBand
{
  static constexpr double thickness = 0.02;
  SurfaceMesh mesh = thinBand(thickness);
  EmbeddedSurface surface = gaussMapOf(mesh, 0.02);
  RemeshResult result = remeshed(mesh, 0.02, 500, VertexPlacement::Fit);
  std::vector<Point3> sound = result.placement.positions;
  std::vector<char> fixed = std::vector<char>(sound.size(), 0);
  PlacementProblem problem{ mesh, surface, result.sites, result.diagram, result.components,
    result.dual.triangles, fixed };
  NearbySurface near{ problem, RunControl() };
  std::vector<Triple> triangles = result.dual.triangles; ///< of the mesh that is repaired
  PlacedVertices placed = result.placement;

  PushedBand()
  {
    CHECK(crossingsOf(this->triangles, this->sound).empty());
    this->fixed[0] = 1;
    for (std::size_t v = 7; v < this->sound.size(); v += 20)
    {
      Point3& place = this->placed.positions[v];
      if (std::abs(place[2]) > 0.12)
      {
        continue; // at the rims
      }
      const Point3 outward = Point3(place[0], place[1], 0.0).normalized();
      const double side = outward.dot(nearestNormal(this->mesh, place)) > 0.0 ? 1.0 : -1.0;
      place -= 1.25 * side * thickness * outward;
    }
    CHECK(crossingsOf(this->triangles, this->placed.positions).size() > 20);
    CHECK(this->inverted().empty());
  }

  std::vector<Index> inverted() const
  {
    std::vector<Index> found;
    CHECK(InvertedSearch(this->near)
            .find(this->triangles, this->placed.positions, RunControl(), found)
            .ok());
    return found;
  }

  Offset partable() const
  {
    const CrossingSearch search(this->triangles, this->placed.positions, RunControl());
    CrossingSearch::Pairs pairs;
    CHECK(
      findPartable(this->problem, search, std::numeric_limits<Offset>::max(), RunControl(), pairs)
        .ok());
    return static_cast<Offset>(pairs.size());
  }

  double distance()
  {
    RemeshResult mended = this->result;
    mended.dual.triangles = this->triangles;
    mended.placement = this->placed;
    return rmsDistance(this->mesh, mended, 50);
  }

  Status repair()
  {
    std::vector<SurfaceLocation> locations = this->result.locations;
    return repairPlacedMesh(
      this->problem, VertexPlacement::Fit, RunControl(), locations, this->triangles, this->placed);
  }
};

}

#endif
