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
  const Point3 u = (b - a) / k;
  const Point3 v = (c - a) / k;
  const double part = area / (static_cast<double>(k) * k);
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
  const auto areaOf = [&](Offset p)
  {
    const Offset piece = components.pieces[p];
    return diagram.integrals[piece].fraction() * facetArea(problem.mesh, diagram.facets[piece]);
  };
  const Offset begins = components.pieceBegin[component];
  Offset ends = components.pieceBegin[component + 1];
  while (ends > begins && !(areaOf(ends - 1) > 0.0))
  {
    --ends;
  }
  double carried = 0.0;
  SurfaceSample sample;
  sample.normal = Point3::Zero();
  for (Offset p = begins; p < ends; ++p)
  {
    const Offset piece = components.pieces[p];
    const PieceIntegral& integral = diagram.integrals[piece];
    const Index facet = diagram.facets[piece];
    const double area = areaOf(p);
    if (!(area > 0.0))
    {
      continue;
    }
    carried += area;
    if (carried < measure && p + 1 < ends)
    {
      continue;
    }
    const Point3* corners[3];
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = &problem.facetPoint(facet, k);
    }
    sample.facet = facet;
    sample.normal = facetNormal(*corners[0], *corners[1], *corners[2]);
    if (area < 2.0 * measure)
    {
      sample.point = (integral.weights[0] * *corners[0] + integral.weights[1] * *corners[1] +
                       integral.weights[2] * *corners[2]) /
        integral.fraction();
      sample.weight = carried;
      carried = 0.0;
      visit(sample);
      continue;
    }
    double surplus = carried - area; // of the pieces before; goes to the first part
    carried = 0.0;
    PiecePlaces vertices(places, piece);
    const auto place = [&](Offset v)
    {
      const std::array<double, 3> b = vertices.at(v);
      return Point3(b[0] * *corners[0] + b[1] * *corners[1] + b[2] * *corners[2]);
    };
    const Offset begin = diagram.vertexBegin[piece];
    const Point3 first = place(begin);
    for (Offset v = begin + 1; v + 1 < diagram.vertexBegin[piece + 1]; ++v)
    {
      const Point3 second = place(v);
      const Point3 third = place(v + 1);
      const double share = facetArea(first, second, third);
      const int parts =
        std::clamp(static_cast<int>(std::lround(std::sqrt(share / measure))), 1, samples);
      visitParts(first, second, third, share, parts,
        [&](const Point3& point, double weight)
        {
          sample.point = point;
          sample.weight = weight + surplus;
          surplus = 0.0;
          visit(sample);
        });
    }
  }
}
}

#endif
