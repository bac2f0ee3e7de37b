// Features/CurveSampling: as many points on curves and beside them as there are to be, at one
// spacing; few enough for small holes; it can be cancelled between any two tries, and then tries no
// more; places at a distance from an end.

#include "Features/CurveSampling.h"
#include "Features/FeatureGraph.h"
#include "TestEmbeddings.h"

#include <cmath>
#include <limits>

using namespace remesh;

namespace
{
/** A flat sheet with a wavy border of 480 edges. */
SurfaceMesh wavySheet()
{
  TriangleSoup soup = test::gridPatch(120, 120);
  for (Point3& point : soup.points)
  {
    const double x = point.x() - 0.5;
    const double y = point.y() - 0.5;
    const double wave = 1.0 + 0.1 * std::sin(30.0 * std::atan2(y, x));
    point = Point3(wave * x, wave * y, 0.0);
  }
  return test::meshOf(soup);
}

struct Asked
{
  int questions = 0;
  Offset points = 0; ///< on the curves
};

/** Cancelled at this question, from 0, and asked how often? */
Asked cancelledAt(
  int question, const SurfaceMesh& mesh, const EmbeddedSurface& surface, const Features& features)
{
  Asked asked;
  const RunControl control({}, [&]() { return asked.questions++ >= question; });
  CurveSampler sampler({ mesh, surface, features }, { 100 });
  sampler.limitBends(control);
  sampler.findSpacing(0, control);
  for (const std::vector<Station>& places : sampler.stations())
  {
    asked.points += static_cast<Offset>(places.size());
  }
  return asked;
}
}

namespace
{
/** A place at a point is one of the segment that begins there, from whichever end it is found. */
void testRadius()
{
  SurfaceMesh mesh;
  FeatureCurve curve;
  for (Index k = 0; k < 5; ++k)
  {
    mesh.points.emplace_back(k, 0.0, 0.0);
    curve.points.push_back(k);
  }
  curve.edges.assign(4, 0);
  for (int eighth = 0; eighth <= 32; ++eighth)
  {
    const double radius = eighth / 8.0;
    for (const bool fromFront : { true, false })
    {
      const Station place = stationAtRadius(mesh, curve, fromFront, radius);
      const double x = fromFront ? radius : 4.0 - radius;
      CHECK_EQUAL(place.segment + place.t, x);
      CHECK(place.t < 1.0 || x == 4.0);
    }
  }
}
}

namespace
{
/** A flat sheet: the row of half cells along its border is part of what there is to fill. */
void testSheet()
{
  SurfaceMesh mesh = test::meshOf(test::gridPatch(10, 10));
  const Features features = findFeatures(mesh, FeatureOptions());
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  for (const Offset points : { 200, 2000, 20000 })
  {
    CurveSampler sampler({ mesh, surface, features }, { points });
    CHECK_EQUAL(sampler.limitBends(RunControl()), 4); // the corners
    for (const Offset others : { Offset(0), points / 10 })
    {
      sampler.findSpacing(others, RunControl());
      const double h = sampler.spacing() * surface.unit;
      const auto border = static_cast<double>(countFeaturePoints(features, sampler.stations()));
      CHECK_NEAR(border, 4.0 / h, 4.0);
      const double inside = (1.0 - 4.0 * h * std::sqrt(3.0) / 4.0) / (h * h * std::sqrt(0.75));
      CHECK_NEAR(border + inside + static_cast<double>(others), points, 4.0 + 5e-3 * points);
    }
  }
}

/** A sheet with round holes much smaller than the spacing. */
void testSmallHoles()
{
  constexpr int holes = 12;
  TriangleSoup soup;
  const TriangleSoup hole = test::ringInSquare(96, 0.05);
  for (int k = 0; k < holes * holes; ++k)
  {
    test::append(soup, hole, Point3(2 * (k % holes), 2 * (k / holes), 0.0));
  }
  SurfaceMesh mesh = test::meshOf(soup);
  const Features features = findFeatures(mesh, FeatureOptions());
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  const auto pointsFor = [&](Offset points, double maxError)
  {
    CurveSampler sampler({ mesh, surface, features }, { points, maxError });
    return sampler.limitBends(RunControl());
  };
  const double any = std::numeric_limits<double>::infinity();
  const Offset all = pointsFor(100000, any);
  CHECK_EQUAL(all, holes * holes * (16 + 4));
  const Offset few = pointsFor(2 * all, any);
  CHECK(3 * few <= 2 * all && 4 * few > 2 * all);
  CHECK_EQUAL(pointsFor(100, any), holes * holes * (3 + 4)); // it takes no less
  CHECK(pointsFor(100, 1e-5) > all);                         // what is asked for is kept
}
}

int TestCurveSampling(int, char*[])
{
  testRadius();
  testSheet();
  testSmallHoles();
  SurfaceMesh mesh = wavySheet();
  const Features features = findFeatures(mesh, FeatureOptions());
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  const Asked whole = cancelledAt(1000, mesh, surface, features);
  CHECK(whole.questions >= 6); // there are some tries
  CHECK(whole.questions < 1000);
  CHECK(whole.points > 20);
  CHECK_EQUAL(cancelledAt(0, mesh, surface, features).points, 0);
  for (int question = 0; question < whole.questions; ++question)
  {
    CHECK(cancelledAt(question, mesh, surface, features).questions <= question + 4);
  }
  return test::result();
}
