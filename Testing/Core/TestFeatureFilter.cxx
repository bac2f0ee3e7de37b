// Features/FeatureFilter: noise makes no creases, however far its edges hang together and whatever
// border they meet; what a solid with rough faces has at its own edges stays. Neither do the steps
// of voxels, where there are more than points.

#include "Features/FeatureGraph.h"
#include "Mesh/NormalFlow.h"
#include "Mesh/Normals.h"
#include "Support/Random.h"
#include "TestSupport.h"
#include "TestSurfaces.h"

#include <algorithm>
#include <cmath>
#include <iterator>

using namespace remesh;

namespace
{
/** A unit sphere of 10 242 points that are moved inward or outward at random. */
SurfaceMesh noisySphere(double amplitude)
{
  TriangleSoup soup = test::icosphere(5);
  for (std::size_t k = 0; k < soup.points.size(); ++k)
  {
    soup.points[k] *= 1.0 + amplitude * (2.0 * uniform01(3, k, 0) - 1.0);
  }
  return test::meshOf(soup);
}

Offset countFeatures(SurfaceMesh mesh, Offset sites)
{
  FeatureOptions options;
  options.spacing = meanSpacing(mesh, sites);
  const Features features = findFeatures(mesh, options);
  return static_cast<Offset>(features.kinds.size()) -
    std::count(features.kinds.begin(), features.kinds.end(), FeatureKind::None);
}

void testNoise()
{
  for (const double amplitude : { 0.005, 0.01, 0.015, 0.02, 0.04 })
  {
    const SurfaceMesh mesh = noisySphere(amplitude);
    if (amplitude >= 0.015)
    {
      SurfaceMesh all = mesh; // no spacing is given, and nothing is dropped
      const Features features = findFeatures(all, FeatureOptions());
      CHECK(std::count(features.kinds.begin(), features.kinds.end(), FeatureKind::Crease) > 5000);
    }
    for (const Offset sites : { 500, 2000 })
    {
      CHECK_EQUAL(countFeatures(mesh, sites), 0);
    }
  }
}

/** The unit square of n x n cells, whose points are moved up and down at random. */
SurfaceMesh noisySquare(int n, double amplitude)
{
  TriangleSoup soup = test::gridPatch(n, n);
  for (std::size_t k = 0; k < soup.points.size(); ++k)
  {
    soup.points[k].z() += amplitude * (2.0 * uniform01(5, k, 0) - 1.0);
  }
  return test::meshOf(soup);
}

void testNoiseAtBorder()
{
  for (const double amplitude : { 0.005, 0.01, 0.02 })
  {
    const SurfaceMesh mesh = noisySquare(100, amplitude);
    for (const Offset sites : { 500, 2000 })
    {
      const Offset features = countFeatures(mesh, sites);
      CHECK(features >= 400 && features <= 420); // the border, and a few edges across corners
    }
  }
}

/** A box of 6 x n x n squares, whose points inside the faces are moved up and down a little. */
SurfaceMesh roughBox(int n)
{
  TriangleSoup soup;
  const auto place = [&](int face, int i, int j)
  {
    const int axis = face / 2;
    const double u = static_cast<double>(i) / n;
    const double v = static_cast<double>(j) / n;
    const bool inside = i > 0 && j > 0 && i < n && j < n;
    Point3 point;
    point[axis] = face % 2;
    point[(axis + 1) % 3] = face % 2 == 1 ? u : v;
    point[(axis + 2) % 3] = face % 2 == 1 ? v : u;
    point[axis] += inside ? 0.1 / n * uniform01(1, soup.points.size(), 0) : 0.0;
    return point;
  };
  for (int face = 0; face < 6; ++face)
  {
    const auto first = static_cast<Offset>(soup.points.size());
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; j <= n; ++j)
      {
        soup.points.push_back(place(face, i, j));
      }
    }
    const auto id = [&](int i, int j) { return first + Offset(i) * (n + 1) + j; };
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < n; ++j)
      {
        soup.triangles.push_back({ id(i, j), id(i + 1, j), id(i + 1, j + 1) });
        soup.triangles.push_back({ id(i, j), id(i + 1, j + 1), id(i, j + 1) });
      }
    }
  }
  return test::meshOf(test::makeSoup(soup.points, soup.triangles));
}

/** A square is folded up along a line that turns at its centre, and is smooth elsewhere. */
void testCreaseAtBorder()
{
  for (const int n : { 2, 12 })
  {
    TriangleSoup soup = test::gridPatch(n, n);
    for (Point3& point : soup.points)
    {
      point.z() = std::hypot(std::max(0.0, point.x() - 0.5), std::max(0.0, point.y() - 0.5));
    }
    for (const Offset sites : { 20, 100, 2000 })
    {
      CHECK_EQUAL(countFeatures(test::meshOf(soup), sites), 4 * n + n);
    }
  }
}

void testBox()
{
  const SurfaceMesh mesh = roughBox(20);
  CHECK_EQUAL(mesh.numberOfPoints(), 6 * 20 * 20 + 2);
  for (const Offset sites : { 100, 500, 5000 })
  {
    CHECK_EQUAL(countFeatures(mesh, sites), 12 * 20);
  }
}

std::size_t cornersOf(SurfaceMesh mesh)
{
  return findFeatures(mesh, FeatureOptions()).corners.size();
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
 * A crack between two flaps, filled with a facet that stands out of them: nothing of it is left
 * where it is low against the spacing but the crease between the flaps, if there is one.
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
    CHECK_EQUAL(found.withoutNormal.size(), std::size_t(found.sidesOfNeedles > 0));
    return std::count(found.kinds.begin(), found.kinds.end(), FeatureKind::Crease);
  };
  CHECK_EQUAL(creasesOf(0.15), 3);
  CHECK_EQUAL(creasesOf(0.1), 0);
}

/** Normals are those of the surface without its needles. */
void testNormalsBesideNeedles()
{
  TriangleSoup soup = test::gridPatch(4, 4);
  // The edge between two triangles opens to a flap.
  const std::array<Offset, 3> opened = soup.triangles[14];
  soup.points.push_back(
    0.5 * (soup.points[opened[0]] + soup.points[opened[1]]) + Point3(0, 0, 0.01));
  const auto flap = static_cast<Offset>(soup.points.size()) - 1;
  soup.triangles[14] = { opened[0], flap, opened[2] };
  soup.triangles.push_back({ flap, opened[1], opened[2] });
  soup.triangles.push_back({ opened[0], opened[1], flap });
  soup.inputCells.resize(soup.triangles.size());
  SurfaceMesh mesh = test::meshOf(soup);
  FeatureOptions options;
  options.spacing = 0.1;
  const Features features = findFeatures(mesh, options);
  CHECK_EQUAL(features.facetsWithoutNormal.size(), std::size_t(1));
  const auto leastOf = [&](const std::vector<Index>& leftOut)
  {
    double least = 1.0;
    for (const Point3& normal : estimateCornerNormals(mesh, 0, RunControl(), leftOut))
    {
      least = std::min(least, std::abs(normal.z()));
    }
    return least;
  };
  CHECK(leastOf({}) < 0.98);
  CHECK(leastOf(features.facetsWithoutNormal) > 0.99);
}

Features featuresOf(
  const std::vector<Point3>& points, const std::vector<std::array<Offset, 3>>& triangles)
{
  SurfaceMesh mesh = test::meshOf(test::makeSoup(points, triangles));
  FeatureOptions options;
  options.spacing = 0.1;
  return findFeatures(mesh, options);
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
    CHECK_EQUAL(features.droppedEdges, 3);
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
  CHECK_EQUAL(features.droppedEdges, 0);
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

bool isInBall(int i, int j, int k)
{
  return Point3(i - 14.5, j - 14.5, k - 14.5).norm() < 14.2;
}

/** Borders of the surface and of labels stay where steps go. */
void testBordersOfSteps()
{
  const auto isBelow = [](const Point3& a, const Point3& b, const Point3& c)
  { return a.z() + b.z() + c.z() < 3.0 * 20.0; };
  const TriangleSoup soup = test::voxelSurface(30, isInBall);
  SurfaceMesh whole = test::meshOf(soup);
  FeatureOptions options;
  for (const auto& [a, b, c] : whole.facetPoints)
  {
    options.facetLabels.push_back(
      isBelow(whole.points[a], whole.points[b], whole.points[c]) ? 3 : 7);
  }
  std::vector<std::array<Offset, 3>> below;
  std::copy_if(soup.triangles.begin(), soup.triangles.end(), std::back_inserter(below),
    [&](const std::array<Offset, 3>& t)
    { return isBelow(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]); });
  SurfaceMesh cut = test::meshOf(test::makeSoup(soup.points, below));
  const auto edgesBetween = [&](const std::vector<Index>& labels, const Features& features)
  {
    Offset kept = 0;
    Offset all = 0;
    for (std::size_t e = 0; e < features.kinds.size(); ++e)
    {
      const Index* facets = features.edges.edgeFacets.data() + features.edges.edgeFacetsBegin[e];
      const Offset count =
        features.edges.edgeFacetsBegin[e + 1] - features.edges.edgeFacetsBegin[e];
      const bool isBorder =
        count == 1 || (!labels.empty() && labels[facets[0]] != labels[facets[1]]);
      all += isBorder;
      kept += isBorder && features.kinds[e] != FeatureKind::None;
    }
    CHECK_EQUAL(kept, all);
    return all;
  };
  options.spacing = meanSpacing(whole, 400);
  const Features labelled = findFeatures(whole, options);
  const Offset border = edgesBetween(options.facetLabels, labelled);
  CHECK(border > 60);
  const auto count = [](const Features& features)
  {
    return static_cast<Offset>(features.kinds.size()) -
      std::count(features.kinds.begin(), features.kinds.end(), FeatureKind::None);
  };
  CHECK(count(labelled) < border + 400); // of 4000 and more
  options.facetLabels.clear();
  const Features bordered = findFeatures(cut, options);
  CHECK_EQUAL(edgesBetween({}, bordered), border);
  CHECK(count(bordered) < border + 400);
}

/** A ball of voxels whose steps bend at some 1800 points. */
void testSteps()
{
  const SurfaceMesh ball = test::meshOf(test::voxelSurface(30, isInBall));
  CHECK_NEAR(test::enclosedVolume(ball), 4.0 / 3.0 * 3.1416 * std::pow(14.2, 3.0), 200.0);
  const Offset all = countFeatures(ball, 100000);
  CHECK(all > 4000);
  CHECK_EQUAL(countFeatures(ball, 4000), all); // there are points enough
  for (const Offset sites : { 100, 200, 400, 800 })
  {
    CHECK(countFeatures(ball, sites) < all / 20);
  }

  // Of pins and fins nothing goes: they would shrink.
  const auto isInPins = [](int i, int j, int k) { return k < 3 || (i % 5 < 3 && j % 5 < 3); };
  const auto isInFins = [](int i, int j, int k) { return k < 3 || (i % 3 < 2 && j % 9 < 8); };
  const auto checkKept = [](const TriangleSoup& soup)
  {
    const SurfaceMesh mesh = test::meshOf(soup);
    const Offset kept = countFeatures(mesh, 100000);
    CHECK(cornersOf(mesh) > 150); // more than points at first
    for (const Offset sites : { 60, 80, 150, 1000 })
    {
      CHECK_EQUAL(countFeatures(mesh, sites), kept);
    }
  };
  checkKept(test::voxelSurface(28, isInPins));
  checkKept(test::voxelSurface(28, isInFins));
}
}

int TestFeatureFilter(int, char*[])
{
  testNoise();
  testNoiseAtBorder();
  testCreaseAtBorder();
  testBox();
  testSlivers();
  testNeedles();
  testStubs();
  testNormalsBesideNeedles();
  testPairOfNeedles();
  testThinBesideLow();
  testTouchingTip();
  testPinches();
  testSteps();
  testBordersOfSteps();
  return test::result();
}
