/**
 * @file PlacementProblem.h
 * @brief What all ways to place the vertices of the dual read.
 */
#ifndef remesh_PlacementProblem_h
#define remesh_PlacementProblem_h

#include "Delaunay/Collar.h"
#include "Delaunay/Components.h"
#include "Mesh/SurfaceMesh.h"
#include "Metric/MetricField.h"
#include "Placement/WholeSurface.h"
#include "Voronoi/Diagram.h"

namespace remesh
{
/** Vertices are the components of the cells. */
struct PlacementProblem
{
  const SurfaceMesh& mesh;
  const EmbeddedSurface& surface;
  const Sites& sites; ///< of the diagram
  const Diagram& diagram;
  const Components& components;
  const std::vector<Triple>& triangles; ///< of components
  const std::vector<char>& fixed;       ///< K, 1: a vertex that stays; or empty: none
  const std::vector<FeatureSegment>* featureEdges = nullptr; ///< edges that stay, if there are any
  const WholeSurface* whole = nullptr; ///< of `mesh`; nullptr: made by who needs it
  const MetricField* metric = nullptr; ///< of `mesh`, in which triangles are to be even; or none

  Index numberOfVertices() const { return this->components.count(); }
  bool isFixed(std::size_t vertex) const
  {
    return !this->fixed.empty() && this->fixed[vertex] != 0;
  }
  const Point3& facetPoint(Index facet, int k) const
  {
    return this->mesh.points[this->mesh.facetPoints[facet][k]];
  }
};

/** The triangles around each vertex. */
struct VertexStars
{
  std::vector<Offset> begins;   ///< K + 1, into `triangles`
  std::vector<Index> triangles; ///< ascending within a star

  /** O(K + T). */
  VertexStars(const std::vector<Triple>& corners, Index numberOfVertices)
    : begins(static_cast<std::size_t>(numberOfVertices) + 1, 0)
    , triangles(3 * corners.size())
  {
    for (const Triple& triangle : corners)
    {
      for (const Index vertex : triangle)
      {
        ++this->begins[static_cast<std::size_t>(vertex) + 1];
      }
    }
    for (std::size_t v = 1; v < this->begins.size(); ++v)
    {
      this->begins[v] += this->begins[v - 1];
    }
    std::vector<Offset> next(this->begins.begin(), this->begins.end() - 1);
    for (std::size_t t = 0; t < corners.size(); ++t)
    {
      for (const Index vertex : corners[t])
      {
        this->triangles[next[vertex]++] = static_cast<Index>(t);
      }
    }
  }

  Offset begin(Index vertex) const { return this->begins[vertex]; }
  Offset end(Index vertex) const { return this->begins[static_cast<std::size_t>(vertex) + 1]; }
};
}

#endif
