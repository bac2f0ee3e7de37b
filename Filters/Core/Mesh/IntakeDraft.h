/**
 * @file IntakeDraft.h
 * @brief The surface between soup and mesh; the first step of Intake.cxx.
 */
#ifndef remesh_IntakeDraft_h
#define remesh_IntakeDraft_h

#include "Mesh/Intake.h"

#include <sstream>

namespace remesh
{
/** The surface between soup and mesh, in the order of the soup. */
struct Draft
{
  std::vector<Offset> inputPoints;   ///< U, the caller's ids of the used points, ascending
  std::vector<Point3> points;        ///< U
  std::vector<Triple> facets;        ///< F x 3, into `points`
  std::vector<Index> facetTriangles; ///< F, into the soup's triangles
  /** F x 3, the caller's points, if facets were split (CapSplit.h); else empty: the triangles'. */
  std::vector<std::array<Offset, 3>> facetInputs;
};

template <class... Parts>
std::string sentence(const Parts&... parts)
{
  std::ostringstream stream;
  (stream << ... << parts);
  return stream.str();
}

/**
 * Checks the sizes, ids and coordinates of a soup and takes over its triangles and used points.
 *
 * @return what buildSurfaceMesh says of unusable input, or Cancelled.
 */
Status draftSoup(const TriangleSoup& soup, const RunControl& control, Draft& draft);
}

#endif
