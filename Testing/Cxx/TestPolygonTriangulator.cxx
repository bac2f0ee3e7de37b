// Adaptors/PolygonTriangulator: polygons of every shape are cut into triangles of the same area.

#include "../Core/TestChecks.h"
#include "../Core/TestSurfaces.h"
#include "Adaptors/PolygonTriangulator.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numeric>

using namespace remesh;

namespace
{
using Cell = std::vector<vtkIdType>;
using Points = std::vector<Point3>;
using Triangles = PolygonTriangulator::Triangles;

const Points square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };

/** The triangles of a polygon that can be cut. */
Triangles cut(const Points& points, const Cell& cell)
{
  Triangles triangles;
  PolygonTriangulator triangulator(points);
  CHECK(triangulator.AppendTriangles(static_cast<vtkIdType>(cell.size()), cell.data(), triangles));
  return triangles;
}

/** The triangles of all points, in their order. */
Triangles cut(const Points& points)
{
  Cell cell(points.size());
  std::iota(cell.begin(), cell.end(), 0);
  return cut(points, cell);
}

/** Twice the sum of the triangles' area vectors, projected on z, and of their areas. */
std::array<double, 2> areasOf(const Points& points, const Triangles& triangles)
{
  std::array<double, 2> sums = { 0.0, 0.0 };
  for (const auto& [a, b, c] : triangles)
  {
    const Point3 normal = (points[b] - points[a]).cross(points[c] - points[a]);
    sums[0] += normal[2];
    sums[1] += normal.norm();
  }
  return sums;
}

void testQuadrilaterals()
{
  const Triangles along02 = { { 0, 1, 2 }, { 0, 2, 3 } };
  const Triangles along13 = { { 0, 1, 3 }, { 1, 2, 3 } };
  // A tie goes to the first point's diagonal; else the shorter one is cut.
  CHECK(cut(square) == along02);
  CHECK(cut({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 } }) == along13);
  CHECK(cut({ { 0, 0, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 1, 0 } }) == along13);
  CHECK(cut({ { 1, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 0, 0, 0 } }) == along02);
  // Concave at each corner in turn: the shorter diagonal lies outside.
  const Points arrow = { { 0, 0, 0 }, { 4, -1, 0 }, { 3, 0, 0 }, { 4, 1, 0 } };
  for (vtkIdType first = 0; first < 4; ++first)
  {
    const Cell turned = { first, (first + 1) % 4, (first + 2) % 4, (first + 3) % 4 };
    const std::array<double, 2> areas = areasOf(arrow, cut(arrow, turned));
    CHECK_NEAR(areas[0], 6.0, 1e-15);
    CHECK_NEAR(areas[1], 6.0, 1e-15); // no triangle outside
  }
  // A corner on a straight line: no triangle without area, though that diagonal is shorter.
  CHECK(cut({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 1, 5, 0 } }) == along13);
}

/** Convex ones and stars, of any size. */
void testLargePolygons()
{
  for (int n = 5; n < 40; n += 7)
  {
    Points convex;
    Points star;
    for (int i = 0; i < 2 * n; ++i)
    {
      const double angle = test::pi * i / n;
      const Point3 onCircle(std::cos(angle), std::sin(angle), 0.0);
      convex.push_back(onCircle);
      star.emplace_back(onCircle * (i % 2 == 0 ? 1.0 : 0.4));
    }
    const double full = 2.0 * n * std::sin(test::pi / n);
    const Triangles fromConvex = cut(convex);
    CHECK_EQUAL(fromConvex.size(), static_cast<std::size_t>(2 * n - 2));
    CHECK_NEAR(areasOf(convex, fromConvex)[0], full, 1e-13);
    for (const double scale : { 1.0, 1e-40, 1e-12, 1e-7, 1e40 })
    {
      Points scaled = star;
      for (Point3& point : scaled)
      {
        point *= scale;
      }
      const std::array<double, 2> areas = areasOf(scaled, cut(scaled));
      CHECK_NEAR(areas[0] / (scale * scale), 0.4 * full, 1e-13);
      CHECK_NEAR(areas[1] / (scale * scale), 0.4 * full, 1e-13); // no overlaps
    }
  }
}

/** Still n - 2 triangles, for the intake to count or to refuse. */
void testWithoutArea()
{
  const Points line = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 } };
  CHECK_EQUAL(cut(line).size(), std::size_t(3));
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, 1e300 })
  {
    Points points = line;
    points[2][1] = bad;
    CHECK_EQUAL(cut(points).size(), std::size_t(3));
    CHECK_EQUAL(cut(points, { 0, 1, 2, 3 }).size(), std::size_t(2));
  }
}

/** The corners of a regular polygon around a place; against the clock if the radius is positive. */
Points ring(int corners, double radius, const Point3& center)
{
  Points points;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = (radius > 0.0 ? 2.0 : -2.0) * test::pi * i / corners;
    points.push_back(center + std::abs(radius) * Point3(std::cos(angle), std::sin(angle), 0.0));
  }
  return points;
}

/** Goes over to `hole` from a corner of the loop, around it from its corner `start`, and back. */
void addHole(Points& loop, std::size_t corner, Points hole, int start)
{
  std::rotate(hole.begin(), hole.begin() + start, hole.end());
  hole.push_back(hole.front());
  hole.push_back(loop[corner]);
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(corner) + 1, hole.begin(), hole.end());
}

/** n - 2 triangles that sum to the polygon's area and face as it does, in any position and size. */
void checkCut(const Points& loop, const std::string& where)
{
  Point3 normal = Point3::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    normal += loop[i].cross(loop[(i + 1) % loop.size()]);
  }
  for (const double angle : { 0.0, 1.0 })
  {
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(angle, Point3(1, 2, 3).normalized()).toRotationMatrix();
    const Point3 shift = angle * Point3(9, -7, 5);
    for (const double scale : { 1.0, 1e-80, 1e80, -3.7e-7 })
    {
      Points points;
      for (const Point3& point : loop)
      {
        points.push_back(scale * Point3(turn * point + shift));
      }
      const Triangles triangles = cut(points);
      for (Point3& point : points)
      {
        point = turn.transpose() * point / scale;
      }
      const std::array<double, 2> areas = areasOf(points, triangles);
      const auto isGood = [&](bool good)
      { test::check(good, __FILE__, __LINE__, where + ", scale " + std::to_string(scale)); };
      isGood(triangles.size() == loop.size() - 2);
      isGood(std::abs(areas[0] - normal[2]) < 1e-12 * normal[2]);
      isGood(std::abs(areas[1] - normal[2]) < 1e-12 * normal[2]);
    }
  }
}

/** Polygons with holes, as loops with bridges that run twice. */
void testKeyholes()
{
  const Points large = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 0, 3, 0 } };
  const Points small = { { 1, 1, 0 }, { 1, 2, 0 }, { 2, 2, 0 }, { 2, 1, 0 } };
  for (int corner = 0; corner < 4; ++corner)
  {
    Points loop = large;
    const int nearest[4] = { 0, 3, 2, 1 };
    addHole(loop, corner, small, nearest[corner]);
    for (std::size_t first = 0; first < loop.size(); ++first)
    {
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
      checkCut(loop, "a square with a hole, from corner " + std::to_string(first));
    }
  }
  for (const int corners : { 3, 4, 7, 40 })
  {
    Points loop = ring(12, 2.0, Point3::Zero());
    addHole(loop, 6, ring(corners, -0.4, { -1, 0, 0 }), corners / 2);
    addHole(loop, 0, ring(corners, -0.4, { 1, 0, 0 }), 0);
    checkCut(loop, "two holes of " + std::to_string(corners) + " corners");
    // A third hole, on a bridge from the second one's.
    Points chain = ring(5, 4.0, Point3::Zero());
    addHole(chain, 0, ring(corners, -0.5, { 2, 0, 0 }), 0);
    const std::size_t last = corners % 2 == 0 ? 2 + corners / 2 : 0;
    if (last > 0)
    {
      addHole(chain, last - 1, ring(6, -0.5, { 0, 0, 0 }), 0);
    }
    checkCut(chain, "a chain of holes of " + std::to_string(corners) + " corners");
  }
}

/** A bridge with corners on it, in both directions, and a hole that touches the border. */
void testTouchingLoops()
{
  checkCut({ { 0, 0, 0 }, { 6, 0, 0 }, { 6, 6, 0 }, { 0, 6, 0 }, { 0, 0, 0 }, { 1, 1, 0 },
             { 2, 2, 0 }, { 2, 4, 0 }, { 4, 4, 0 }, { 4, 2, 0 }, { 2, 2, 0 }, { 1, 1, 0 } },
    "corners on a bridge");
  checkCut(
    { { 0, 0, 0 }, { 6, 0, 0 }, { 6, 6, 0 }, { 0, 6, 0 }, { 0, 0, 0 }, { 2, 4, 0 }, { 4, 2, 0 } },
    "a hole from a corner");
}

void testConcavePolygons()
{
  checkCut({ { 0, 0, 0 }, { 2, 0, 0 }, { 1, 0.2, 0 }, { 2, 2, 0 }, { 1, 1, 0 }, { 0, 2, 0 },
             { 0.4, 1, 0 } },
    "a concave polygon");
  // Where the shorter diagonal lies outside.
  checkCut({ { 0, 0, 0 }, { 4, -1, 0 }, { 3, 0, 0 }, { 4, 1, 0 } }, "an arrow");
  checkCut({ { 4, -1, 0 }, { 3, 0, 0 }, { 4, 1, 0 }, { 0, 0, 0 } }, "an arrow, turned");
  checkCut({ { 0, 0, 0 }, { 4, 1, 0 }, { 5, 5, 0 }, { 1, 0.5, 0 } }, "a concave quadrilateral");
}

/** What crosses itself cannot be cut, and is told; the next polygon is not affected. */
void testCrossingPolygons()
{
  const Points eight = { { 0, 0, 0 }, { 2, 2, 0 }, { 4, 0, 0 }, { 4, 2, 0 }, { 2, 0.5, 0 },
    { 0, 2, 0 } };
  const Cell crossing = { 1, 2, 3, 4, 5, 0 };
  const Cell triangle = { 0, 1, 5 };
  PolygonTriangulator triangulator(eight);
  Triangles triangles;
  CHECK(!triangulator.AppendTriangles(6, crossing.data(), triangles));
  CHECK(triangulator.AppendTriangles(3, triangle.data(), triangles));
  CHECK(
    triangles == Triangles({ { 1, 2, 3 }, { 1, 3, 4 }, { 1, 4, 5 }, { 1, 5, 0 }, { 0, 1, 5 } }));
}

void testRepeatedPoints()
{
  CHECK(cut(square, { 0, 0, 1, 2, 2, 0 }) == Triangles({ { 0, 1, 2 } }));
  CHECK_EQUAL(cut(square, { 3, 0, 1, 2, 3, 3 }).size(), std::size_t(2));
  CHECK(cut(square, { 0, 1 }) == Triangles({ { 0, 1, 1 } }));
  CHECK(cut(square, { 2, 2, 2, 2 }) == Triangles({ { 2, 2, 2 } }));
  CHECK(cut(square, {}).empty());
}
}

int TestPolygonTriangulator(int, char*[])
{
  testQuadrilaterals();
  testLargePolygons();
  testWithoutArea();
  testKeyholes();
  testTouchingLoops();
  testConcavePolygons();
  testCrossingPolygons();
  testRepeatedPoints();
  return test::result();
}
