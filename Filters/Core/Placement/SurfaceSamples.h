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
void visitParts(
  const Point3& a, const Point3& b, const Point3& c, double area, int k, const Visit& visit)
{
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
inline Point3 centerOf(const PieceIntegral& integral, const FacetCorners& corners)
{
  return (integral.weights[0] * *corners[0] + integral.weights[1] * *corners[1] +
           integral.weights[2] * *corners[2]) /
    integral.fraction();
}

/**
 * Calls `visit(point, area)` for each part of a piece: the triangles of its fan are cut into about
 * equal ones, of the area `measure`, if that takes no more than `most` to a side.
 */
template <class Visit>
void visitPiece(const VertexPlaces& places, Offset piece, const FacetCorners& corners,
  double measure, int most, const Visit& visit)
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
      const double parts = std::sqrt(area / measure) + 0.5; // rounded
      visitParts(first, second, third, area,
        static_cast<int>(std::clamp(parts, 1.0, static_cast<double>(most))), visit);
    }
    second = third;
  }
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
  const Diagram& diagram = problem.diagram;
  const VertexPlaces places{ problem.surface, problem.sites, diagram };
  const Components& components = problem.components;
  const double measure = components.area[component] / samples;
  Point3 vector; // of the last facet asked for
  double length = 0.0;
  const auto areaOf = [&](Offset p)
  {
    const Offset piece = components.pieces[p];
    const auto& [a, b, c] = problem.mesh.facetPoints[diagram.facets[piece]];
    vector =
      doubleAreaVector(problem.mesh.points[a], problem.mesh.points[b], problem.mesh.points[c]);
    length = lengthOf(vector);
    return 0.5 * diagram.integrals[piece].fraction() * length;
  };
  const Offset begins = components.pieceBegin[component];
  Offset ends = components.pieceBegin[component + 1];
  while (ends > begins && !(areaOf(ends - 1) > 0.0))
  {
    --ends;
  }
  double carried = 0.0;
  for (Offset p = begins; p < ends; ++p)
  {
    const double area = areaOf(p);
    carried += area > 0.0 ? area : 0.0;
    if (!(area > 0.0) || (carried < measure && p + 1 < ends))
    {
      continue;
    }
    const Offset piece = components.pieces[p];
    const Index facet = diagram.facets[piece];
    const FacetCorners corners{ &problem.facetPoint(facet, 0), &problem.facetPoint(facet, 1),
      &problem.facetPoint(facet, 2) };
    SurfaceSample sample;
    sample.facet = facet;
    constexpr double shortest = 1e-145; // whose square is not 0
    sample.normal = length > shortest ? Point3((1.0 / length) * vector)
                                      : facetNormal(*corners[0], *corners[1], *corners[2]);
    const auto visitPart = [&](const Point3& point, double weight)
    {
      sample.point = point;
      sample.weight = weight;
      visit(sample);
    };
    if (area < 2.0 * measure)
    {
      visitPart(centerOf(diagram.integrals[piece], corners), carried);
    }
    else
    {
      double surplus = carried - area; // of the pieces before; goes to the first part
      visitPiece(places, piece, corners, measure, samples,
        [&](const Point3& point, double weight)
        {
          visitPart(point, weight + surplus);
          surplus = 0.0;
        });
    }
    carried = 0.0;
  }
}
}

#endif
