#include "Mesh/ClosestPoint.h"

#include <algorithm>

namespace remesh
{
namespace
{
ClosestPoint at(double u, double v, double w, const Point3& point, const Point3& a, const Point3& b,
  const Point3& c)
{
  return { { u, v, w }, (u * a + v * b + w * c - point).squaredNorm() };
}
}

ClosestPoint closestOnTriangle(
  const Point3& point, const Point3& a, const Point3& b, const Point3& c)
{
  const Point3 ab = b - a;
  const Point3 ac = c - a;
  const double d1 = ab.dot(point - a), d2 = ac.dot(point - a);
  const double d3 = ab.dot(point - b), d4 = ac.dot(point - b);
  const double d5 = ab.dot(point - c), d6 = ac.dot(point - c);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return at(1.0, 0.0, 0.0, point, a, b, c);
  }
  if (d3 >= 0.0 && d4 <= d3)
  {
    return at(0.0, 1.0, 0.0, point, a, b, c);
  }
  if (d6 >= 0.0 && d5 <= d6)
  {
    return at(0.0, 0.0, 1.0, point, a, b, c);
  }
  const double wc = d1 * d4 - d3 * d2;
  if (wc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    const double t = d1 / (d1 - d3);
    return at(1.0 - t, t, 0.0, point, a, b, c);
  }
  const double wb = d5 * d2 - d1 * d6;
  if (wb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    const double t = d2 / (d2 - d6);
    return at(1.0 - t, 0.0, t, point, a, b, c);
  }
  const double wa = d3 * d6 - d5 * d4;
  if (wa <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
  {
    const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return at(0.0, 1.0 - t, t, point, a, b, c);
  }
  const double sum = wa + wb + wc;
  return at(wa / sum, wb / sum, wc / sum, point, a, b, c);
}
}
