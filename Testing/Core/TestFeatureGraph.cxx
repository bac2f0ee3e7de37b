// Features/FeatureGraph: corners where parts of the surface meet in just a point.

#include "Features/FeatureGraph.h"
#include "TestSupport.h"
#include "TestSurfaces.h"

#include <cmath>

using namespace remesh;

namespace
{
std::size_t cornersOf(SurfaceMesh mesh)
{
  return findFeatures(mesh, FeatureOptions()).corners.size();
}

/** A tip that touches the middle of a crease, or of a border, makes that point a corner. */
void testTouchingTip()
{
  constexpr Offset sides = 40;
  for (const bool isFolded : { true, false })
  {
    TriangleSoup soup = test::gridPatch(4, 4);
    for (Point3& point : soup.points)
    {
      point.z() = isFolded ? std::abs(point.x() - 0.5) : 0.0;
    }
    const Point3 tip = isFolded ? Point3(0.5, 0.5, 0.0) : Point3(0.5, 0.0, 0.0);
    const std::size_t corners = cornersOf(test::meshOf(soup));
    std::vector<Point3> points{ tip };
    std::vector<std::array<Offset, 3>> triangles;
    for (Offset k = 0; k < sides; ++k)
    {
      const double angle = 2.0 * test::pi * static_cast<double>(k) / sides;
      points.push_back(tip + Point3(0.1 * std::cos(angle), 0.1 * std::sin(angle), -0.3));
      triangles.push_back({ 0, 1 + k, 1 + (k + 1) % sides });
    }
    test::append(soup, test::makeSoup(points, triangles), Point3::Zero());
    CHECK_EQUAL(cornersOf(test::meshOf(soup)), corners + 1); // the cone's border has none
  }
}

/** Where parts of the surface meet in just a point, and nowhere else. */
void testPinches()
{
  const auto pinchesOf = [](const TriangleSoup& soup)
  {
    SurfaceMesh mesh = test::meshOf(soup);
    return findFeatures(mesh, FeatureOptions()).pinches;
  };
  CHECK(pinchesOf(test::cube()).empty());
  CHECK(pinchesOf(test::threeSheets()).empty());
  CHECK(pinchesOf(test::patchWithHoles(6, { { 1, 1 }, { 3, 3 } })).empty());
  CHECK_EQUAL(pinchesOf(test::patchWithHoles(6, { { 1, 1 }, { 2, 2 } })).size(), std::size_t(1));
  TriangleSoup balls = test::icosphere(2);
  test::append(balls, test::icosphere(2), 2.0 * balls.points[0]);
  CHECK_EQUAL(pinchesOf(balls).size(), std::size_t(1));
}
}

int TestFeatureGraph(int, char*[])
{
  testTouchingTip();
  testPinches();
  return test::result();
}
