/**
 * @file SurfaceLocation.h
 * @brief Where on the input surface each vertex of the dual belongs.
 */
#ifndef remesh_SurfaceLocation_h
#define remesh_SurfaceLocation_h

#include "Delaunay/Components.h"

namespace remesh
{
struct SurfaceLocation
{
  Index facet;
  double b[3]; ///< barycentric coordinates, >= 0, sum 1
};

/**
 * For each component, the point closest to its centroid among the facets that it meets: unlike a
 * search over the whole surface, never on another sheet. K locations. O(P).
 */
Status locateOnSurface(const SurfaceMesh& mesh, const Diagram& diagram,
  const Components& components, const RunControl& control, std::vector<SurfaceLocation>& locations);
}

#endif
