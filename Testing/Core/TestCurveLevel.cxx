// Features/CurveLevel: places on two curves that meet in a corner are as far from it; the copy of a
// feature point that is nearest.

#include "Features/CurveLevel.h"
#include "Features/CurveStations.h"
#include "Features/FeatureGraph.h"
#include "TestPlacements.h"

using namespace remesh;

namespace
{
/** A cube, each edge a curve in sections of these parts from its first point. */
struct DividedCube
{
  SurfaceMesh mesh = test::meshOf(test::cube());
  Features features = findFeatures(mesh, FeatureOptions());
  EmbeddedSurface surface = test::gaussMapOf(mesh, 0.0);
  FeatureSites sites;

  explicit DividedCube(double part)
  {
    Stations stations;
    for (std::size_t c = 0; c < this->features.curves.size(); ++c)
    {
      const auto curve = static_cast<Index>(c);
      const std::vector<double> lengths = measureCurve(this->view(), curve);
      stations.push_back({ stationAt(lengths, 0.0), stationAt(lengths, part * lengths.back()),
        stationAt(lengths, lengths.back()) });
    }
    this->sites = makeFeatureSites(this->view(), stations);
  }

  FeaturedSurface view() const { return { this->mesh, this->surface, this->features }; }

  Eigen::VectorXd coordinates(Index site) const
  {
    return Eigen::Map<const Eigen::VectorXd>(this->sites.sites.site(site), 3);
  }
};

void testLevels()
{
  constexpr double part = 0.3;
  const DividedCube cube(part);
  CHECK_EQUAL(cube.features.curves.size(), std::size_t(12));
  int levels = 0;
  int feet = 0;
  for (Index curve = 0; curve < 12; ++curve)
  {
    const FeatureCurve& own = cube.features.curves[curve];
    const Point3& from = cube.mesh.points[own.points.front()];
    const Point3& to = cube.mesh.points[own.points.back()];
    const Station foot{ 0, 0.6 };
    Eigen::VectorXd place = from + foot.t * (to - from);
    place =
      (place - Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(cube.surface.center.data(), 3))) /
      cube.surface.unit;
    for (Index site = 0; site < cube.sites.sites.count(); ++site)
    {
      const FeaturePoint& point = cube.sites.points[cube.sites.pointOfSite[site]];
      const Station level = levelWith(cube.view(), cube.sites, site, { curve, foot, place });
      const double fromFront = (point.place - from).norm();
      const double fromBack = (point.place - to).norm();
      const FeatureCurve* other =
        point.isCorner || point.curve == curve ? nullptr : &cube.features.curves[point.curve];
      const auto ends = [&](Index end)
      { return other && (other->points.front() == end || other->points.back() == end); };
      const double expected = ends(own.points.front()) ? fromFront
        : ends(own.points.back())                      ? 1.0 - fromBack
                                                       : foot.t;
      CHECK_EQUAL(level.segment, 0);
      CHECK_NEAR(level.t, expected, 1e-6); // the copies are shaken
      (expected == foot.t ? feet : levels) += 1;
    }
  }
  CHECK_EQUAL(levels, 48); // four curves meet each one
  CHECK_EQUAL(feet, 12 * 20 - 48);
}

/** Two curves with the same ends: the corner that is nearer to the site counts. */
void testBothEnds()
{
  const DividedCube cube(0.3);
  for (Index curve = 0; curve < 12; ++curve)
  {
    Features twins = cube.features;
    const Index other = (curve + 1) % 12;
    twins.curves[other].points.front() = twins.curves[curve].points.front();
    twins.curves[other].points.back() = twins.curves[curve].points.back();
    const Index point = cube.sites.curvePoints[other][1];
    const Index site = cube.sites.firstCopy[point];
    const auto distanceFrom = [&](Index corner)
    { return (cube.coordinates(site) - cube.coordinates(corner)).norm() * cube.surface.unit; };
    const std::vector<Index>& ends = cube.sites.curvePoints[curve];
    const double fromFront = distanceFrom(cube.sites.firstCopy[ends.front()]);
    const double fromBack = distanceFrom(cube.sites.firstCopy[ends.back()]);
    const double nearest = std::min(fromFront, fromBack);
    const Eigen::VectorXd place = 0.5 *
      (cube.coordinates(cube.sites.firstCopy[ends.front()]) +
        cube.coordinates(cube.sites.firstCopy[ends.back()]));
    const Station level =
      levelWith({ cube.mesh, cube.surface, twins }, cube.sites, site, { curve, { 0, 0.5 }, place });
    if (nearest < 1.0)
    {
      CHECK_NEAR(level.t, fromFront <= fromBack ? nearest : 1.0 - nearest, 1e-6);
    }
  }
}

void testCopies()
{
  const DividedCube cube(0.3);
  for (Index site = 0; site < cube.sites.sites.count(); ++site)
  {
    const Index point = cube.sites.pointOfSite[site];
    CHECK_EQUAL(nearestCopy(cube.sites, point, cube.coordinates(site)), site);
  }
}
}

int TestCurveLevel(int, char*[])
{
  testLevels();
  testBothEnds();
  testCopies();
  return test::result();
}
