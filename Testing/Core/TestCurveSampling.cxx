// Features/CurveSampling: it can be cancelled between any two tries, and then tries no more; places
// at a distance from an end.

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
  Offset needed = 0;
  const Stations stations = sampleCurves(
    { mesh, surface, features }, 100, std::numeric_limits<double>::infinity(), control, needed);
  for (const std::vector<Station>& places : stations)
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

int TestCurveSampling(int, char*[])
{
  testRadius();
  SurfaceMesh mesh = wavySheet();
  const Features features = findFeatures(mesh, FeatureOptions());
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  const Asked whole = cancelledAt(1000, mesh, surface, features);
  CHECK(whole.questions > 10); // there are many tries
  CHECK(whole.questions < 1000);
  CHECK(whole.points > 20);
  CHECK_EQUAL(cancelledAt(0, mesh, surface, features).points, 0);
  for (int question = 0; question < whole.questions; ++question)
  {
    CHECK(cancelledAt(question, mesh, surface, features).questions <= question + 4);
  }
  return test::result();
}
