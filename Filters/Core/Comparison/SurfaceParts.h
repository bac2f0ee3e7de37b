/**
 * @file SurfaceParts.h
 * @brief Parts of a triangle, cut where the closest triangles of another surface meet.
 */
#ifndef remesh_SurfaceParts_h
#define remesh_SurfaceParts_h

#include "Mesh/TriangleTree.h"

#include <array>
#include <vector>

namespace remesh
{
struct SurfacePart
{
  std::array<Point3, 3> corners;
  Index hint = noIndex;  ///< slot of a triangle that may be close
  bool isInside = false; ///< of a side of the hinted triangle, along which it was cut

  Point3 centroid() const;
  double reach() const; ///< from the centroid
};

/**
 * Cuts parts; one per thread. The pieces, four at most but for slices, lie in the part and cover it
 * wholly, but for rounding. O(1) each.
 */
class PartCutter
{
public:
  /**
   * @param to must outlive it.
   * @param accuracy of distances, at least 0: parts reach a hundredth of it beyond the sides that
   *        they are cut along, so that corners on a side leave no slivers.
   */
  PartCutter(const TriangleTree& to, double accuracy);

  /**
   * Cuts a part along that side of the prism over a triangle which it sticks out from most: what is
   * inside has one side less to stick out from. Flat regions so soon lie within one triangle each.
   * False, and nothing appended, for parts that are much larger than the triangle, lean against it,
   * or do not stick out.
   *
   * @param slot a triangle of the tree.
   * @param parts those it is cut into are appended.
   */
  bool cutAlong(Index slot, const SurfacePart& part, std::vector<SurfacePart>& parts);

  /**
   * Cuts a thin part that is much longer than a triangle into slices of the triangle's size, at
   * once. By halves it would be many more: of a thin triangle that is cut in the middle, three are
   * left. False, and nothing appended, for other parts, and if there may be few pieces only.
   * O(number of slices).
   *
   * @param maxPieces so many at most; the slices are longer then.
   */
  bool cutAcross(
    Index slot, const SurfacePart& part, Offset maxPieces, std::vector<SurfacePart>& parts);

  /** Along the triangle, or else into four. */
  void cut(Index slot, const SurfacePart& part, std::vector<SurfacePart>& parts);

private:
  bool cutByPlane(Index slot, const SurfacePart& part, const Point3& origin, const Point3& inwards,
    std::vector<SurfacePart>& parts);

  const TriangleTree& m_to;
  double m_overlap;
  std::vector<Point3> m_inner; // polygons
  std::vector<Point3> m_outer;
};
}

#endif
