// Metric/: shapes of facets, the Laplacian's identities, coarse surfaces, embeddings whose lengths
// are known, parts and odd surfaces, the same bytes on any threads, errors.

#include "Mesh/EdgeTable.h"
#include "Metric/IsometricEmbedding.h"
#include "Metric/LaplacianMatrix.h"
#include "Metric/MetricCoarsening.h"
#include "Support/Random.h"
#include "TestCancels.h"
#include "TestSupport.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace remesh;

namespace
{
using Tensor = std::function<Eigen::Matrix3d(const Point3&)>;

MetricField fieldOf(const SurfaceMesh& mesh, const Tensor& tensor)
{
  MetricField field;
  field.normals.assign(mesh.points.size(), Point3::Zero());
  for (const Triple& points : mesh.facetPoints)
  {
    const Point3& first = mesh.points[points[0]];
    const Point3 normal = (mesh.points[points[1]] - first).cross(mesh.points[points[2]] - first);
    for (const Index point : points)
    {
      field.normals[point] += normal;
    }
  }
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    field.normals[p].normalize();
    field.tensors.push_back(tensor(mesh.points[p]));
  }
  return field;
}

Eigen::Matrix3d diagonal(double x, double y, double z)
{
  return Point3(x, y, z).asDiagonal();
}

ShapedFacets surfaceOf(const SurfaceMesh& mesh, const std::vector<TargetShape>& shapes)
{
  return { mesh.numberOfPoints(), mesh.facetPoints, shapes };
}

IsometricEmbedding embed(const SurfaceMesh& mesh, const Tensor& tensor,
  const RunControl& control = RunControl(), int dimension = 6)
{
  std::vector<TargetShape> shapes;
  CHECK(findTargetShapes(mesh, fieldOf(mesh, tensor), control, shapes).ok());
  IsometricEmbedding embedding;
  IsometryOptions options;
  options.dimension = dimension;
  CHECK(embedIsometrically(surfaceOf(mesh, shapes), options, control, embedding).ok());
  CHECK_EQUAL(embedding.places.rows(), mesh.numberOfPoints());
  CHECK_EQUAL(embedding.places.cols(), dimension);
  CHECK(embedding.places.allFinite());
  CHECK(std::is_sorted(embedding.energies.rbegin(), embedding.energies.rend()));
  return embedding;
}

/** The largest relative error of an edge's length, for a metric that is the same everywhere. */
double worstLength(
  const SurfaceMesh& mesh, const Eigen::Matrix3d& tensor, const IsometricEmbedding& embedding)
{
  double worst = 0.0;
  for (const Triple& points : mesh.facetPoints)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index p = points[k];
      const Index q = points[(k + 1) % 3];
      const Point3 edge = mesh.points[q] - mesh.points[p];
      const double wanted = std::sqrt(edge.dot(tensor * edge));
      const double found = (embedding.places.row(q) - embedding.places.row(p)).norm();
      worst = std::max(worst, std::abs(found / wanted - 1.0));
    }
  }
  return worst;
}

/** A tilted triangle has the edges that the metric gives them; what is across it does not count. */
void testShapes()
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Point3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  for (const double across : { 0.0, 1.0, 1e6 })
  {
    const Eigen::Matrix3d tensor = turn * diagonal(4.0, 0.25, across) * turn.transpose();
    TriangleSoup soup = test::gridPatch(3, 2);
    for (Point3& point : soup.points)
    {
      point = turn * point;
    }
    const SurfaceMesh mesh = test::meshOf(soup);
    std::vector<TargetShape> shapes;
    CHECK(findTargetShapes(
      mesh, fieldOf(mesh, [&](const Point3&) { return tensor; }), RunControl(), shapes)
            .ok());
    for (std::size_t f = 0; f < shapes.size(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Point3 edge =
          mesh.points[mesh.facetPoints[f][(k + 1) % 3]] - mesh.points[mesh.facetPoints[f][k]];
        CHECK_NEAR(shapes[f].edge2(k), edge.dot(tensor * edge), 1e-9);
      }
      // sqrt(4 * 0.25) times the area in R^3
      CHECK_NEAR(shapes[f].area(), 1.0 / 12.0, 1e-9);
    }
  }
}

/** Sums by facets and by points are the same; the factor solves; constants have no gradient. */
void testLaplacian()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 24, 12));
  std::vector<TargetShape> shapes;
  CHECK(findTargetShapes(mesh,
    fieldOf(mesh, [](const Point3& p) { return diagonal(1.0 + p[0] * p[0], 2.0, 3.0); }),
    RunControl(), shapes)
          .ok());
  MetricLaplacian laplacian(surfaceOf(mesh, shapes), RunControl());
  Rows fields(2 * mesh.numberOfFacets(), 3);
  Rows functions(mesh.numberOfPoints(), 3);
  std::uint64_t next = 0;
  for (Rows* rows : { &fields, &functions })
  {
    for (Eigen::Index k = 0; k < rows->size(); ++k)
    {
      rows->data()[k] = uniform01(3, next++, 0) - 0.5;
    }
  }
  double byFacets = 0.0;
  for (Index facet = 0; facet < mesh.numberOfFacets(); ++facet)
  {
    const FacetRows gradient = laplacian.gradient(functions, facet);
    byFacets +=
      laplacian.area(facet) * gradient.cwiseProduct(fields.middleRows(2 * facet, 2)).sum();
  }
  Rows sums;
  CHECK(laplacian.divergence(fields, RunControl(), sums));
  CHECK_NEAR(sums.cwiseProduct(functions).sum(), byFacets, 1e-10);
  CHECK_NEAR(sums.colwise().sum().cwiseAbs().maxCoeff(), 0.0, 1e-10); // against constants

  CHECK(laplacian.factor(RunControl()).ok());
  for (Index facet = 0; facet < mesh.numberOfFacets(); ++facet)
  {
    fields.middleRows(2 * facet, 2) = laplacian.gradient(functions, facet);
  }
  Rows solution;
  CHECK(laplacian.divergence(fields, RunControl(), sums));
  CHECK(laplacian.solve(sums, RunControl(), solution));
  const Rows rest = solution - functions; // the same but for a constant
  CHECK_NEAR((rest.rowwise() - rest.row(0)).cwiseAbs().maxCoeff(), 0.0, 1e-5);
}

/** What can be met exactly is. */
void testKnown()
{
  const SurfaceMesh square = test::meshOf(test::gridPatch(30, 30));
  for (const Eigen::Matrix3d& tensor :
    { diagonal(1.0, 1.0, 1.0), diagonal(100.0, 1.0, 7.0), diagonal(1e-6, 1e2, 1.0) })
  {
    const IsometricEmbedding embedding = embed(
      square, [&](const Point3&) { return tensor; }, RunControl());
    CHECK(worstLength(square, tensor, embedding) < 0.06); // steps end before it is exact
    CHECK(embedding.energies.back() < 1e-3);
  }
  // Its own metric: the surface itself is an answer.
  const SurfaceMesh sphere = test::meshOf(test::icosphere(3));
  const IsometricEmbedding round =
    embed(sphere, [](const Point3&) { return diagonal(1.0, 1.0, 1.0); });
  CHECK(worstLength(sphere, diagonal(1.0, 1.0, 1.0), round) < 0.05);
  for (const auto& [least, most] : round.stretches)
  {
    CHECK(least > 0.9 && most < 1.1);
  }
}

/** Several parts, one of them a single triangle; not orientable; three sheets at an edge. */
void testKinds()
{
  const auto metric = [](const Point3&) { return diagonal(1.0, 4.0, 1.0); };
  TriangleSoup parts = test::icosphere(2);
  test::append(parts, test::gridPatch(9, 9), Point3(5.0, 0.0, 0.0));
  const auto first = static_cast<Offset>(parts.points.size());
  parts.points.insert(parts.points.end(), { { 9, 0, 0 }, { 10, 0, 0 }, { 9, 1, 0 } });
  parts.triangles.push_back({ first, first + 1, first + 2 });
  parts.inputCells.push_back(static_cast<Offset>(parts.inputCells.size()));
  for (const TriangleSoup& soup : { parts, test::moebiusStrip(40), test::threeSheets() })
  {
    const SurfaceMesh mesh = test::meshOf(soup);
    const IsometricEmbedding embedding = embed(mesh, metric);
    CHECK(embedding.energies.back() < 0.02);
    for (const auto& stretch : embedding.stretches)
    {
      CHECK(stretch[0] > 0.5 && stretch[1] < 2.0);
    }
  }
}

void testThreads()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 60, 40));
  const auto metric = [](const Point3& p) { return diagonal(1.0 + 9.0 * p[0] * p[0], 1.0, 2.0); };
  const Rows places = embed(mesh, metric).places;
  for (const Schedule schedule : { Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    RunControl control;
    control.schedule = schedule;
    CHECK(embed(mesh, metric, control).places == places);
  }
}

double areaOf(const std::vector<TargetShape>& shapes)
{
  double area = 0.0;
  for (const TargetShape& shape : shapes)
  {
    area += shape.area();
  }
  return area;
}

Offset eulerOf(Index points, const std::vector<Triple>& facetPoints)
{
  const EdgeTable edges = buildEdgeTable(facetPoints);
  return Offset(points) - edges.numberOfEdges() + static_cast<Offset>(facetPoints.size());
}

/** Fewer points, the same topology and area; functions that are linear in the plane stay so. */
void testCoarsening()
{
  const auto even = [](const Point3&) { return diagonal(1.0, 1.0, 1.0); };
  TriangleSoup two = test::threeSheets();
  test::append(two, test::moebiusStrip(40), Point3(9.0, 0.0, 0.0));
  struct Kind
  {
    TriangleSoup soup;
    double longest;
    double maxPoints; // share of them that is left
  };
  const Kind kinds[] = { { test::gridPatch(40, 30), 0.15, 0.25 },
    { test::torus(1.0, 0.4, 90, 40), 0.3, 0.4 }, { two, 0.2, 1.0 } };
  for (const auto& [soup, longest, maxPoints] : kinds)
  {
    const SurfaceMesh mesh = test::meshOf(soup);
    std::vector<TargetShape> shapes;
    CHECK(findTargetShapes(mesh, fieldOf(mesh, even), RunControl(), shapes).ok());
    CoarseSurface coarse;
    CHECK(coarsen(surfaceOf(mesh, shapes), longest, RunControl(), coarse));
    const auto count = static_cast<Index>(coarse.points.size());
    CHECK(count <= maxPoints * mesh.numberOfPoints());
    CHECK_EQUAL(coarse.points.size() + coarse.removed.size(), mesh.points.size());
    CHECK_EQUAL(
      eulerOf(count, coarse.facetPoints), eulerOf(mesh.numberOfPoints(), mesh.facetPoints));
    CHECK_NEAR(areaOf(coarse.shapes) / areaOf(shapes), 1.0, 0.02);
    for (const TargetShape& shape : coarse.shapes)
    {
      for (int k = 0; k < 3 && maxPoints < 1.0; ++k)
      {
        CHECK(shape.edge2(k) < 1.02 * longest * longest); // layouts differ a little
      }
    }
  }
  const SurfaceMesh square = test::meshOf(test::gridPatch(40, 30));
  std::vector<TargetShape> shapes;
  CHECK(findTargetShapes(square, fieldOf(square, even), RunControl(), shapes).ok());
  CoarseSurface coarse;
  CHECK(coarsen(surfaceOf(square, shapes), 0.2, RunControl(), coarse));
  Rows kept(static_cast<Offset>(coarse.points.size()), 3);
  for (std::size_t p = 0; p < coarse.points.size(); ++p)
  {
    kept.row(static_cast<Offset>(p)) = square.points[coarse.points[p]];
  }
  const Rows all = coarse.prolonged(kept);
  for (Index p = 0; p < square.numberOfPoints(); ++p)
  {
    CHECK_NEAR((all.row(p).transpose() - square.points[p]).norm(), 0.0, 1e-5);
  }
}

/** Conjugate gradients come to the factor's solution; a wave becomes lower by what is told. */
void testMatrix()
{
  const SurfaceMesh mesh = test::meshOf(test::gridPatch(40, 40));
  std::vector<TargetShape> shapes;
  CHECK(findTargetShapes(mesh, fieldOf(mesh, [](const Point3&) { return diagonal(1.0, 1.0, 1.0); }),
    RunControl(), shapes)
          .ok());
  MetricLaplacian laplacian(surfaceOf(mesh, shapes), RunControl());
  LaplacianMatrix matrix(laplacian, RunControl());
  double low = std::numeric_limits<double>::max();
  double high = -low;
  for (const Point3& point : mesh.points)
  {
    low = std::min(low, point[0]);
    high = std::max(high, point[0]);
  }
  const double number = 3.0 * 3.14159265358979323846 / (high - low);
  for (const int dimension : { 6, 2 })
  {
    Rows waves(mesh.numberOfPoints(), dimension); // no slope at the border
    for (Index p = 0; p < mesh.numberOfPoints(); ++p)
    {
      waves.row(p).setConstant(std::cos(number * (mesh.points[p][0] - low)));
    }
    Rows smooth = waves;
    constexpr double time = 0.01;
    CHECK(matrix.smooth(time, RunControl(), smooth));
    const Rows expected = waves / (1.0 + time * number * number);
    CHECK_NEAR((smooth - expected).cwiseAbs().maxCoeff(), 0.0, 0.01);

    Rows right = laplacian.masses().empty()
      ? Rows()
      : Rows(Eigen::Map<const Eigen::VectorXd>(laplacian.masses().data(), mesh.numberOfPoints())
               .asDiagonal() *
          waves);
    right.rowwise() -= right.colwise().mean();
    Rows exact;
    Rows near;
    CHECK(laplacian.factor(RunControl()).ok());
    CHECK(laplacian.solve(right, RunControl(), exact));
    CHECK(matrix.approach(right, 400, RunControl(), near));
    const Rows rest = near - exact; // the same but for a constant
    CHECK_NEAR((rest.rowwise() - rest.row(0)).cwiseAbs().maxCoeff(), 0.0, 1e-4);
  }
}

/** By way of a coarse surface: the lengths of the metric, the same bytes, and an end when told. */
void testCoarseStart()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 200, 100));
  std::vector<TargetShape> shapes;
  CHECK(findTargetShapes(mesh,
    fieldOf(mesh, [](const Point3& p) { return diagonal(4.0 + 3.0 * p[0], 4.0, 6.0); }),
    RunControl(), shapes)
          .ok());
  IsometryOptions options;
  options.unit = 0.4;
  IsometricEmbedding first;
  CHECK(embedIsometrically(surfaceOf(mesh, shapes), options, RunControl(), first).ok());
  CHECK(first.energies.back() < 2e-3);
  CHECK(std::is_sorted(first.energies.rbegin(), first.energies.rend()));
  std::size_t met = 0;
  for (const auto& [least, most] : first.stretches)
  {
    met += least > 0.85 && most < 1.15;
  }
  CHECK(met > 0.98 * shapes.size());
  RunControl threads;
  threads.schedule = Schedule::EightThreads;
  IsometricEmbedding second;
  CHECK(embedIsometrically(surfaceOf(mesh, shapes), options, threads, second).ok());
  CHECK(first.places == second.places);

  test::checkCancels(
    "embedding with a coarse start",
    [&](const RunControl& control)
    { return embedIsometrically(surfaceOf(mesh, shapes), options, control, second); },
    20);
}

void testFailures()
{
  const SurfaceMesh mesh = test::meshOf(test::gridPatch(4, 4));
  std::vector<TargetShape> shapes;
  const Status flat = findTargetShapes(mesh,
    fieldOf(mesh, [](const Point3&) { return diagonal(1e-320, 1e-320, 1.0); }), RunControl(),
    shapes);
  CHECK(flat.code == StatusCode::InvalidInput);
  CHECK(flat.message.find("Cell 0 ") == 0);

  const MetricField field = fieldOf(mesh, [](const Point3&) { return diagonal(1.0, 1.0, 1.0); });
  CHECK(findTargetShapes(mesh, field, RunControl(), shapes).ok());
  test::checkCancels("isometric embedding",
    [&](const RunControl& control)
    {
      IsometricEmbedding embedding;
      return embedIsometrically(surfaceOf(mesh, shapes), {}, control, embedding);
    });
}
}

int TestIsometricEmbedding(int, char*[])
{
  testShapes();
  testLaplacian();
  testKnown();
  testKinds();
  testThreads();
  testCoarsening();
  testMatrix();
  testCoarseStart();
  testFailures();
  return test::result();
}
