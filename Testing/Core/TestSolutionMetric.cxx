// Metric/: second derivatives of known functions and surfaces, metrics by their formulas, limits,
// intersections, creases, the same bytes on any threads.

#include "Metric/QuadraticFit.h"
#include "Metric/SolutionMetric.h"
#include "Metric/TensorAlgebra.h"
#include "Support/Random.h"
#include "TestCancels.h"
#include "TestSupport.h"

#include <cmath>
#include <functional>

using namespace remesh;
using namespace remesh::test;

namespace
{
using Function = std::function<double(const Point3&)>;

Rows valuesOf(const SurfaceMesh& mesh, const std::vector<Function>& functions)
{
  Rows values(mesh.numberOfPoints(), static_cast<Eigen::Index>(functions.size()));
  for (Index p = 0; p < mesh.numberOfPoints(); ++p)
  {
    for (std::size_t k = 0; k < functions.size(); ++k)
    {
      values(p, static_cast<Eigen::Index>(k)) = functions[k](mesh.points[p]);
    }
  }
  return values;
}

struct Fitted
{
  SurfaceSides sides;
  QuadraticFits fits;
};

void fit(const SurfaceMesh& mesh, const std::vector<Function>& functions, Fitted& fitted)
{
  CHECK(fitted.sides.build(mesh, RunControl()).ok());
  CHECK(fitQuadratics(fitted.sides, valuesOf(mesh, functions), RunControl(), fitted.fits).ok());
}

/** A square of 1 whose inner points are moved at random. */
SurfaceMesh jitteredSquare(int n)
{
  TriangleSoup soup = gridPatch(n, n);
  for (std::size_t p = 0; p < soup.points.size(); ++p)
  {
    Point3& point = soup.points[p];
    for (int c = 0; c < 2; ++c)
    {
      const bool isInside = point[c] > 0.5 / n && point[c] < 1.0 - 0.5 / n;
      point[c] += isInside ? 0.5 / n * (uniform01(1, p, static_cast<std::uint64_t>(c)) - 0.5) : 0.0;
    }
  }
  return meshOf(soup);
}

Eigen::Matrix3d inSpace(const Tensor2& tensor, const FittedSide& side)
{
  return tensor.xx * side.x * side.x.transpose() + tensor.yy * side.y * side.y.transpose() +
    tensor.xy * (side.x * side.y.transpose() + side.y * side.x.transpose());
}

void testQuadraticOnPlane()
{
  const SurfaceMesh mesh = jitteredSquare(12);
  Fitted fitted;
  fit(mesh, { [](const Point3& p) {
    return 3.0 + p[0] - 2.0 * p[1] + 1.5 * p[0] * p[0] + 0.7 * p[0] * p[1] - p[1] * p[1];
  } },
    fitted);
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  expected.topLeftCorner<2, 2>() << 3.0, 0.7, 0.7, -2.0;
  CHECK_EQUAL(fitted.fits.sides.size(), mesh.points.size()); // no creases
  for (std::size_t s = 0; s < fitted.fits.sides.size(); ++s)
  {
    const FittedSide& side = fitted.fits.sides[s];
    const Eigen::Matrix3d found = inSpace(fitted.fits.hessian(s, 0), side);
    CHECK_NEAR((found - expected).cwiseAbs().maxCoeff(), 0.0, 1e-9);
    CHECK_NEAR(std::abs(side.bend.xx) + std::abs(side.bend.xy) + std::abs(side.bend.yy), 0.0, 1e-9);
  }
}

/** On the unit sphere all curvatures are 1, and z has the Hessian -z times the identity. */
void testSphere()
{
  const SurfaceMesh mesh = meshOf(icosphere(4));
  Fitted fitted;
  fit(mesh, { [](const Point3& p) { return p[2]; } }, fitted);
  for (std::size_t s = 0; s < fitted.fits.sides.size(); ++s)
  {
    const double z = mesh.points[fitted.sides.sides()[s].point][2];
    const Tensor2& h = fitted.fits.hessian(s, 0);
    CHECK_NEAR(h.xx, -z, 0.01);
    CHECK_NEAR(h.yy, -z, 0.01);
    CHECK_NEAR(h.xy, 0.0, 0.01);
    const Spectrum2 bend = spectrumOf(absolute(fitted.fits.sides[s].bend));
    CHECK_NEAR(bend.first, 1.0, 0.01);
    CHECK_NEAR(bend.second, 1.0, 0.01);
  }
}

/** A function that is linear on each face of a cube, and has a kink at each of its edges. */
void testCreases()
{
  TriangleSoup soup = gridPatch(6, 6);
  TriangleSoup wall = gridPatch(6, 6); // stands on the line y = 0
  for (Point3& p : wall.points)
  {
    p = { p[0], 0.0, p[1] };
  }
  append(soup, wall, Point3::Zero());
  const SurfaceMesh mesh = meshOf(soup);
  CHECK_EQUAL(mesh.numberOfPoints(), 7 * 13);
  Fitted fitted;
  fit(mesh, { [](const Point3& p) { return p[1] + 5.0 * p[2] - p[0]; } }, fitted);
  CHECK_EQUAL(fitted.fits.sides.size(), 7u * 14u); // two for each point of the crease
  for (std::size_t s = 0; s < fitted.fits.sides.size(); ++s)
  {
    const Tensor2& h = fitted.fits.hessian(s, 0);
    const Tensor2& bend = fitted.fits.sides[s].bend;
    CHECK_NEAR(std::abs(h.xx) + std::abs(h.xy) + std::abs(h.yy), 0.0, 1e-9);
    CHECK_NEAR(std::abs(bend.xx) + std::abs(bend.xy) + std::abs(bend.yy), 0.0, 1e-9);
  }
}

void testIntersection()
{
  for (std::uint64_t k = 0; k < 200; ++k)
  {
    const auto draw = [&](std::uint64_t stream)
    {
      const double angle = 2.0 * pi * uniform01(k, 0, stream);
      return Spectrum2{ std::pow(10.0, 4.0 * uniform01(k, 1, stream)),
        std::pow(10.0, 4.0 * uniform01(k, 2, stream) - 4.0), std::cos(angle), std::sin(angle) }
        .tensor();
    };
    const Tensor2 a = draw(1);
    const Tensor2 b = draw(2);
    const Tensor2 both = intersection(a, b);
    // No direction is longer than in either, and along two it is as in one of them: det = product
    // of the larger ones of the generalized eigenvalues.
    for (int step = 0; step < 64; ++step)
    {
      const double x = std::cos(pi * step / 64.0);
      const double y = std::sin(pi * step / 64.0);
      const double most = std::max(a.squared(x, y), b.squared(x, y));
      CHECK(both.squared(x, y) >= most * (1.0 - 1e-6));
    }
    const double trace = (a.yy * b.xx - 2.0 * a.xy * b.xy + a.xx * b.yy) / a.determinant();
    const double product = b.determinant() / a.determinant();
    const double root = std::sqrt(std::max(0.25 * trace * trace - product, 0.0));
    const double large = 0.5 * trace + root;
    const double expected = a.determinant() * std::max(large, 1.0) * std::max(product / large, 1.0);
    CHECK_NEAR(both.determinant() / expected, 1.0, 1e-6);
  }
}

SolutionMetric metricOf(const SurfaceMesh& mesh, const SolutionMetricInput& input,
  const SolutionMetricOptions& options, const RunControl& control = RunControl())
{
  SolutionMetric metric;
  CHECK(makeSolutionMetric(mesh, input, options, control, metric).ok());
  CHECK_EQUAL(metric.tensors.size(), mesh.points.size());
  return metric;
}

/** The points that the tensors of a flat mesh ask for. */
double pointsOf(const SurfaceMesh& mesh, const SolutionMetric& metric)
{
  double sum = 0.0;
  for (const Triple& points : mesh.facetPoints)
  {
    const Point3 first = mesh.points[points[1]] - mesh.points[points[0]];
    const Point3 second = mesh.points[points[2]] - mesh.points[points[0]];
    for (const Index p : points)
    {
      const auto& m = metric.tensors[p];
      sum += first.cross(second).norm() / 6.0 * std::sqrt(m[0] * m[3] - m[1] * m[1]);
    }
  }
  return 2.0 / std::sqrt(3.0) * sum;
}

void testFormula()
{
  const SurfaceMesh mesh = jitteredSquare(20);
  SolutionMetricInput input;
  input.values =
    valuesOf(mesh, { [](const Point3& p) { return 4.5 * p[0] * p[0] - 0.5 * p[1] * p[1]; } });
  input.components = { 1 };
  SolutionMetricOptions options;
  options.numberOfPoints = 300;
  for (const ErrorNorm norm : { ErrorNorm::L1, ErrorNorm::L2, ErrorNorm::L4, ErrorNorm::Maximum })
  {
    options.norm = norm;
    const SolutionMetric metric = metricOf(mesh, input, options);
    // The same everywhere: 3 times as dense along x, and the points' number in all.
    const double along = 300.0 * std::sqrt(3.0) / 2.0;
    for (const Symmetric3<double>& m : metric.tensors)
    {
      CHECK_NEAR(m[0] / (3.0 * along), 1.0, 1e-4);
      CHECK_NEAR(m[3] / (along / 3.0), 1.0, 1e-4);
      CHECK_NEAR(m[1] / along, 0.0, 1e-6);
      CHECK_NEAR(m[5] / (along / 3.0), 1.0, 1e-4); // across the surface
    }
    CHECK_NEAR(metric.points, 300.0, 0.01);
    CHECK_NEAR(pointsOf(mesh, metric), 300.0, 0.01);
  }
}

/** Densities where second derivatives are 1 and 64: 64^(2 p / (2 p + 2)). */
void testNorms()
{
  const SurfaceMesh mesh = meshOf(gridPatch(20, 20));
  SolutionMetricInput input;
  auto& hessians = input.hessians.emplace_back();
  for (const Point3& p : mesh.points)
  {
    const double value = p[0] > 0.49 ? -64.0 : 1.0; // signs do not count
    Symmetric3<double> tensor;
    tensor << value, 0.0, 7.0, value, 5.0, 9.0; // nor does what is across
    hessians.push_back(tensor);
  }
  const std::pair<ErrorNorm, double> cases[] = { { ErrorNorm::L1, 0.5 },
    { ErrorNorm::L2, 2.0 / 3.0 }, { ErrorNorm::L4, 0.8 }, { ErrorNorm::Maximum, 1.0 } };
  for (const auto& [norm, exponent] : cases)
  {
    SolutionMetricOptions options;
    options.norm = norm;
    options.numberOfPoints = 5000;
    const SolutionMetric metric = metricOf(mesh, input, options);
    double values[2] = { 0.0, 0.0 };
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      values[mesh.points[p][0] > 0.49 ? 1 : 0] = metric.tensors[p][0];
    }
    CHECK_NEAR(values[1] / values[0] / std::pow(64.0, exponent), 1.0, 1e-6);
    CHECK_NEAR(metric.points, 5000.0, 0.1);
  }
}

/** Vectors: the root of the sum of squares, whatever the axes. */
void testVectors()
{
  const SurfaceMesh mesh = meshOf(gridPatch(16, 16));
  SolutionMetricInput input;
  input.values = valuesOf(mesh,
    { [](const Point3& p) { return 3.0 * p[0] * p[0]; },
      [](const Point3& p) { return 4.0 * p[0] * p[0]; },
      [](const Point3& p) { return p[1] * p[1]; } });
  input.components = { 3 };
  SolutionMetricOptions options;
  options.numberOfPoints = 1000;
  const SolutionMetric metric = metricOf(mesh, input, options);
  for (const Symmetric3<double>& m : metric.tensors)
  {
    CHECK_NEAR(m[0] / m[3], 10.0 / 2.0, 1e-6); // second derivatives 6 and 8, and 2
  }
}

/** Two functions of different units count alike: each along its own axis. */
void testSeveral()
{
  const SurfaceMesh mesh = meshOf(gridPatch(16, 16));
  SolutionMetricInput input;
  input.values = valuesOf(mesh,
    { [](const Point3& p) { return 1e-9 * (25.0 * p[0] * p[0] + p[1] * p[1]); },
      [](const Point3& p) { return 1e9 * (25.0 * p[1] * p[1] + p[0] * p[0]); } });
  input.components = { 1, 1 };
  SolutionMetricOptions options;
  options.numberOfPoints = 1000;
  const SolutionMetric metric = metricOf(mesh, input, options);
  for (const Symmetric3<double>& m : metric.tensors)
  {
    CHECK_NEAR(m[0] / (500.0 * std::sqrt(3.0)), 1.0, 1e-4);
    CHECK_NEAR(m[3] / m[0], 1.0, 1e-4);
  }
}

void testLimits()
{
  const SurfaceMesh mesh = meshOf(gridPatch(40, 40));
  SolutionMetricInput input;
  input.values = valuesOf(mesh, { [](const Point3& p) { return std::tanh(20.0 * (p[0] - 0.5)); } });
  input.components = { 1 };
  SolutionMetricOptions options;
  options.numberOfPoints = 500;
  options.minimumSize = 0.02;
  options.maximumSize = 0.1;
  options.maximumRatio = 4.0;
  const SolutionMetric metric = metricOf(mesh, input, options);
  CHECK_NEAR(pointsOf(mesh, metric), 500.0, 0.1);
  double least = 1.0;
  for (const Symmetric3<double>& m : metric.tensors)
  {
    CHECK(m[0] <= 16.0 * m[3] * (1.0 + 1e-6));
    CHECK(m[3] >= 100.0 * (1.0 - 1e-6));
    CHECK(m[0] <= 2500.0 * (1.0 + 1e-6));
    least = std::min(least, 1.0 / std::sqrt(m[0]));
  }
  CHECK(least < 0.05);
  // What all but the solution asks for, and what the smallest size allows for.
  options.numberOfPoints = 50;
  CHECK_NEAR(metricOf(mesh, input, options).minPoints, 200.0 / std::sqrt(3.0), 0.01);
  CHECK_NEAR(metricOf(mesh, input, options).points, 200.0 / std::sqrt(3.0), 0.01);
  options.numberOfPoints = 1e6;
  CHECK(metricOf(mesh, input, options).points < 5000.0 / std::sqrt(3.0) + 0.01);
  input.values.setZero();
  CHECK(metricOf(mesh, input, options).isConstant);
}

/** An arc's edge of length h is h^2 / 8 r away from it. */
void testChord()
{
  const SurfaceMesh mesh = meshOf(torus(4.0, 1.0, 160, 80));
  SolutionMetricInput input;
  input.values.resize(mesh.numberOfPoints(), 0);
  SolutionMetricOptions options;
  options.chordTolerance = 0.002;
  const SolutionMetric metric = metricOf(mesh, input, options);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    const Point3& at = mesh.points[p];
    const double around = std::hypot(at[0], at[1]);
    const Point3 spoke(at[0] / around, at[1] / around, 0.0);
    const Point3 outward = at - 4.0 * spoke; // unit
    const Point3 rib = outward.cross(Point3(-spoke[1], spoke[0], 0.0));
    const double along = rib.dot(multiply(metric.tensors[p], rib));
    CHECK_NEAR(std::sqrt(8.0 * 0.002 * along), 1.0, 0.02);
    const Point3 ring(-spoke[1], spoke[0], 0.0);
    const double curvature = std::abs(outward.dot(spoke)) / around;
    CHECK_NEAR(8.0 * 0.002 * ring.dot(multiply(metric.tensors[p], ring)), curvature, 0.01);
  }
  // Sizes that are smaller win, and larger ones do not.
  input.sizes.assign(mesh.points.size(), 0.05);
  CHECK_NEAR(
    metricOf(mesh, input, options).points / (2.0 / std::sqrt(3.0) * 400.0 * surfaceArea(mesh)), 1.0,
    1e-6);
  input.sizes.assign(mesh.points.size(), 100.0);
  CHECK_NEAR(metricOf(mesh, input, options).points / metric.points, 1.0, 1e-6);
}

void testThreads()
{
  const SurfaceMesh mesh = meshOf(torus(3.0, 1.0, 200, 100));
  SolutionMetricInput input;
  input.values = valuesOf(mesh,
    { [](const Point3& p) { return std::sin(3.0 * p[0] * p[1]); },
      [](const Point3& p) { return std::exp(p[2]); } });
  input.components = { 2 };
  SolutionMetricOptions options;
  options.chordTolerance = 0.05;
  const SolutionMetric expected = metricOf(mesh, input, options);
  for (const Schedule schedule : { Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    RunControl control;
    control.schedule = schedule;
    const SolutionMetric metric = metricOf(mesh, input, options, control);
    CHECK(metric.points == expected.points);
    CHECK(metric.tensors == expected.tensors);
  }
  checkCancels("solution metric",
    [&](const RunControl& control)
    {
      SolutionMetric none;
      return makeSolutionMetric(mesh, input, options, control, none);
    });
}
}

int TestSolutionMetric(int, char*[])
{
  testQuadraticOnPlane();
  testSphere();
  testCreases();
  testIntersection();
  testFormula();
  testNorms();
  testVectors();
  testSeveral();
  testLimits();
  testChord();
  testThreads();
  return result();
}
