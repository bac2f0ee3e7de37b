/**
 * @file PolygonTriangulator.h
 * @brief The triangles of one polygon, of any number of points, convex or not.
 */
#ifndef remesh_PolygonTriangulator_h
#define remesh_PolygonTriangulator_h

#include "Support/Types.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <array>
#include <vector>

class vtkIdList;
class vtkPolygon;

namespace remesh
{
/**
 * Cuts polygons one after the other, in memory that it keeps from one to the next.
 *
 * - A quadrilateral is cut along its shorter diagonal (a tie: the one of its first point), unless
 *   that diagonal lies outside or on the border (the two triangles oppose each other, or one has
 *   no area) and the other does not.
 * - Larger polygons are cut by vtkPolygon, or by clipEars where vtkPolygon gives up, as it does
 *   on holes with bridges to them. One that crosses itself so that neither cuts it becomes a fan.
 * - Repeated consecutive points of a polygon count once. A polygon that has one or two points left
 *   becomes one degenerate triangle; one without points none.
 */
class PolygonTriangulator
{
public:
  using Triangles = std::vector<std::array<Offset, 3>>;

  /** @param points of all polygons, in R^3, at any scale; must outlive it. */
  explicit PolygonTriangulator(const std::vector<Point3>& points);
  ~PolygonTriangulator();

  /**
   * Appends the triangles of one polygon, which turn as it does: n - 2 for n >= 3 points that
   * count, be they finite or not, and whatever their shape.
   *
   * @param ids of the polygon's points, all in the range of the points.
   * @return false for triangles that overlap: a fan, as the polygon has five points or more and an
   *         area, but crosses itself so that it cannot be cut.
   * Cost: O(n) up to four points that count; else about O(n^2).
   */
  bool AppendTriangles(vtkIdType size, const vtkIdType* ids, Triangles& triangles);

private:
  void TakeLoop(vtkIdType size, const vtkIdType* ids);
  bool ScaleLoop();
  bool CutsInside(int corner) const;
  bool TriangulateLoop();
  bool HasArea() const;

  void AppendQuadrilateral(Triangles& triangles);
  bool AppendLargePolygon(Triangles& triangles);
  void AppendFan(Triangles& triangles) const;

  const std::vector<Point3>& Points;
  std::vector<Offset> Loop;   ///< the polygon's points, without consecutive repetitions
  std::vector<Point3> Scaled; ///< where these are, at a size of about 1
  Triangles Corners;          ///< the loop's triangles, by places in the loop
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> PolygonIds;
};
}

#endif
