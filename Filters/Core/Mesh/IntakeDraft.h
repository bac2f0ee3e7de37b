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
/** The surface between soup and mesh. */
struct Draft
{
  std::vector<Offset> inputPoints;       ///< U, the caller's ids of the used points, ascending
  std::vector<Point3> points;            ///< U
  std::vector<Triple> facets;            ///< F x 3, into `points`
  std::vector<Index> facetTriangles;     ///< F, into the soup's triangles
  std::vector<unsigned char> facetTurns; ///< F, the corner of the triangle that comes first
  /** F x 3, the caller's points, if facets were split (CapSplit.h); else empty: the triangles'. */
  std::vector<std::array<Offset, 3>> facetInputs;

  /** The caller's points at the corners of a facet. */
  std::array<Offset, 3> inputsOf(const TriangleSoup& soup, Offset facet) const
  {
    if (!this->facetInputs.empty())
    {
      return this->facetInputs[facet];
    }
    const auto& ids = soup.triangles[this->facetTriangles[facet]];
    const int first = this->facetTurns[facet];
    return { ids[first], ids[(first + 1) % 3], ids[(first + 2) % 3] };
  }
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
 * Coordinates below 1e-14 of the bounding box's diagonal, and 1e-6 of the facets there, are 0: what
 * a source computes as the sine of a half turn, say, depends on the part that it computes.
 *
 * @return what buildSurfaceMesh says of unusable input, or Cancelled.
 */
Status draftSoup(const TriangleSoup& soup, const RunControl& control, Draft& draft);
}

#endif
