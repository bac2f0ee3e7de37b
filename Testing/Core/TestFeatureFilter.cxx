// Features/FeatureFilter: noise makes no creases, however far its edges hang together and whatever
// border they meet; what a solid with rough faces has at its own edges stays. Neither do the steps
// of voxels, where there are more than points.

#include "Features/FeatureGraph.h"
#include "Mesh/NormalFlow.h"
#include "Support/Random.h"
#include "TestSupport.h"
#include "TestSurfaces.h"

#include <Eigen/Geometry>

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

/**
 * A straight ridge, loose and not strong: as long as 3.5 spacings it stays, as long as 1.8 it goes,
 * whether its edges are long or short.
 */
void testStraightCrease()
{
  for (const int n : { 10, 20, 80 })
  {
    TriangleSoup soup = test::gridPatch(n, n);
    for (Point3& point : soup.points)
    {
      const double height = std::min(1.0, std::max(0.0, 2.0 - 6.0 * std::abs(point.x() - 0.5)));
      point.z() = -0.075 * height * std::tanh(6.0 * std::abs(point.y() - 0.5));
    }
    const SurfaceMesh mesh = test::meshOf(soup);
    const auto ridge = [&](Offset sites) { return countFeatures(mesh, sites) - Offset(4) * n; };
    CHECK_NEAR(static_cast<double>(ridge(80)) / n, 0.42, 0.03);
    CHECK_EQUAL(ridge(20), 0);
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

/** A facet of a flat square that a point has been pushed over, and two of another one. */
SurfaceMesh squareWithFolds()
{
  constexpr int n = 12;
  TriangleSoup soup = test::gridPatch(n, n);
  const auto at = [&](int i, int j) -> Point3& { return soup.points[j * (n + 1) + i]; };
  // Over the side from (4, 3) to (4, 4) of the facet with (3, 3).
  at(3, 3) += Point3(1.2 / n, 0.6 / n, 0.0);
  // Both facets between (8, 8) and (9, 9): the two other corners are beyond each other.
  const Point3 center = 0.5 * (at(8, 8) + at(9, 9));
  at(9, 8) = center + Point3(-0.05 / n, 0.05 / n, 0.0);
  at(8, 9) = center + Point3(0.05 / n, -0.05 / n, 0.0);
  return test::meshOf(soup);
}

/** Facets turned back have no creases at any spacing; the bases of low pyramids keep theirs. */
void testTurnedBack()
{
  const SurfaceMesh square = squareWithFolds();
  SurfaceMesh all = square;
  const Features found = findFeatures(all, FeatureOptions());
  CHECK(std::count(found.kinds.begin(), found.kinds.end(), FeatureKind::Crease) >= 7);
  for (const Offset sites : { 100, 1000, 100000 })
  {
    CHECK_EQUAL(countFeatures(square, sites), 4 * 12); // the border
  }
  for (const int sides : { 3, 4 })
  {
    std::vector<Point3> points = { Point3(0.0, 0.0, 0.1) };
    std::vector<std::array<Offset, 3>> triangles;
    for (int k = 0; k < sides; ++k)
    {
      const double angle = 2.0 * test::pi * k / sides;
      points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
      triangles.push_back({ 0, 1 + k, 1 + (k + 1) % sides });
    }
    triangles.push_back({ 1, 3, 2 });
    if (sides == 4)
    {
      triangles.push_back({ 1, 4, 3 });
    }
    const SurfaceMesh pyramid = test::meshOf(test::makeSoup(points, triangles));
    CHECK_EQUAL(countFeatures(pyramid, 1000), sides);
  }
  // Nor do flat tetrahedra, whose upper facets are each beyond two sides of the lower ones.
  for (int k = 0; k < 50; ++k)
  {
    const Eigen::AngleAxisd turn(0.1 * k, Point3(1.0, 0.3 * k, -0.7).normalized());
    std::vector<Point3> points;
    for (const Point3& p :
      { Point3(-1, 0, 0), Point3(0, -1, 0.1), Point3(1, 0, 0), Point3(0, 1, 0.1) })
    {
      points.push_back(turn * p);
    }
    const SurfaceMesh tetrahedron =
      test::meshOf(test::makeSoup(points, { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 1, 3 }, { 1, 2, 3 } }));
    CHECK_EQUAL(countFeatures(tetrahedron, 1000), 4);
  }
}
}

int TestFeatureFilter(int, char*[])
{
  testNoise();
  testNoiseAtBorder();
  testCreaseAtBorder();
  testStraightCrease();
  testBox();
  testSteps();
  testBordersOfSteps();
  testTurnedBack();
  return test::result();
}
