// Metric/: tensors, refinement for a metric, limits by straight edges and by growth, the number of
// points that a metric asks for, the same bytes on any threads.

#include "Features/FeatureGraph.h"
#include "Mesh/EdgeTable.h"
#include "Mesh/FacetGeometry.h"
#include "Metric/Gradation.h"
#include "Metric/MetricRefinement.h"
#include "Metric/MetricSurface.h"
#include "Metric/StraightEdges.h"
#include "TestCancels.h"
#include "TestSupport.h"

#include <cmath>
#include <functional>
#include <limits>

using namespace remesh;
using namespace remesh::test;

namespace
{
using Tensor = std::function<Eigen::Matrix3d(const Point3&)>;

MetricField fieldOf(const SurfaceMesh& mesh, const Tensor& tensor)
{
  MetricField field;
  field.normals = pointNormals(mesh);
  for (const Point3& point : mesh.points)
  {
    field.tensors.push_back(tensor(point));
  }
  return field;
}

Eigen::Matrix3d matrixOf(const Tensor2& a)
{
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix.topLeftCorner<2, 2>() << a.xx, a.xy, a.xy, a.yy;
  return matrix;
}

void testTensors()
{
  const Tensor2 a{ 9.0, 2.0, 1.0 };
  const Tensor2 b{ 1.0, -0.5, 4.0 };
  CHECK((matrixOf(exponential(logarithm(a))) - matrixOf(a)).norm() < 1e-12);
  const Tensor2 root = squareRoot(a);
  CHECK((matrixOf(root) * matrixOf(root) - matrixOf(a)).norm() < 1e-12);
  CHECK((matrixOf(sandwich(a, b)) - matrixOf(a) * matrixOf(b) * matrixOf(a)).norm() < 1e-12);
  // An intersection is nowhere shorter than both, and touches each.
  const Tensor2 both = intersection(a, b);
  CHECK_NEAR(relativeSizes(a, both).min, 1.0, 1e-12);
  CHECK_NEAR(relativeSizes(b, both).min, 1.0, 1e-12);
  // 1e10 : 1, at an angle: the small eigenvalue is not lost.
  const double c = 0.8;
  const double s = 0.6;
  const Tensor2 thin{ 1e10 * c * c + s * s, (1e10 - 1.0) * c * s, 1e10 * s * s + c * c };
  CHECK_NEAR(logarithm(thin).squared(-s, c), 0.0, 1e-5);
}

/** A layer along a circle of radius 1, `thin` across it and `along` around it. */
Tensor ring(double thin, double along)
{
  return [=](const Point3& p) -> Eigen::Matrix3d
  {
    const Point3 out = Point3(p[0], p[1], 0.0).normalized();
    const Point3 around(-out[1], out[0], 0.0);
    return out * out.transpose() / (thin * thin) + around * around.transpose() / (along * along) +
      Point3::UnitZ() * Point3::UnitZ().transpose();
  };
}

/** Radii 0.5 to 1.5 of a third of a turn. */
SurfaceMesh sector(int radii, int angles)
{
  TriangleSoup soup = gridPatch(radii, angles);
  for (Point3& p : soup.points)
  {
    p = Point3((0.5 + p[0]) * std::cos(2.0 * p[1]), (0.5 + p[0]) * std::sin(2.0 * p[1]), 0.0);
  }
  return meshOf(soup);
}

void testRefinement()
{
  const SurfaceMesh mesh = meshOf(gridPatch(6, 6));
  const Tensor tensor = [](const Point3& p) -> Eigen::Matrix3d
  { return Point3(1.0 + 99.0 * p[0], 1.0, 1.0).asDiagonal(); };
  const MetricField metric = fieldOf(mesh, tensor);
  constexpr double unit = 0.2;
  RefinedSurface refined;
  MetricField refinedMetric;
  CHECK(
    refineForMetric(mesh, nullptr, metric, unit, 1 << 20, RunControl(), refined, refinedMetric));
  CHECK_NEAR(surfaceArea(refined.mesh), 1.0, 1e-12);
  std::vector<TargetShape> shapes;
  CHECK(findTargetShapes(refined.mesh, refinedMetric, RunControl(), shapes).ok());
  double longest = 0.0;
  double variation = 1.0;
  for (const TargetShape& shape : shapes)
  {
    variation = std::max(variation, shape.variation);
    for (int k = 0; k < 3; ++k)
    {
      longest = std::max(longest, std::sqrt(shape.edge2(k)));
    }
  }
  CHECK(longest < 0.55 * unit);
  CHECK(variation < 2.0);
  // Nothing is split where all is fine, and no more than there is room for.
  CHECK(
    !refineForMetric(mesh, nullptr, metric, 50.0, 1 << 20, RunControl(), refined, refinedMetric));
  refineForMetric(mesh, nullptr, metric, 0.02, 500, RunControl(), refined, refinedMetric);
  CHECK(refined.mesh.numberOfFacets() <= 500);
}

/**
 * A thin metric across the facets' sides: pieces are long along it, in few facets.
 *
 * @param isFolded by 90 degrees in the middle: pieces meet at a crease, which flips leave alone.
 */
void testThinPieces(bool isFolded)
{
  TriangleSoup soup = gridPatch(4, 4);
  for (Point3& p : soup.points)
  {
    p = isFolded && p[0] > 0.5 ? Point3(0.5, p[1], p[0] - 0.5) : p;
  }
  SurfaceMesh mesh = meshOf(soup);
  const Point3 across(0.6, 0.8, 0.6); // (0.6, 0.8) in the plane of each half
  const MetricField metric = fieldOf(mesh,
    [&](const Point3&) -> Eigen::Matrix3d
    { return Eigen::Matrix3d::Identity() + 90000.0 * across * across.transpose(); });
  constexpr double unit = 10.0; // half of it: 5 along, which no facet has, and 1 / 60 across
  FeatureOptions featureOptions;
  featureOptions.spacing = 0.2;
  const Features features = findFeatures(mesh, featureOptions); // its border, and the crease
  RefinedSurface refined;
  RefinedSurface again;
  MetricField refinedMetric;
  RunControl control;
  control.schedule = Schedule::EightThreads;
  CHECK(
    refineForMetric(mesh, &features, metric, unit, 1 << 20, RunControl(), refined, refinedMetric));
  CHECK(refineForMetric(mesh, &features, metric, unit, 1 << 20, control, again, refinedMetric));
  CHECK(again.mesh.facetPoints == refined.mesh.facetPoints);
  CHECK_NEAR(surfaceArea(refined.mesh), 1.0, 1e-12);
  // 16, 16 and 32 points on the sides of each of 32 facets, and 2 pieces fewer. 4160 where inner
  // edges are split with the sides; 16 384 without flips, too. Beside a crease, where the normal of
  // a point is a mean, the metric varies, and there are more: 6130, or 8256 with the sides.
  CHECK(isFolded ? refined.mesh.numberOfFacets() < 6500 : refined.mesh.numberOfFacets() == 1984);
  for (std::size_t f = 0; f < refined.origins.size(); ++f)
  {
    const Triple& given = mesh.facetPoints[refined.origins[f].facet];
    for (int k = 0; k < 3; ++k)
    {
      Point3 place = Point3::Zero();
      for (int j = 0; j < 3; ++j)
      {
        place += static_cast<double>(refined.origins[f].corners[k][j]) * mesh.points[given[j]];
      }
      CHECK((place - refined.mesh.points[refined.mesh.facetPoints[f][k]]).norm() < 1e-14);
      // No point is within a facet: pieces between those on its sides are short enough.
      const auto& corner = refined.origins[f].corners[k];
      CHECK(isFolded || *std::min_element(corner.begin(), corner.end()) == 0.0F);
    }
    CHECK(facetArea(refined.mesh, static_cast<Index>(f)) > 0.0);
    for (int k = 0; k < 3; ++k)
    {
      const Point3 middle = 0.5 *
        (refined.mesh.points[refined.mesh.facetPoints[f][k]] +
          refined.mesh.points[refined.mesh.facetPoints[f][(k + 1) % 3]]);
      const double along = middle[0] + middle[2]; // the unfolded square's first coordinate
      const bool isAtBorder = std::abs(along - 0.5) == 0.5 || std::abs(middle[1] - 0.5) == 0.5;
      const bool isAtCrease = isFolded && along == 0.5;
      const bool isFeature = refined.features->kind(static_cast<Index>(f), k) != FeatureKind::None;
      CHECK_EQUAL(isFeature, isAtBorder || isAtCrease);
    }
  }
}

/**
 * Facets that are needles in the metric, and several units wide, too: points on their sides are not
 * enough, as flips leave edges between them that are longer.
 */
void testWideNeedles()
{
  const SurfaceMesh mesh = meshOf(gridPatch(1, 1));
  const MetricField metric = fieldOf(
    mesh, [](const Point3&) -> Eigen::Matrix3d { return Point3(25e4, 25.0, 1.0).asDiagonal(); });
  RefinedSurface refined;
  MetricField refinedMetric;
  CHECK(refineForMetric(mesh, nullptr, metric, 1.0, 1 << 20, RunControl(), refined, refinedMetric));
  CHECK_NEAR(surfaceArea(refined.mesh), 1.0, 1e-12);
  // 147 808 pieces; 374 272 where inner edges are split with the sides.
  CHECK(refined.mesh.numberOfFacets() < 200000);
  std::vector<TargetShape> shapes;
  CHECK(findTargetShapes(refined.mesh, refinedMetric, RunControl(), shapes).ok());
  const EdgeTable edges = buildEdgeTable(refined.mesh.facetPoints);
  double longest = 0.0;
  double border = 0.0;
  for (std::size_t f = 0; f < shapes.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      longest = std::max(longest, std::sqrt(shapes[f].edge2(k)));
      const Triple& points = refined.mesh.facetPoints[f];
      const Index valence = edges.valence(edges.facetEdges[f][k]);
      CHECK(valence <= 2);
      border += valence > 1
        ? 0.0
        : (refined.mesh.points[points[k]] - refined.mesh.points[points[(k + 1) % 3]]).norm();
    }
  }
  CHECK(longest < 0.55);
  CHECK_NEAR(border, 4.0, 1e-12); // each inner edge has a facet on both sides
  RefinedSurface again;
  MetricField same;
  CHECK(!refineForMetric(
    refined.mesh, nullptr, refinedMetric, 1.0, 1 << 20, RunControl(), again, same));
}

double sizeAlong(const MetricField& metric, std::size_t point, const Point3& way)
{
  return 1.0 / std::sqrt(way.dot(metric.tensors[point] * way));
}

void testStraightEdges()
{
  // A metric that is the same everywhere stays, also up to the border.
  const SurfaceMesh square = meshOf(gridPatch(20, 20));
  const EdgeTable squareEdges = buildEdgeTable(square.facetPoints);
  const Tensor even = [](const Point3&) -> Eigen::Matrix3d
  { return Eigen::Matrix3d(Point3(900.0, 100.0, 1.0).asDiagonal()); };
  const MetricField same = fieldOf(square, even);
  MetricField limited;
  CHECK(limitToStraightEdges(square, squareEdges, same, 1.0, RunControl(), limited));
  for (std::size_t p = 0; p < square.points.size(); ++p)
  {
    CHECK_NEAR(sizeAlong(limited, p, Point3::UnitX()), 1.0 / 30.0, 1e-9);
    CHECK_NEAR(sizeAlong(limited, p, Point3::UnitY()), 0.1, 1e-9);
  }

  // A chord of length l leaves a ring of radius 1 by l^2/8 and meets its radii at angles up to l/2.
  // Its length in the ring's metric has a closed form: the integral of hypot(1/along, x/thin).
  constexpr double thin = 0.004;
  constexpr double along = 0.2;
  const SurfaceMesh mesh = sector(400, 160);
  const MetricField metric = fieldOf(mesh, ring(thin, along));
  const EdgeTable edges = buildEdgeTable(mesh.facetPoints);
  CHECK(limitToStraightEdges(mesh, edges, metric, 1.0, RunControl(), limited));
  const auto lengthOf = [&](double chord)
  {
    const double k = along / thin; // of the slope
    const double end = 0.5 * chord;
    return (end * std::sqrt(1.0 + k * k * end * end) + std::asinh(k * end) / k) / along;
  };
  double chord = along;
  while (lengthOf(chord) > 1.0)
  {
    chord *= 0.999;
  }
  CHECK(chord < 0.6 * along);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    const Point3& place = mesh.points[p];
    const double angle = std::atan2(place[1], place[0]);
    if (std::abs(place.norm() - 1.0) < 1e-6 && std::abs(angle - 1.0) < 0.5)
    {
      const Point3 out = place.normalized();
      // Slanted edges meet the ring otherwise than an ellipse says: it is the nearest one.
      CHECK_NEAR(sizeAlong(limited, p, Point3(-out[1], out[0], 0.0)) / chord, 1.0, 0.15);
      CHECK_NEAR(sizeAlong(limited, p, out) / thin, 1.125, 0.125);
    }
  }
}

void testGrowth()
{
  const SurfaceMesh mesh = meshOf(gridPatch(40, 40));
  const EdgeTable edges = buildEdgeTable(mesh.facetPoints);
  MetricField metric = fieldOf(mesh,
    [](const Point3& p) -> Eigen::Matrix3d
    {
      const double size = p[0] < 0.3 ? 0.02 : 0.5;
      return Eigen::Matrix3d::Identity() / (size * size);
    });
  const MetricField before = metric;
  CHECK(limitGrowth(mesh, edges, { 1.5, 1.0, {} }, RunControl(), metric));
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    CHECK(sizeAlong(metric, p, Point3::UnitX()) <= 1.0001 * sizeAlong(before, p, Point3::UnitX()));
  }
  for (const Triple& points : mesh.facetPoints)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index p = points[k];
      const Index q = points[(k + 1) % 3];
      const Point3 edge = mesh.points[q] - mesh.points[p];
      const double small = sizeAlong(metric, p, edge.normalized());
      const double large = sizeAlong(metric, q, edge.normalized());
      const double length = edge.norm() / std::min(small, large);
      CHECK(large < small * std::pow(1.5, length) * 1.02);
    }
  }
}

/** Where a metric bends, sizes double over a unit, however much they may grow elsewhere. */
void testGrowthInBends()
{
  const SurfaceMesh mesh = meshOf(gridPatch(60, 20));
  const EdgeTable edges = buildEdgeTable(mesh.facetPoints);
  const MetricField jump = fieldOf(mesh,
    [](const Point3& p) -> Eigen::Matrix3d
    {
      const double size = p[0] < 0.1 ? 0.05 : 2.0;
      return Eigen::Matrix3d::Identity() / (size * size);
    });
  GradationLimits limits;
  const auto largestGrowth = [&](float bend)
  {
    limits.bends.assign(mesh.points.size(), bend);
    MetricField metric = jump;
    CHECK(limitGrowth(mesh, edges, limits, RunControl(), metric));
    double growth = 1.0;
    for (const Triple& points : mesh.facetPoints)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double small = sizeAlong(metric, points[k], Point3::UnitX());
        const double large = sizeAlong(metric, points[(k + 1) % 3], Point3::UnitX());
        const Point3 edge = mesh.points[points[(k + 1) % 3]] - mesh.points[points[k]];
        growth = std::max(growth, std::pow(large / small, small / edge.norm()));
      }
    }
    return growth;
  };
  CHECK_NEAR(largestGrowth(1.0F), 5.0, 0.4);
  CHECK_NEAR(largestGrowth(2.9F), 5.0, 0.4);
  CHECK_NEAR(largestGrowth(300.0F), 2.0, 0.1);
}

void testNumber()
{
  // A square of 20 x 20 units: 400 for the area, 40 half units of the border.
  const SurfaceMesh mesh = meshOf(gridPatch(10, 10));
  const MetricField metric = fieldOf(
    mesh, [](const Point3&) -> Eigen::Matrix3d { return 400.0 * Eigen::Matrix3d::Identity(); });
  MetricOptions options;
  options.unit = 1.0;
  MetricSize size;
  CHECK(measureMetric(mesh, metric, options, RunControl(), size).ok());
  CHECK_NEAR(size.area, 400.0, 1e-6);
  CHECK_NEAR(size.border, 80.0, 1e-6);
  CHECK_NEAR(size.points(1.0), 800.0 / std::sqrt(3.0) + 40.0 + 1.0, 1e-6);
  CHECK_NEAR(unitOf(size.area, 1000), std::sqrt(800.0 / std::sqrt(3.0) / 1000.0), 1e-12);
}

void testSameBytes()
{
  const SurfaceMesh mesh = sector(20, 40);
  const MetricField metric = fieldOf(mesh, ring(0.02, 0.2));
  MetricSurface surfaces[2];
  for (int k = 0; k < 2; ++k)
  {
    RunControl control;
    control.schedule = k == 0 ? Schedule::ShuffledBlocks : Schedule::EightThreads;
    MetricOptions options;
    options.sites = 300;
    CHECK(embedMetric(mesh, nullptr, metric, options, control, surfaces[k]).ok());
    CHECK(surfaces[k].refined.has_value());
  }
  CHECK(surfaces[0].embedding.places == surfaces[1].embedding.places);
  CHECK(surfaces[0].limits == surfaces[1].limits);
  CHECK(*std::max_element(surfaces[0].limits.begin(), surfaces[0].limits.end()) > 1.2F);
}

void testCancelled()
{
  const SurfaceMesh mesh = sector(8, 12);
  const MetricField metric = fieldOf(mesh, ring(0.05, 0.2));
  MetricOptions options;
  options.sites = 300;
  options.iterations = 2;
  checkCancels("metric",
    [&](const RunControl& control)
    {
      MetricSurface surface;
      return embedMetric(mesh, nullptr, metric, options, control, surface);
    });
}
}

int TestMetricLimits(int, char*[])
{
  testTensors();
  testRefinement();
  testStraightEdges();
  testThinPieces(false);
  testThinPieces(true);
  testWideNeedles();
  testGrowth();
  testGrowthInBends();
  testNumber();
  testSameBytes();
  testCancelled();
  return result();
}
