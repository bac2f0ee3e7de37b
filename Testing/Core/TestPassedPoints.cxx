// Features/PassedPoints: points between a curve and the chord of a section of it, and no others.

#include "Features/FeatureGraph.h"
#include "Features/PassedPoints.h"
#include "TestPlacements.h"

#include <cmath>
#include <limits>
#include <set>
#include <utility>

using namespace remesh;

namespace
{
constexpr double sag = 0.1; // more, and there are no corners at the ends
constexpr double width = 0.02;

/** The lower side of a strip that hangs down between its ends. */
Point3 onArc(double x)
{
  return { x, -4.0 * sag * x * (1.0 - x), 0.0 };
}

/** Such a strip: the lower side in one section, the others in many. */
struct HangingStrip
{
  SurfaceMesh mesh;
  Features features;
  EmbeddedSurface surface;
  FeatureSites sites;
  Index lower = noIndex; ///< curve

  HangingStrip()
    : mesh(makeMesh())
    , features(findFeatures(mesh, FeatureOptions()))
    , surface(test::gaussMapOf(mesh, 0.0))
  {
    Stations stations;
    for (std::size_t c = 0; c < this->features.curves.size(); ++c)
    {
      const auto curve = static_cast<Index>(c);
      const Point3& inner = this->mesh.points[this->features.curves[c].points[1]];
      const bool isLower = (inner - onArc(inner.x())).norm() < 1e-9;
      this->lower = isLower ? curve : this->lower;
      const std::vector<double> lengths = measureCurve(this->view(), curve);
      const int count = isLower ? 1 : 23;
      stations.emplace_back();
      for (int k = 0; k <= count; ++k)
      {
        stations.back().push_back(stationAt(lengths, lengths.back() * k / count));
      }
    }
    this->sites = makeFeatureSites(this->view(), stations);
  }

  static SurfaceMesh makeMesh()
  {
    TriangleSoup soup = test::gridPatch(40, 4);
    for (Point3& p : soup.points)
    {
      p = onArc(p.x()) + Point3(0.0, width * p.y(), 0.0);
    }
    return test::meshOf(soup);
  }

  FeaturedSurface view() const { return { this->mesh, this->surface, this->features }; }

  Point3 placeOf(const Station& station) const
  {
    const std::vector<Index>& points = this->features.curves[this->lower].points;
    const Point3& from = this->mesh.points[points[station.segment]];
    return from + station.t * (this->mesh.points[points[station.segment + 1]] - from);
  }

  /** The point of the lower side that is nearest to a place. */
  Point3 nearestTo(const Point3& place) const
  {
    Point3 nearest = Point3::Zero();
    double distance = std::numeric_limits<double>::infinity();
    const auto segments = static_cast<Index>(this->features.curves[this->lower].edges.size());
    for (Index segment = 0; segment < segments; ++segment)
    {
      for (int k = 0; k <= 1000; ++k)
      {
        const Point3 at = this->placeOf({ segment, k / 1000.0 });
        nearest = (at - place).norm() < distance ? at : nearest;
        distance = std::min(distance, (at - place).norm());
      }
    }
    return nearest;
  }
};

std::vector<Index> allOf(const FeatureSites& sites)
{
  std::vector<Index> points;
  for (Index point = 0; point < sites.numberOfPoints(); ++point)
  {
    points.push_back(point);
  }
  return points;
}

void testHangingStrip()
{
  const HangingStrip strip;
  CHECK(strip.lower != noIndex);
  if (strip.lower == noIndex)
  {
    return;
  }
  const std::vector<PassedPoint> passed =
    findPassedPoints(strip.view(), strip.sites, allOf(strip.sites));
  std::set<Index> found;
  for (const PassedPoint& at : passed)
  {
    CHECK_EQUAL(at.curve, strip.lower); // the others' chords are outside of the strip
    CHECK_EQUAL(at.section, 0);
    CHECK(found.insert(at.point).second);
    const Point3& place = strip.sites.points[at.point].place;
    CHECK((strip.placeOf(at.foot) - strip.nearestTo(place)).norm() < 1e-4);
  }
  CHECK(found.size() >= 10);
  const std::vector<Index>& ends = strip.sites.curvePoints[strip.lower];
  for (const Index point : allOf(strip.sites))
  {
    const Point3& place = strip.sites.points[point].place;
    const double chordAbove = -place.y();
    const bool isEnd = point == ends.front() || point == ends.back();
    if (isEnd || std::abs(chordAbove) > 0.01) // else it is a matter of which is nearer
    {
      CHECK_EQUAL(found.count(point), std::size_t(!isEnd && chordAbove > 0.0 ? 1 : 0));
    }
  }
  CHECK(findPassedPoints(strip.view(), strip.sites, {}).empty());
}

/** Divided at the feet, it passes fewer and fewer. */
void testDivided()
{
  HangingStrip strip;
  std::size_t before = std::numeric_limits<std::size_t>::max();
  int rounds = 0;
  for (; rounds < 8; ++rounds)
  {
    const auto passed = findPassedPoints(strip.view(), strip.sites, allOf(strip.sites));
    if (passed.empty())
    {
      break;
    }
    CHECK(passed.size() < before);
    before = passed.size();
    Stations stations = strip.sites.stations;
    const std::vector<double> lengths = measureCurve(strip.view(), strip.lower);
    std::set<Index> sections;
    for (const PassedPoint& at : passed)
    {
      if (at.curve == strip.lower && sections.insert(at.section).second)
      {
        CHECK(insertStation(lengths, at.foot, 0.0, 0.01, stations[strip.lower]));
      }
    }
    strip.sites = makeFeatureSites(strip.view(), stations);
  }
  CHECK(rounds > 1 && rounds < 8);
}

/** Whether a point of another side is passed, were it there. */
bool isPassedAt(const Point3& place)
{
  HangingStrip strip;
  const Index point = strip.sites.curvePoints[(strip.lower + 1) % 4][1]; // of another side
  strip.sites.points[point].place = place;
  return !findPassedPoints(strip.view(), strip.sites, { point }).empty();
}

/** Between the middle of the arc and of its chord, beyond either, and beside their plane. */
void testSides()
{
  const Point3 arc = onArc(0.5);
  for (const double share : { 0.05, 0.5, 0.95 })
  {
    CHECK(isPassedAt((1.0 - share) * arc + share * Point3(0.5, 0.0, 0.0)));
  }
  CHECK(!isPassedAt(arc + Point3(0.0, -0.1 * sag, 0.0)));
  CHECK(!isPassedAt(arc + Point3(0.0, 1.1 * sag, 0.0)));
  CHECK(!isPassedAt(arc + Point3(0.0, 0.0, 0.5 * sag)));       // below the arc, on a thin plate
  CHECK(!isPassedAt(arc + Point3(0.0, 0.5 * sag, 0.6 * sag))); // out of the ball over both
  CHECK(!isPassedAt(arc + Point3(0.5, 0.0, 0.0)));
}

void testCancelled()
{
  const HangingStrip strip;
  const RunControl cancelled({}, []() { return true; });
  CHECK(findPassedPoints(strip.view(), strip.sites, allOf(strip.sites), cancelled).empty());
}
}

int TestPassedPoints(int, char*[])
{
  testHangingStrip();
  testDivided();
  testSides();
  testCancelled();
  return test::result();
}
