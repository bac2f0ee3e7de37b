// Embedding/Wrinkles: what bends in all directions covers an area of normals, what bends along one
// direction does not.

#include "Embedding/Wrinkles.h"
#include "TestSupport.h"

#include <cmath>

using namespace remesh;

namespace
{
/** Normals of the unit square that lean along x and y in so many half waves each. */
std::vector<Point3> waveNormals(const SurfaceMesh& square, double lean, int alongX, int alongY)
{
  std::vector<Point3> normals;
  for (const Point3& p : square.points)
  {
    normals.push_back(Point3(
      lean * std::cos(alongX * test::pi * p[0]), lean * std::cos(alongY * test::pi * p[1]), 1.0)
                        .normalized());
  }
  return normals;
}

/** Normals of waves along a direction, however the triangles lie to it. */
std::vector<Point3> bendNormals(const SurfaceMesh& square, double x, double y)
{
  std::vector<Point3> normals;
  for (const Point3& p : square.points)
  {
    const double slope = std::cos(25.0 * (x * p[0] + y * p[1]));
    normals.push_back(Point3(slope * x, slope * y, 1.0).normalized());
  }
  return normals;
}

double shareOf(const SurfaceMesh& mesh, const std::vector<Point3>& normals,
  const std::vector<Point3>& smoothed, double s)
{
  return wrinkledShare(mesh, normals, smoothed, s, RunControl());
}
}

int TestWrinkles(int, char*[])
{
  constexpr double lean = 1e-3; // so small that normalising does not matter
  const SurfaceMesh square = test::meshOf(test::gridPatch(120, 120));
  const std::vector<Point3> flat(square.points.size(), Point3::UnitZ());
  for (const double s : { 0.3, 2.0 })
  {
    for (const auto& [x, y] : { std::pair(1, 1), std::pair(4, 3) })
    {
      // The integral of lean^2 k l |sin kx| |sin ly|; the square's area hardly grows.
      const double expected = s * s * lean * lean * 4.0 * x * y;
      const std::vector<Point3> wrinkled = waveNormals(square, lean, x, y);
      CHECK_NEAR(shareOf(square, wrinkled, flat, s), expected, 0.01 * expected);
      CHECK_NEAR(shareOf(square, flat, wrinkled, s), -expected, 0.01 * expected);
      CHECK_EQUAL(shareOf(square, wrinkled, wrinkled, s), 0.0);
    }
    for (const auto& [x, y] : { std::pair(1.0, 0.0), std::pair(0.6, 0.8), std::pair(0.9, 0.4) })
    {
      const std::vector<Point3> bent = bendNormals(square, x, y);
      CHECK(std::abs(shareOf(square, bent, flat, s)) < 1e-12 * s * s);
    }
  }
  // As a share of the area in R^6: where that is large, by normals that all lean, it is less.
  const std::vector<Point3> leaning = waveNormals(square, 0.5, 6, 0);
  const std::vector<Point3> both = waveNormals(square, 0.5, 6, 5);
  const double small = shareOf(square, both, leaning, 0.01) / 1e-4;
  const double large = shareOf(square, both, leaning, 1.0);
  CHECK(large < 0.5 * small);
  // The smoothed ones' area, not that of the others.
  CHECK_NEAR(shareOf(square, both, flat, 1.0), 4.0 * shareOf(square, both, flat, 0.5), 1e-9);
  return test::result();
}
