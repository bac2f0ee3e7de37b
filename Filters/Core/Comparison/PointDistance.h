/**
 * @file PointDistance.h
 * @brief The distances of points from a surface, and on which side of it they are.
 */
#ifndef remesh_PointDistance_h
#define remesh_PointDistance_h

#include "Mesh/TriangleTree.h"
#include "Support/Status.h"

#include <vector>

namespace remesh
{
/**
 * Normals that tell the side of a point by the dot product with the way to it, wherever on a
 * closed, oriented surface the closest place is: of a triangle, the normal; of an edge, the sum of
 * the normals around; of a point, their sum weighted by the angles there (J. Baerentzen, H. Aanaes,
 * "Signed distance computation using the angle weighted pseudonormal", 2005). At a border the same
 * sums give the side of the surface that the closest place faces.
 */
class SideNormals
{
public:
  /**
   * @param surface oriented; points with equal coordinates must be one point.
   * @param control asked for cancellation; the result of a cancelled run is of no use.
   * Cost: O(T).
   */
  explicit SideNormals(const Triangles& surface, const RunControl& control = RunControl());

  /** Whether the point is behind the surface (against its normals), as seen from the place. */
  bool isBehind(
    const Point3& point, const TriangleTree& tree, const TriangleTree::Place& place) const;

private:
  std::vector<Triple> m_triangles;     ///< T x 3, points
  std::vector<Triple> m_triangleEdges; ///< T x 3
  std::vector<Point3> m_edgeNormals;   ///< E, any length
  std::vector<Point3> m_pointNormals;  ///< P, any length
};

/** Of points (P) to a surface, in the unit of the points. */
struct PointDistances
{
  std::vector<double> distances; ///< P; NaN for points that are not finite, or too far away
  std::vector<char> behind;      ///< P, 1: behind the surface; empty if that has no sides
};

/**
 * The distance of each point to a surface; a point is too far away where its square is not finite.
 *
 * @param surface not empty.
 * @param sides of the surface, or nullptr: it has none.
 * Cost: a search in the tree for each, in parallel. Deterministic.
 */
Status measurePointDistances(const std::vector<Point3>& points, const TriangleTree& surface,
  const SideNormals* sides, const RunControl& control, PointDistances& result);
}

#endif
