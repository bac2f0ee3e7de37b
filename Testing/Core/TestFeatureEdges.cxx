// Features/FeatureEdges: facets too thin to have a normal, and needles, make no creases of their
// sides, and no normals; what stands out as much but is broader, or folds up, does.

#include "Features/FeatureGraph.h"
#include "TestSupport.h"
#include "TestSurfaces.h"

#include <Eigen/Geometry>

#include <algorithm>

using namespace remesh;

namespace
{
Features featuresOf(
  const std::vector<Point3>& points, const std::vector<std::array<Offset, 3>>& triangles)
{
  SurfaceMesh mesh = test::meshOf(test::makeSoup(points, triangles));
  FeatureOptions options;
  options.spacing = 0.1;
  return findFeatures(mesh, options);
}

/** A crack in a plane, filled with two slivers whose own normals are noise: there is no crease. */
void testSlivers()
{
  for (const double width : { 1e-8, 1e-10, 1e-12 })
  {
    const std::vector<Point3> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.5, -1, 0 },
      { 0.4, width, 0.7 * width }, { 0.6, -width, 0.7 * width } };
    const std::vector<std::array<Offset, 3>> triangles{ { 0, 1, 4 }, { 1, 0, 5 }, { 0, 4, 2 },
      { 4, 1, 2 }, { 1, 5, 3 }, { 5, 0, 3 } };
    SurfaceMesh mesh = test::meshOf(test::makeSoup(points, triangles));
    CHECK_EQUAL(mesh.numberOfFacets(), 6);
    const Features features = findFeatures(mesh, FeatureOptions());
    CHECK_EQUAL(std::count(features.kinds.begin(), features.kinds.end(), FeatureKind::Crease), 0);
    CHECK_EQUAL(std::count(features.kinds.begin(), features.kinds.end(), FeatureKind::Boundary), 4);
  }
}

/**
 * A crack between two half-planes, filled with a facet that stands out of them: nothing of it is
 * left where it is low against the spacing but the crease between them, if there is one.
 */
void testNeedles()
{
  const auto creasesOf = [](double depth, const Point3& tip, double spacing)
  {
    const std::vector<Point3> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, -depth },
      { 0.5, -1, -depth }, tip };
    const std::vector<std::array<Offset, 3>> triangles{ { 0, 1, 4 }, { 0, 4, 2 }, { 4, 1, 2 },
      { 1, 0, 3 } };
    SurfaceMesh mesh = test::meshOf(test::makeSoup(points, triangles));
    FeatureOptions options;
    options.spacing = spacing;
    const Features features = findFeatures(mesh, options);
    return std::count(features.kinds.begin(), features.kinds.end(), FeatureKind::Crease);
  };
  constexpr double lowest = 0.001;
  constexpr double low = 0.015;
  constexpr double high = 0.025;
  const auto folded = [](double height) { return Point3(0.4, -0.98 * height, 0.17 * height); };
  const auto risen = [](double height) { return Point3(0.4, -0.5 * height, 0.87 * height); };
  for (const double spacing : { 0.0, 0.1 })
  {
    const bool sees = spacing == 0.0;
    CHECK_EQUAL(creasesOf(0.0, risen(lowest), spacing), sees ? 3 : 0);
    CHECK_EQUAL(creasesOf(0.0, risen(low), spacing), sees ? 3 : 0);
    CHECK_EQUAL(creasesOf(0.0, risen(high), spacing), 3);
    CHECK_EQUAL(creasesOf(0.0, folded(lowest), spacing), sees ? 3 : 0);
    CHECK_EQUAL(creasesOf(0.0, folded(low), spacing), 3);
    CHECK_EQUAL(creasesOf(1.0, { 0.4, 0.0, lowest }, spacing), sees ? 3 : 2);
    CHECK_EQUAL(creasesOf(1.0, { 0.4, 0.0, low }, spacing), 3); // between its neighbours' normals
  }
}

/** What is low but not long stands out as well, and stays. */
void testStubs()
{
  const auto creasesOf = [](double height)
  {
    const SurfaceMesh mesh = test::meshOf(test::makeSoup(
      { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.5, -1, 0 }, { 0.5, 0, height } },
      { { 0, 1, 4 }, { 0, 4, 2 }, { 4, 1, 2 }, { 1, 0, 3 } }));
    FeatureOptions options;
    options.spacing = 2.0;
    const FeatureEdges found =
      findFeatureEdges(mesh, buildEdgeTable(mesh.facetPoints), options, RunControl());
    const auto creases = std::count(found.kinds.begin(), found.kinds.end(), FeatureKind::Crease);
    CHECK_EQUAL(found.sidesOfNeedles.size(), static_cast<std::size_t>(3 - creases));
    return creases;
  };
  CHECK_EQUAL(creasesOf(0.15), 3);
  CHECK_EQUAL(creasesOf(0.1), 0);
}

/** A ridge of two like flanks on a plane, tapered at both ends, stays however it lies. */
void testRidge()
{
  const std::vector<Point3> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0.005, 0 }, { 0.5, -0.005, 0 },
    { 0.5, 0, 0.01 }, { 0.5, 1, 0 }, { 0.5, -1, 0 } };
  const std::vector<std::array<Offset, 3>> triangles{ { 0, 4, 2 }, { 4, 1, 2 }, { 0, 3, 4 },
    { 3, 1, 4 }, { 0, 2, 5 }, { 2, 1, 5 }, { 3, 0, 6 }, { 1, 3, 6 } };
  for (int turn = 0; turn < 20; ++turn)
  {
    std::vector<Point3> turned = points;
    for (Point3& point : turned)
    {
      point = Eigen::AngleAxisd(0.3 * turn, Point3(1, 2, 3).normalized()) * point;
    }
    const Features features = featuresOf(turned, triangles);
    CHECK_EQUAL(std::count(features.kinds.begin(), features.kinds.end(), FeatureKind::Crease), 6);
  }
}

/** Where normals are estimated, needles count as the facets that they take theirs from. */
void testNormalsBesideNeedles()
{
  SurfaceMesh mesh = test::meshOf(test::patchWithFlap());
  FeatureOptions options;
  options.spacing = 0.1;
  std::vector<FacetNormal> borrowed;
  findFeatures(mesh, options, RunControl(), &borrowed);
  CHECK_EQUAL(borrowed.size(), std::size_t(1));
  CHECK(borrowed[0].normal.z() > 0.99);
  const auto minOf = [&](const std::vector<FacetNormal>& normals)
  {
    double least = 1.0;
    for (const Point3& normal : estimateCornerNormals(mesh, 0, RunControl(), normals))
    {
      least = std::min(least, normal.z());
    }
    return least;
  };
  CHECK(minOf({}) < 0.98);
  CHECK(minOf(borrowed) > 0.99);
}

/** A crack along a crease, filled with two needles that meet in the longest edge of both. */
void testPairOfNeedles()
{
  constexpr double low = 0.001;
  const std::vector<Point3> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, -1 }, { 0.5, -1, -1 },
    { 0.4, -0.5 * low, 0.87 * low }, { 0.6, -0.9 * low, 0 } };
  std::vector<std::array<Offset, 3>> triangles{ { 0, 1, 4 }, { 1, 0, 5 }, { 0, 4, 2 }, { 4, 1, 2 },
    { 1, 5, 3 }, { 5, 0, 3 } };
  for (int first = 0; first < 2; ++first)
  {
    const Features features = featuresOf(points, triangles);
    CHECK_EQUAL(std::count(features.kinds.begin(), features.kinds.end(), FeatureKind::Crease), 2);
    CHECK_EQUAL(features.dropped.edges, 3);
    std::swap(triangles[0], triangles[1]);
  }
}

/** Beside a crease a low facet, and beyond it one too thin to tell that the low one stands out. */
void testThinBesideLow()
{
  constexpr double low = 0.001;
  const Point3 tip{ 0.4, low, 0.0 };
  const Point3 end{ 1.0, 0.0, 0.0 };
  const Features features = featuresOf({ { 0, 0, 0 }, end, { 0.5, 1, 0 }, { 0.5, -1, -1 }, tip,
                                         0.5 * (tip + end) + Point3(0.0, 0.0, 1e-8) },
    { { 0, 1, 4 }, { 4, 1, 5 }, { 0, 4, 2 }, { 4, 5, 2 }, { 5, 1, 2 }, { 1, 0, 3 } });
  CHECK_EQUAL(std::count(features.kinds.begin(), features.kinds.end(), FeatureKind::Crease), 1);
  CHECK_EQUAL(features.dropped.edges, 0);
}
}

int TestFeatureEdges(int, char*[])
{
  testSlivers();
  testNeedles();
  testStubs();
  testRidge();
  testNormalsBesideNeedles();
  testPairOfNeedles();
  testThinBesideLow();
  return test::result();
}
