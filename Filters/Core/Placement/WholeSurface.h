/**
 * @file WholeSurface.h
 * @brief Which way the surface faces where it is closest, whatever part of it that is.
 */
#ifndef remesh_WholeSurface_h
#define remesh_WholeSurface_h

#include "Mesh/SurfaceMesh.h"
#include "Mesh/TriangleTree.h"
#include "Support/RunControl.h"

#include <limits>

namespace remesh
{
/** The mesh must outlive it. Cost: O(F), in parallel, and about 32 bytes a facet. */
class WholeSurface
{
public:
  explicit WholeSurface(const SurfaceMesh& mesh, const RunControl& control = RunControl());

  /**
   * The least cosine between a unit vector and the normals of the facets that hold the surface's
   * closest point to a place: several, if that is on an edge of theirs, where a judge may take any.
   * 1 without any.
   *
   * @param facet one that may be close: saves time.
   * @param within distance: if no facet is closer than this, up to rounding, 1 is returned.
   */
  double minCosine(const Point3& place, const Point3& vector, Index facet,
    double within = std::numeric_limits<double>::infinity()) const;

private:
  Triangles m_facets;
  TriangleTree m_tree;
  double m_rounding; ///< of distances, unit of the points
};
}

#endif
