/**
 * @file NormalVariation.h
 * @brief Splits facets that are too large for their normals in R^6, and finds the normals inside.
 *
 * The Gauss map is linear on each facet, from one mean normal at each corner. That is what the
 * surface is like where facets are small against the cells. But a large facet is flat, or has the
 * normals that the caller gave it, up to its rims: those of a cone that is a fan of long triangles
 * turn at its tip, and not all the way from the base.
 */
#ifndef remesh_NormalVariation_h
#define remesh_NormalVariation_h

#include "Mesh/Normals.h"
#include "Refinement/Refinement.h"

namespace remesh
{
/** The normals that each facet has of its own at its corners, whatever is beyond its sides. */
class OwnNormals
{
public:
  /**
   * Those of the facets' planes, or those that they borrow; with `given` ones (P, of the caller's
   * points) these, but where a crease cuts through the point.
   *
   * @param normals C, of the corners. All must outlive it.
   */
  OwnNormals(const SurfaceMesh& mesh, const std::vector<FacetNormal>& borrowed,
    const std::vector<Point3>& normals, const std::vector<Point3>* given);

  bool areGiven() const { return m_given != nullptr; }
  const SurfaceMesh& mesh() const { return m_mesh; }
  const std::vector<Point3>& cornerNormals() const { return m_normals; }

  /** Unit vectors. */
  std::array<Point3, 3> of(Index facet) const;

private:
  const SurfaceMesh& m_mesh;
  const std::vector<FacetNormal>& m_borrowed;
  const std::vector<Point3>& m_normals;
  const std::vector<Point3>* m_given;
  std::vector<char> m_cutPoints; ///< V, where normals are given
};

/**
 * Splits facets that are long against the spacing of `sites` in R^6 and have other normals than
 * the linear map:
 * - edges whose middle has another one than the mean of their ends;
 * - the longest sides of facets that are wide, too, and have another one at a corner.
 *
 * The surface comes to have no more facets than twice what it has and four times the sites.
 *
 * @param own of the surface's facets.
 * @param s length given to a unit normal, in the unit of the points.
 * @param refined receives the surface, where any facet is split.
 * @param normals receives those of its corners then: of facets' planes, the means around each
 *        corner, weighted by angles; of given ones, what the facets around interpolate.
 * @return whether any facet is split. Otherwise that took O(F), and nothing is held.
 */
bool refineForNormals(const OwnNormals& own, const Features* features, double s, Offset sites,
  const RunControl& control, RefinedSurface& refined, std::vector<Point3>& normals);
}

#endif
