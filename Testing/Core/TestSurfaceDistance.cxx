// Distances between surfaces by formula, the bound of the maximum, and the same bytes whatever the
// schedule.

#include "Comparison/Comparison.h"
#include "Comparison/NormalDeviation.h"
#include "TestTriangles.h"

#include <Eigen/Geometry>

#include <cstring>

using namespace remesh;
using namespace remesh::test;

namespace
{
DistanceOptions quick()
{
  DistanceOptions options;
  options.numberOfSamples = 20000;
  return options;
}

TwoSidedDistance distanceOf(
  const TriangleSoup& first, const TriangleSoup& second, const DistanceOptions& options = quick())
{
  const Surface a(first);
  const Surface b(second);
  TwoSidedDistance distance;
  CHECK(measureTwoSidedDistance(a.view(), b.view(), options, RunControl(), distance).ok());
  return distance;
}

TriangleSoup turnedAroundY(TriangleSoup soup, double degrees)
{
  const Eigen::AngleAxisd turn(-degrees * pi / 180.0, Point3::UnitY());
  for (Point3& point : soup.points)
  {
    point = turn * point;
  }
  return soup;
}

void testPlanes()
{
  const double height = 0.25;
  const TwoSidedDistance distance = distanceOf(gridPatch(4, 3), gridPatch(7, 5, { 0, 0, height }));
  for (const OneSidedDistance& each : { distance.forward, distance.backward })
  {
    CHECK_NEAR(each.area, 1.0, 1e-12);
    CHECK_NEAR(each.mean, height, 1e-14);
    CHECK_NEAR(each.rms, height, 1e-14);
    CHECK_NEAR(each.maximum, height, 1e-14);
    CHECK_NEAR(each.maximumBound, height, 0.01 * height + 1e-14);
  }

  // A square that rises from x = 0 by 30 degrees over a larger plane: the distance is x' / 2, with
  // x' from 0 to 1, and the quadrature is exact for its square.
  const TriangleSoup plane = scaled(gridPatch(40, 40, { -0.5, -0.5, 0.0 }), 3.0);
  const TwoSidedDistance tilted = distanceOf(turnedAroundY(gridPatch(2, 3), 30.0), plane);
  CHECK_NEAR(tilted.forward.mean, 0.25, 1e-13);
  CHECK_NEAR(tilted.forward.rms, std::sqrt(1.0 / 12.0), 1e-13);
  CHECK_NEAR(tilted.forward.maximum, 0.5, 1e-14);
  CHECK(tilted.forward.maximumBound >= 0.5 - 1e-14 && tilted.forward.maximumBound <= 0.506);
  CHECK(tilted.backward.maximum > 1.9); // the corner of the plane at (-1.5, -1.5)
}

/** A sphere that crosses each triangle: few samples give what many do. */
void testFewSamples()
{
  const TriangleSoup coarse = scaled(icosphere(3), 1.0036);
  const TriangleSoup fine = icosphere(6);
  DistanceOptions options = quick();
  options.boundTolerance = -1.0;
  options.numberOfSamples = 400000;
  const TwoSidedDistance exact = distanceOf(coarse, fine, options);
  options.numberOfSamples = 3 * static_cast<Offset>(coarse.triangles.size());
  const TwoSidedDistance rough = distanceOf(coarse, fine, options);
  CHECK_NEAR(rough.forward.rms, exact.forward.rms, 0.02 * exact.forward.rms);
  CHECK_NEAR(rough.backward.rms, exact.backward.rms, 0.02 * exact.backward.rms);
}

/** A polyhedron in the unit sphere, and the same 10 % larger. */
void testSpheres()
{
  const TriangleSoup small = icosphere(2);
  double farthestFacet = 0.0;
  for (const auto& [a, b, c] : small.triangles)
  {
    const Point3 p = small.points[a];
    const Point3 normal = (small.points[b] - p).cross(small.points[c] - p).normalized();
    farthestFacet = std::max(farthestFacet, normal.dot(p));
  }
  DistanceOptions options = quick();
  options.boundTolerance = 1e-4;
  const TwoSidedDistance distance = distanceOf(scaled(small, 1.1), small, options);
  // Outward, a convex function: largest at the corners, above which the corners below lie.
  CHECK_NEAR(distance.forward.maximum, 0.1, 1e-14);
  CHECK(distance.forward.maximumBound >= 0.1 - 1e-14);
  CHECK(distance.forward.maximumBound <= 0.1 * (1.0 + 1.1e-4));
  // From inside, the distance to the planes of the facets.
  CHECK_NEAR(distance.backward.maximum, 0.1 * farthestFacet, 1e-12);
  CHECK(distance.backward.maximumBound >= 0.1 * farthestFacet - 1e-12);
  CHECK(distance.backward.maximumBound <= 0.1 * farthestFacet * (1.0 + 1.1e-4));
  CHECK(distance.maximum() == distance.forward.maximum);
  CHECK_NEAR(
    distance.rms(), std::hypot(distance.forward.rms, distance.backward.rms) / std::sqrt(2), 1e-15);
}

/** Much denser samples than the bound was made with never pass it; few find nearly the maximum. */
void testBound()
{
  const TriangleSoup coarse = torus(1.0, 0.4, 11, 7);
  const TriangleSoup fine = torus(1.0, 0.4, 61, 43);
  DistanceOptions few;
  few.numberOfSamples = 100;
  DistanceOptions many;
  many.numberOfSamples = 300000;
  many.boundTolerance = -1.0;
  const TwoSidedDistance bounded = distanceOf(coarse, fine, few);
  const TwoSidedDistance sampled = distanceOf(coarse, fine, many);
  CHECK(std::isinf(sampled.maximumBound()));
  for (const bool forward : { true, false })
  {
    const OneSidedDistance& a = forward ? bounded.forward : bounded.backward;
    const OneSidedDistance& b = forward ? sampled.forward : sampled.backward;
    CHECK(a.maximumBound >= b.maximum);
    CHECK(a.maximumBound <= 1.01 * a.maximum);
    CHECK(a.maximum >= b.maximum / 1.01);
  }
  CHECK_NEAR(bounded.rms(), sampled.rms(), 0.05 * sampled.rms());

  // It holds, and is larger, where the effort ends early; also with none at all.
  double before = bounded.maximumBound();
  for (const Offset parts : { 2000, 100, 3, 0 })
  {
    few.maximumParts = parts;
    const TwoSidedDistance hasty = distanceOf(coarse, fine, few);
    CHECK(hasty.maximumBound() >= sampled.maximum());
    CHECK(hasty.maximumBound() >= before);
    before = hasty.maximumBound();
  }

  // A surface is nowhere away from itself, cut otherwise or not.
  DistanceOptions options = quick();
  options.negligible = 0.01;
  const TwoSidedDistance none = distanceOf(fine, fine, options);
  CHECK_NEAR(none.maximum(), 0.0, 1e-15);
  CHECK(none.maximumBound() <= 0.01);
  const TwoSidedDistance same = distanceOf(gridPatch(3, 2), gridPatch(5, 7), options);
  CHECK_NEAR(same.maximum(), 0.0, 1e-15);
  CHECK(same.maximumBound() <= 0.01);
}

/** Two ways to cut up the sides of a box: soon known to be nowhere away from each other. */
void testFlatSides()
{
  TriangleSoup turned;
  for (const double z : { 0.0, 1.0 })
  {
    append(turned, gridPatch(17, 13, { 0.0, 0.0, z }), Point3::Zero());
    append(turned, turnedAroundY(gridPatch(7, 19), 90.0), Point3(z, 0.0, 0.0));
  }
  TriangleSoup plain;
  for (const double z : { 0.0, 1.0 })
  {
    append(plain, gridPatch(5, 6, { 0.0, 0.0, z }), Point3::Zero());
    append(plain, turnedAroundY(gridPatch(11, 3), 90.0), Point3(z, 0.0, 0.0));
  }
  DistanceOptions options = quick();
  options.negligible = 1e-7;
  options.maximumParts = 50000;
  const TwoSidedDistance distance = distanceOf(turned, plain, options);
  CHECK_NEAR(distance.maximum(), 0.0, 1e-14);
  CHECK(distance.maximumBound() <= 1e-7);
}

void testFailures()
{
  const Surface good(cube());
  const Surface thin = surfaceWithoutArea();
  TwoSidedDistance distance;
  const auto codeOf = [&](const Surface& a, const Surface& b, const RunControl& control)
  { return measureTwoSidedDistance(a.view(), b.view(), {}, control, distance).code; };
  CHECK(codeOf(good, thin, {}) == StatusCode::InvalidInput);
  CHECK(codeOf(thin, good, {}) == StatusCode::InvalidInput);
  const RunControl stop([](double, const char*) {}, []() { return true; });
  CHECK(codeOf(good, good, stop) == StatusCode::Cancelled);

  Comparison comparison;
  const Triangles view = thin.view();
  Status status = compareSurfaces(good.view(), &view, {}, RunControl(), comparison);
  CHECK(status.code == StatusCode::InvalidInput);
  CHECK(status.message.find("reference surface") != std::string::npos);
  status = compareSurfaces(good.view(), nullptr, {}, stop, comparison);
  CHECK(status.code == StatusCode::Cancelled);
}

void testNormals()
{
  TriangleSoup patch = turnedAroundY(gridPatch(4, 4, { 1, 1, 0 }), 30.0);
  flip(patch, 5);
  patch.triangles.push_back({ 0, 1, 1 });
  const Surface mesh(patch);
  const Surface plane(scaled(gridPatch(5, 5), 4.0));
  const TriangleTree tree(plane.view());
  std::vector<double> degrees;
  CHECK(measureNormalDeviations(mesh.view(), tree, 5.0, RunControl(), degrees).ok());
  for (std::size_t t = 0; t + 1 < degrees.size(); ++t)
  {
    CHECK_NEAR(degrees[t], t == 5 ? 150.0 : 30.0, 1e-12);
  }
  CHECK(std::isnan(degrees.back()));

  // Centroids over the ridge of a roof of 2 * 45 degrees are as close to either side: each takes
  // the side that it faces most alike, though only one of them can come first.
  const Surface roof(
    makeSoup({ { 0, 0, 0 }, { 0, 3, 0 }, { 1, 0, -1 }, { 1, 3, -1 }, { -1, 0, -1 }, { -1, 3, -1 } },
      { { 0, 2, 3 }, { 0, 3, 1 }, { 0, 5, 4 }, { 0, 1, 5 } }));
  const TriangleTree ridge(roof.view());
  for (const double lean : { 30.0, -30.0 })
  {
    const TriangleSoup leaning =
      makeSoup({ { -1, 1, 0 }, { 1, 0.5, 0 }, { 0, 2, 0 } }, { { 0, 1, 2 } });
    TriangleSoup turned = turnedAroundY(leaning, lean);
    for (Point3& point : turned.points)
    {
      point.z() += 1.0;
    }
    const Surface over(turned);
    CHECK(measureNormalDeviations(over.view(), ridge, 5.0, RunControl(), degrees).ok());
    CHECK_NEAR(degrees[0], 15.0, 1e-10);
  }
}

/** All numbers of a comparison, one after the other. */
std::string bytesOf(const Comparison& comparison)
{
  std::string bytes;
  const auto add = [&](const auto& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
  };
  for (const OneSidedDistance* each :
    { &comparison.distance.forward, &comparison.distance.backward })
  {
    add(
      std::vector<double>{ each->area, each->mean, each->rms, each->maximum, each->maximumBound });
  }
  add(comparison.qualities);
  add(comparison.normalDeviations);
  for (const PointDistances* each : { &comparison.meshPoints, &comparison.referencePoints })
  {
    add(each->distances);
    add(each->behind);
  }
  return bytes;
}

void testSchedules()
{
  const Surface mesh(torus(1.0, 0.4, 50, 40));
  const Surface reference(torus(1.0, 0.4, 110, 90));
  std::string expected;
  for (const Schedule schedule :
    { Schedule::Smp, Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    RunControl control;
    control.schedule = schedule;
    Comparison comparison;
    const Triangles view = reference.view();
    DistanceOptions options = quick();
    options.maximumParts = 50000;
    CHECK(compareSurfaces(mesh.view(), &view, options, control, comparison).ok());
    const std::string bytes = bytesOf(comparison);
    expected = expected.empty() ? bytes : expected;
    CHECK(bytes.size() > 100000 && bytes == expected);
  }
}
}

int TestSurfaceDistance(int, char*[])
{
  testPlanes();
  testFewSamples();
  testSpheres();
  testBound();
  testFlatSides();
  testFailures();
  testNormals();
  testSchedules();
  return result();
}
