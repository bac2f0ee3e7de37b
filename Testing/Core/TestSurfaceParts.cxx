// Comparison/SurfaceParts: pieces lie in their part, cover it, and are inside of a side.

#include "Comparison/SurfaceParts.h"
#include "Support/Random.h"
#include "TestTriangles.h"

#include <Eigen/Geometry>

using namespace remesh;
using namespace remesh::test;

namespace
{
Point3 randomPoint(std::uint64_t item, std::uint64_t k, double height)
{
  return { uniform01(5, item, 3 * k), uniform01(5, item, 3 * k + 1),
    height * uniform01(5, item, 3 * k + 2) };
}

double areaOf(const std::array<Point3, 3>& t)
{
  return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
}

/** By how far a point sticks out of a triangle in its plane. */
double outside(const Point3& p, const std::array<Point3, 3>& t)
{
  const Point3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  double most = std::abs((p - t[0]).dot(normal));
  for (int k = 0; k < 3; ++k)
  {
    const Point3 side = normal.cross(t[(k + 1) % 3] - t[k]).normalized();
    most = std::max(most, (t[k] - p).dot(side));
  }
  return most;
}

/** As many sides of the prism over a triangle as no corner of a part is beyond. */
int sidesAround(const SurfacePart& part, const std::array<Point3, 3>& t, double accuracy)
{
  const Point3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  int sides = 0;
  for (int k = 0; k < 3; ++k)
  {
    const Point3 inwards = normal.cross(t[(k + 1) % 3] - t[k]).normalized();
    double lowest = 0.0;
    for (const Point3& corner : part.corners)
    {
      lowest = std::min(lowest, (corner - t[k]).dot(inwards));
    }
    sides += lowest > -0.012 * accuracy;
  }
  return sides;
}

void testPieces()
{
  constexpr double accuracy = 1e-3;
  int alongSides = 0;
  for (std::uint64_t item = 0; item < 2000; ++item)
  {
    TriangleSoup soup;
    for (std::uint64_t k = 0; k < 3; ++k)
    {
      soup.points.push_back(randomPoint(item, k, 0.1));
    }
    soup.triangles.push_back({ 0, 1, 2 });
    const Surface surface(soup);
    const TriangleTree tree(surface.view());
    PartCutter cutter(tree, item % 5 == 0 ? 0.0 : accuracy);
    SurfacePart part;
    for (std::uint64_t k = 0; k < 3; ++k)
    {
      part.corners[k] = randomPoint(item, 3 + k, 0.2);
    }
    std::vector<SurfacePart> pieces;
    const bool isAlong = cutter.cutAlong(0, part, pieces);
    CHECK_EQUAL(isAlong, !pieces.empty());
    alongSides += isAlong;
    if (!isAlong)
    {
      cutter.cut(0, part, pieces);
      CHECK_EQUAL(pieces.size(), std::size_t(4));
    }
    CHECK(pieces.size() <= 4);
    double area = 0.0;
    for (const SurfacePart& piece : pieces)
    {
      area += areaOf(piece.corners);
      CHECK_EQUAL(piece.hint, 0);
      for (const Point3& corner : piece.corners)
      {
        CHECK(outside(corner, part.corners) < 1e-9);
      }
      CHECK(!piece.isInside ||
        sidesAround(piece, tree.cornersOf(0), accuracy) >
          std::min(2, sidesAround(part, tree.cornersOf(0), accuracy)));
    }
    CHECK_NEAR(area, areaOf(part.corners), 1e-9);
  }
  CHECK(alongSides > 500);
}

/** Needles and caps: slices of the triangle's size cover them; there are few. */
void testSlices()
{
  TriangleSoup soup;
  soup.points = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } };
  soup.triangles.push_back({ 0, 1, 2 });
  const Surface surface(soup);
  const TriangleTree tree(surface.view());
  const double size = std::sqrt(2.0);
  PartCutter cutter(tree, 1e-3);
  for (const double foot : { 0.0, 0.3, 0.99, 1.0, 1.2 })
  {
    constexpr double length = 500.0;
    const SurfacePart part{ { Point3(0.0, 0.0, 0.1), Point3(length, 0.0, 0.1),
      Point3(foot * length, 0.02, 0.1) } };
    std::vector<SurfacePart> pieces;
    CHECK(cutter.cutAcross(0, part, 10000, pieces));
    CHECK(static_cast<double>(pieces.size()) < 2.0 * 1.2 * length / size + 4.0);
    double area = 0.0;
    for (const SurfacePart& piece : pieces)
    {
      area += areaOf(piece.corners);
      CHECK_EQUAL(piece.hint, 0);
      CHECK(piece.reach() < 1.1 * size);
      for (const Point3& corner : piece.corners)
      {
        CHECK(outside(corner, part.corners) < 1e-9);
      }
    }
    CHECK_NEAR(area, areaOf(part.corners), 1e-9);
    pieces.clear();
    CHECK(cutter.cutAcross(0, part, 50, pieces));
    CHECK(pieces.size() > 30 && pieces.size() <= 50);
    CHECK(!cutter.cutAcross(0, part, 4, pieces));
  }
  std::vector<SurfacePart> pieces;
  for (const double width : { 0.02, 60.0, 120.0 })
  {
    for (const Offset most : { 16, 50, 1000, 4000 })
    {
      const SurfacePart part{ { Point3(0.0, 0.0, 0.0), Point3(5e4, 0.0, 0.0),
        Point3(1500.0, 100.0 * width, 0.0) } };
      pieces.clear();
      CHECK(cutter.cutAcross(0, part, most, pieces));
      CHECK(static_cast<Offset>(pieces.size()) <= most);
    }
  }
  pieces.clear();
  const SurfacePart round{ { Point3(0.0, 0.0, 0.0), Point3(50.0, 0.0, 0.0),
    Point3(20.0, 30.0, 0.0) } };
  const SurfacePart small{ { Point3(0.0, 0.0, 0.0), Point3(5.0, 0.0, 0.0),
    Point3(2.0, 0.1, 0.0) } };
  CHECK(!cutter.cutAcross(0, round, 10000, pieces));
  CHECK(!cutter.cutAcross(0, small, 10000, pieces));
  CHECK(pieces.empty());
}
}

int TestSurfaceParts(int, char*[])
{
  testPieces();
  testSlices();
  return result();
}
