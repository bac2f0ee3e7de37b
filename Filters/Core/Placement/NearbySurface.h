/**
 * @file NearbySurface.h
 * @brief The closest point of the surface among the facets of a few cells.
 */
#ifndef remesh_NearbySurface_h
#define remesh_NearbySurface_h

#include "Delaunay/SurfaceLocation.h"
#include "Placement/PlacementProblem.h"
#include "Support/RunControl.h"

namespace remesh
{
/**
 * Looks among the facets that the cells of given components meet: unlike a search over the whole
 * surface, never on another sheet. O(pieces of these cells), most of them rejected by one distance.
 */
class NearbySurface
{
public:
  explicit NearbySurface(const PlacementProblem& problem);

  /** The closest point; its facet is noIndex without pieces. */
  SurfaceLocation closest(const Index* begin, const Index* end, const Point3& point) const;

  /**
   * The cosine between the normals of a triangle and of the facet closest to its centroid, among
   * those of the cells of its three vertices. -1 without area.
   */
  double facingOf(const Triple& components, const std::array<Point3, 3>& corners) const;
  bool isFlipped(const Triple& components, const std::array<Point3, 3>& corners) const
  {
    return this->facingOf(components, corners) < 0.0;
  }

private:
  const PlacementProblem& m_problem;
  std::vector<double> m_reach; ///< F, the largest distance from a facet's first point to another
};
}

#endif
