/**
 * @file ClosestPoint.h
 * @brief The point of a triangle closest to a point of R^3.
 */
#ifndef remesh_ClosestPoint_h
#define remesh_ClosestPoint_h

#include "Support/Types.h"

namespace remesh
{
struct ClosestPoint
{
  double b[3];    ///< barycentric coordinates, all from 0 to 1
  double squared; ///< squared distance
};

/**
 * Regions of the triangle's corners and edges first, then its inside (C. Ericson, "Real-Time
 * Collision Detection", 2005, section 5.1.5). Needs three different corners. Where a triangle is so
 * narrow that rounding hides its inside, a point of its edges.
 */
ClosestPoint closestOnTriangle(
  const Point3& point, const Point3& a, const Point3& b, const Point3& c);
}

#endif
