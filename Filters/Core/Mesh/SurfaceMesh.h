/**
 * @file SurfaceMesh.h
 * @brief The surface after intake: an indexed triangle mesh that every later stage reads.
 *
 * Two index spaces, kept apart from the start: *points* carry the topology (two facets that share
 * two points share an edge), *corners* carry the embedding (a point on a crease has one corner per
 * smooth fan). Without creases the two coincide.
 */
#ifndef remesh_SurfaceMesh_h
#define remesh_SurfaceMesh_h

#include "Mesh/InputPoints.h"

#include <vector>

namespace remesh
{
/** What the adaptors hand over: triangles as they stand in the caller's data. */
struct TriangleSoup
{
  std::vector<Point3> points;                   ///< P, in R^3, the caller's point ids
  std::vector<std::array<Offset, 3>> triangles; ///< T x 3, ids into `points`
  std::vector<Offset> inputCells;               ///< T, the caller's cell that a triangle came from
};

struct SurfaceMesh
{
  std::vector<Point3> points;       ///< V, in R^3, only points that facets use
  SharedArray<Triple> facetPoints;  ///< F x 3, ids into `points`
  SharedArray<Triple> facetCorners; ///< F x 3, ids of embedded corners; the same array as a rule
  std::vector<Index> cornerPoints;  ///< C, the point of each corner

  std::vector<Offset> facetInputCells; ///< F, the caller's cell ids
  InputPoints facetInputPoints;        ///< F x 3, the caller's point ids

  Index numberOfPoints() const { return static_cast<Index>(this->points.size()); }
  Index numberOfFacets() const { return static_cast<Index>(this->facetPoints.size()); }
  Index numberOfCorners() const { return static_cast<Index>(this->cornerPoints.size()); }
};
}

#endif
