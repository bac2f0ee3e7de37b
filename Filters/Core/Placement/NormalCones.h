/**
 * @file NormalCones.h
 * @brief For each cell a cone that the normals of all its facets lie in.
 */
#ifndef remesh_NormalCones_h
#define remesh_NormalCones_h

#include "Placement/PlacementProblem.h"
#include "Support/RunControl.h"

namespace remesh
{
/**
 * Tells of most triangles at once that they face as the surface does, whichever facet is closest:
 * a pass over the pieces of all cells, instead of one over those around each triangle.
 */
class NormalCones
{
public:
  /** O(pieces), parallel; 32 bytes for each component. When cancelled, the cones are of no use. */
  NormalCones(const PlacementProblem& problem, const RunControl& control);

  /**
   * True only if a unit normal makes less than 90 degrees with those of all facets that the cell of
   * a component meets. False where the cell is without facets, or one of them has no normal.
   */
  bool allAlong(Index component, const Point3& normal) const
  {
    return normal.dot(m_cones[component].axis) > m_cones[component].least;
  }

private:
  struct Cone
  {
    Point3 axis;  ///< unit
    double least; ///< cosine to the axis of what is along all normals; infinite: none is
  };
  std::vector<Cone> m_cones;
};
}

#endif
