// Mesh/ClosestPoint: against the closest of many places of a triangle, also where it is a needle.

#include "Mesh/ClosestPoint.h"
#include "Mesh/FacetGeometry.h"
#include "Support/Random.h"
#include "TestSupport.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace remesh;

namespace
{
Point3 drawn(std::uint64_t seed, std::uint64_t index, double reach)
{
  const auto draw = [&](std::uint64_t k)
  { return reach * (2.0 * uniform01(seed, index, k) - 1.0); };
  return { draw(0), draw(1), draw(2) };
}

void checkWeights(const ClosestPoint& found)
{
  for (const double weight : found.b)
  {
    CHECK(weight >= 0.0 && weight <= 1.0);
  }
  CHECK_NEAR(found.b[0] + found.b[1] + found.b[2], 1.0, 1e-14);
}

/** No place of a grid over the triangle is closer, and one is nearly as close. */
void testTriangles()
{
  constexpr int n = 40;
  for (std::uint64_t k = 0; k < 300; ++k)
  {
    const Point3 a = drawn(1, k, 1.0), b = drawn(2, k, 1.0), c = drawn(3, k, 1.0);
    const Point3 point = drawn(4, k, k % 3 == 0 ? 100.0 : 1.5);
    const ClosestPoint found = closestOnTriangle(point, a, b, c);
    checkWeights(found);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; i + j <= n; ++j)
      {
        const Point3 place = (i * a + j * b + (n - i - j) * c) / n;
        least = std::min(least, (place - point).norm());
      }
    }
    CHECK(std::sqrt(found.squared) <= least + 1e-12);
    CHECK(std::sqrt(found.squared) >= least - 3.0 / n);
  }
}

/** As far as the longest edge, up to the height. */
void testNeedles()
{
  for (std::uint64_t k = 0; k < 20000; ++k)
  {
    const double height = std::pow(10.0, -6.0 - 10.0 * uniform01(5, k, 0));
    const Point3 a = drawn(6, k, 1.0), b = drawn(7, k, 1.0);
    const double share = uniform01(8, k, 0);
    const Point3 c = (1.0 - share) * a + share * b + height * drawn(9, k, 1.0);
    const Point3 point =
      k % 2 ? drawn(10, k, 2.0) : Point3(0.5 * (a + c) + 3.0 * height * drawn(11, k, 1.0));
    const ClosestPoint found = closestOnTriangle(point, a, b, c);
    checkWeights(found);
    const Point3 along = b - a;
    const double t = std::clamp(along.dot(point - a) / along.squaredNorm(), 0.0, 1.0);
    const double toEdge = (a + t * along - point).norm();
    CHECK_NEAR(std::sqrt(found.squared), toEdge, 2.0 * height + 1e-7);
  }
}
}

int TestClosestPoint(int, char*[])
{
  testTriangles();
  testNeedles();
  return test::result();
}
