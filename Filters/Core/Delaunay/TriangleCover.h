/**
 * @file TriangleCover.h
 * @brief Which facets of the surface a triangle of the mesh stands for, and how much of each.
 */
#ifndef remesh_TriangleCover_h
#define remesh_TriangleCover_h

#include "Delaunay/Components.h"
#include "Voronoi/VertexPlaces.h"

namespace remesh
{
/** A part of a facet; the unit of the area is that of its triangle's others, and no more. */
struct CoverPart
{
  Index facet;
  double area; ///< >= 0
};

/**
 * The pieces of the triangle's three cells, projected along its normal and clipped to it. So what
 * lies under the triangle counts, and not what else its cells reach: along the border of a region
 * the triangles follow the border, and a strip as wide as a triangle is not lost. Where nothing of
 * the three cells that faces the same way lies under it (a flipped or degenerate triangle), the
 * whole pieces count.
 */
struct TriangleCover
{
  const SurfaceMesh& mesh;
  const Components& components;
  const VertexPlaces places;

  /** Calls `visit(piece)` for the pieces of the three components. */
  template <class Visit>
  void forEachPiece(const Triple& triangle, const Visit& visit) const
  {
    for (const Index component : triangle)
    {
      for (Offset p = this->components.pieceBegin[component];
           p < this->components.pieceBegin[component + 1]; ++p)
      {
        visit(this->components.pieces[p]);
      }
    }
  }

  /**
   * The parts under a triangle of these components with these corners in R^3, piece by piece: a
   * facet comes as often as its cells do. O(vertices of the pieces).
   */
  void measure(const Triple& triangle, const std::array<Point3, 3>& corners,
    std::vector<CoverPart>& parts) const;
};
}

#endif
