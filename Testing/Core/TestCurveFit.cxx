// Placement/CurveFit: the edges along an arc are as close to it as they can be; what is straight,
// and corners, stay to the bit.

#include "Features/FeatureGraph.h"
#include "Placement/CurveFit.h"
#include "TestEmbeddings.h"
#include "TestSurfaces.h"

#include <cmath>

using namespace remesh;

namespace
{
struct Fitted
{
  FeatureSites sites;
  std::vector<Point3> places;
};

/** With each curve in so many sections. */
Fitted fitted(SurfaceMesh& mesh, const Features& features, int sections)
{
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  const FeaturedSurface view{ mesh, surface, features };
  Stations stations;
  for (std::size_t c = 0; c < features.curves.size(); ++c)
  {
    const std::vector<double> lengths = measureCurve(view, static_cast<Index>(c));
    stations.emplace_back();
    for (int k = 0; k <= sections; ++k)
    {
      stations.back().push_back(stationAt(lengths, lengths.back() * k / sections));
    }
  }
  Fitted result{ makeFeatureSites(view, stations), {} };
  CHECK(fitCurves(view, result.sites, RunControl(), result.places));
  CHECK_EQUAL(result.places.size(), result.sites.points.size());
  return result;
}

/**
 * A circle of radius r, of which a chord sees the angle 2a: at the radius p the chord's points are
 * p cos(a) from the centre and off by r cos(t) - p cos(a) at the angle t of the circle's. The mean
 * square is the least where p cos(a) is the mean of r cos(t), r sin(a) / a.
 */
void testCircle()
{
  constexpr double radius = 0.3;
  SurfaceMesh mesh = test::meshOf(test::ringInSquare(960, radius));
  const Features features = findFeatures(mesh, FeatureOptions());
  for (const int sections : { 6, 16, 40 })
  {
    const Fitted fit = fitted(mesh, features, sections);
    const double a = std::acos(-1.0) / sections;
    for (std::size_t p = 0; p < fit.places.size(); ++p)
    {
      const FeaturePoint& point = fit.sites.points[p];
      const bool isRound = point.curve != noIndex && !features.curves[point.curve].hasCorners;
      if (isRound)
      {
        CHECK_NEAR(fit.places[p].norm(), radius * std::sin(a) / (a * std::cos(a)), 1e-3 * a * a);
        CHECK_NEAR(fit.places[p].normalized().dot(point.place.normalized()), 1.0, 1e-9);
        CHECK_EQUAL(fit.places[p].z(), 0.0);
      }
      else
      {
        CHECK(fit.places[p] == point.place);
      }
    }
  }
}

void testCancelled()
{
  SurfaceMesh mesh = test::meshOf(test::ringInSquare(96, 0.3));
  const Features features = findFeatures(mesh, FeatureOptions());
  const Fitted fit = fitted(mesh, features, 8);
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  std::vector<Point3> places;
  const RunControl control({}, []() { return true; });
  CHECK(!fitCurves({ mesh, surface, features }, fit.sites, control, places));
}
}

int TestCurveFit(int, char*[])
{
  testCircle();
  testCancelled();
  return test::result();
}
