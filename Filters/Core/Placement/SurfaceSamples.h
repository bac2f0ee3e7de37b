/**
 * @file SurfaceSamples.h
 * @brief Weighted points of the input surface, cell by cell: what a mesh is fitted to.
 *
 * Each component of a cell is walked piece by piece. Large pieces are cut into parts of about equal
 * area; small ones share a sample, at the piece where their areas fill the measure. The weights of
 * a component's samples sum to its area, so that the samples weigh all of the surface alike.
 */
#ifndef remesh_SurfaceSamples_h
#define remesh_SurfaceSamples_h

#include "Mesh/FacetGeometry.h"
#include "Placement/PlacementProblem.h"
#include "Voronoi/VertexPlaces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace remesh
{
struct SurfaceSample
{
  Point3 point;
  Point3 normal; ///< unit, of its facet
  double weight; ///< area
  Index facet;
};

/** Visits the equal parts (k^2 triangles) of a triangle: their centroids, each of `area / k^2`. */
template <class Visit>
void visitParts(const std::array<Point3, 3>& corners, double area, int k, const Visit& visit)
{
  const auto& [a, b, c] = corners;
  if (k == 1) // most
  {
    visit(Point3((a + b + c) * (1.0 / 3.0)), area);
    return;
  }
  const double share = 1.0 / k;
  const Point3 u = share * (b - a);
  const Point3 v = share * (c - a);
  const double part = share * share * area;
  for (int i = 0; i < k; ++i)
  {
    for (int j = 0; i + j < k; ++j)
    {
      visit(Point3(a + (i + 1.0 / 3.0) * u + (j + 1.0 / 3.0) * v), part);
      if (i + j + 1 < k)
      {
        visit(Point3(a + (i + 2.0 / 3.0) * u + (j + 2.0 / 3.0) * v), part);
      }
    }
  }
}

/** The corners of a piece's facet. */
using FacetCorners = std::array<const Point3*, 3>;

/** The centre of a piece. */
inline Point3 centerOf(const PieceWeights& part, const FacetCorners& corners)
{
  return (part.weights[0] * *corners[0] + part.weights[1] * *corners[1] +
           part.weights[2] * *corners[2]) /
    part.fraction();
}

/** How finely a component is cut. */
struct SampleSize
{
  double area; ///< of a sample, about
  int most;    ///< parts along the side of a triangle
};

/**
 * Calls `visit(point, area)` for each part of a piece: the triangles of its fan are cut into about
 * equal ones of that size.
 */
template <class Visit>
void visitPiece(const VertexPlaces& places, Offset piece, const FacetCorners& corners,
  const SampleSize& size, const Visit& visit)
{
  PiecePlaces vertices(places, piece);
  const auto place = [&](Offset v)
  {
    const std::array<double, 3> b = vertices.at(v);
    return Point3(b[0] * *corners[0] + b[1] * *corners[1] + b[2] * *corners[2]);
  };
  const Offset begin = places.diagram.vertexBegin[piece];
  const Point3 first = place(begin);
  Point3 second = first;
  for (Offset v = begin + 1; v < places.diagram.vertexBegin[piece + 1]; ++v)
  {
    const Point3 third = place(v);
    if (v > begin + 1)
    {
      const double area = facetArea(first, second, third);
      const double parts = std::sqrt(area / size.area) + 0.5; // rounded
      visitParts({ first, second, third }, area,
        static_cast<int>(std::clamp(parts, 1.0, static_cast<double>(size.most))), visit);
    }
    second = third;
  }
}

/** A piece, and what its facet tells of its samples. */
struct MeasuredPiece
{
  Index piece;
  Index facet;
  FacetCorners corners;
  Point3 vector; ///< of the facet: its normal, as long as twice its area
  double length; ///< of that vector
  double area;   ///< of the piece

  MeasuredPiece(const PlacementProblem& problem, Index ofDiagram)
    : piece(ofDiagram)
    , facet(problem.diagram.facets[ofDiagram])
    , corners{ &problem.facetPoint(facet, 0), &problem.facetPoint(facet, 1),
      &problem.facetPoint(facet, 2) }
    , vector(doubleAreaVector(*corners[0], *corners[1], *corners[2]))
    , length(lengthOf(vector))
    , area(0.5 * problem.diagram.weights[piece].fraction() * length)
  {
  }

  Point3 normal() const
  {
    constexpr double shortest = 1e-145; // whose square is not 0
    return this->length > shortest
      ? Point3((1.0 / this->length) * this->vector)
      : facetNormal(*this->corners[0], *this->corners[1], *this->corners[2]);
  }
};

/** Calls `visit(const SurfaceSample&)` for each sample of a piece; they weigh `weight` in all. */
template <class Visit>
void visitSamples(const VertexPlaces& places, const MeasuredPiece& measured, double weight,
  const SampleSize& size, const Visit& visit)
{
  SurfaceSample sample;
  sample.facet = measured.facet;
  sample.normal = measured.normal();
  const auto visitPart = [&](const Point3& point, double share)
  {
    sample.point = point;
    sample.weight = share;
    visit(sample);
  };
  if (measured.area < 2.0 * size.area)
  {
    visitPart(centerOf(places.diagram.weights[measured.piece], measured.corners), weight);
    return;
  }
  double surplus = weight - measured.area; // goes to the first part
  visitPiece(places, measured.piece, measured.corners, size,
    [&](const Point3& point, double area)
    {
      visitPart(point, area + surplus);
      surplus = 0.0;
    });
}

/**
 * Calls `visit(const SurfaceSample&)` for each sample of a component, in a fixed order. O(pieces).
 *
 * @param samples of a component that is cut fine enough; others have about as many as pieces.
 */
template <class Visit>
void forEachSample(
  const PlacementProblem& problem, Index component, int samples, const Visit& visit)
{
  const VertexPlaces places{ problem.surface, problem.sites, problem.diagram };
  const Components& components = problem.components;
  const SampleSize size{ components.area[component] / samples, samples };
  const auto measured = [&](Offset p) { return MeasuredPiece(problem, components.pieces[p]); };
  const Offset begin = components.pieceBegin[component];
  Offset end = components.pieceBegin[component + 1];
  while (end > begin && !(measured(end - 1).area > 0.0))
  {
    --end;
  }
  double carried = 0.0; // area without a sample yet
  for (Offset p = begin; p < end; ++p)
  {
    const MeasuredPiece piece = measured(p);
    carried += piece.area > 0.0 ? piece.area : 0.0;
    if (piece.area > 0.0 && (carried >= size.area || p + 1 == end))
    {
      visitSamples(places, piece, carried, size, visit);
      carried = 0.0;
    }
  }
}
}

#endif
