#include "Mesh/ClosestPoint.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace remesh
{
namespace
{
constexpr double roundedShare = 1e-6; // of the products that it is the sum of: digits are lost
constexpr double minSine = 1e-8;      // of the angle at a corner: so are those of areas

ClosestPoint at(double u, double v, double w, const Point3& point, const Point3& a, const Point3& b,
  const Point3& c)
{
  return { { u, v, w }, (u * a + v * b + w * c - point).squaredNorm() };
}

/** The closest point of the three edges. */
ClosestPoint closestOnEdges(const Point3& point, const Point3& a, const Point3& b, const Point3& c)
{
  const auto share = [&point](const Point3& from, const Point3& to)
  {
    const Point3 along = to - from;
    const double squared = along.squaredNorm();
    return squared > 0.0 ? std::clamp(along.dot(point - from) / squared, 0.0, 1.0) : 0.0;
  };
  const double ab = share(a, b), bc = share(b, c), ca = share(c, a);
  const ClosestPoint found[] = { at(1.0 - ab, ab, 0.0, point, a, b, c),
    at(0.0, 1.0 - bc, bc, point, a, b, c), at(ca, 0.0, 1.0 - ca, point, a, b, c) };
  return *std::min_element(std::begin(found), std::end(found),
    [](const ClosestPoint& one, const ClosestPoint& other) { return one.squared < other.squared; });
}

/**
 * Where the weights of the inside, squares of areas, are lost in rounding: by the areas themselves.
 */
ClosestPoint closestOnNeedle(const Point3& point, const Point3& a, const Point3& b, const Point3& c)
{
  const Point3 normal = (b - a).cross(c - a);
  const double squared = normal.squaredNorm();
  const Point3 toA = a - point, toB = b - point, toC = c - point;
  const double wa = normal.dot(toB.cross(toC)) / squared;
  const double wb = normal.dot(toC.cross(toA)) / squared;
  const double wc = normal.dot(toA.cross(toB)) / squared;
  const double sum = wa + wb + wc;
  const bool isInside = std::min({ wa, wb, wc }) > 0.0 &&
    squared > minSine * minSine * (b - a).squaredNorm() * (c - a).squaredNorm();
  return isInside ? at(wa / sum, wb / sum, wc / sum, point, a, b, c)
                  : closestOnEdges(point, a, b, c);
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
  const double products = std::abs(d1 * d4) + std::abs(d3 * d2) + std::abs(d5 * d2) +
    std::abs(d1 * d6) + std::abs(d3 * d6) + std::abs(d5 * d4);
  if (!(std::min({ wa, wb, wc }) > 0.0 && sum > roundedShare * products))
  {
    return closestOnNeedle(point, a, b, c);
  }
  return at(wa / sum, wb / sum, wc / sum, point, a, b, c);
}
}
