// Comparison/DistanceLimit: it tells what is beyond the limit, proves the rest, and is soon done.

#include "Comparison/DistanceLimit.h"
#include "Comparison/SurfaceDistance.h"
#include "TestTriangles.h"

#include <Eigen/Geometry>

using namespace remesh;
using namespace remesh::test;

namespace
{
std::vector<FarPlace> beyond(const TriangleSoup& from, const TriangleSoup& to, double limit,
  const RunControl& control = RunControl())
{
  const Surface a(from);
  const Surface b(to);
  std::vector<FarPlace> places;
  CHECK(findPlacesBeyond(a.view(), TriangleTree(b.view()), limit, control, places).ok());
  return places;
}

void testPlanes()
{
  const TriangleSoup plane = gridPatch(4, 3);
  const TriangleSoup above = gridPatch(7, 5, { 0, 0, 0.25 });
  CHECK(beyond(plane, above, 0.27).empty());
  const std::vector<FarPlace> places = beyond(plane, above, 0.2);
  CHECK_EQUAL(places.size(), plane.triangles.size());
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    CHECK_EQUAL(places[k].triangle, static_cast<Index>(k));
    CHECK_NEAR(places[k].distance, 0.25, 1e-14);
  }
}

/** A plane cut up in two ways: nothing is beyond a limit as small as rounding allows. */
void testFlat()
{
  TriangleSoup turned = gridPatch(31, 23);
  for (Point3& point : turned.points)
  {
    point = Eigen::AngleAxisd(0.3, Point3::UnitZ()) * (3.0 * point - Point3(1.5, 1.5, 0.0));
  }
  const TriangleSoup plane = gridPatch(17, 19);
  CHECK(beyond(plane, turned, 1e-8).empty());
  CHECK(!beyond(turned, plane, 1.0).empty()); // which sticks out
}

/** The spike of one point of a fine grid, from and to two large triangles. */
void testSpike()
{
  const double height = 1e-3;
  TriangleSoup fine = gridPatch(100, 100);
  const std::size_t apex = 101 * 37 + 62;
  fine.points[apex][2] = height;
  const TriangleSoup coarse = gridPatch(1, 1);
  CHECK(beyond(fine, coarse, height * 1.0000001).empty());
  const std::vector<FarPlace> places = beyond(fine, coarse, 0.9 * height);
  CHECK_EQUAL(places.size(), std::size_t(6)); // those around the point
  for (const FarPlace& far : places)
  {
    CHECK((far.place - fine.points[apex]).norm() < 0.2 * 0.01);
    CHECK(far.distance > 0.95 * 0.9 * height);
  }
  // From below, the spike's foot is as far as its height times the cosine of its slope.
  const double cosine = 1.0 / std::hypot(1.0, height / 0.01 * std::sqrt(2.0));
  CHECK(beyond(coarse, fine, height).empty());
  const std::vector<FarPlace> below = beyond(coarse, fine, 0.9 * cosine * height);
  CHECK_EQUAL(below.size(), std::size_t(1));
}

/** As bounded otherwise: within 95 % nothing is told, and something below what is reached. */
void testAgainstBound()
{
  for (const int levels : { 1, 2, 3 })
  {
    const TriangleSoup coarse = icosphere(levels);
    const TriangleSoup fine = icosphere(4);
    TwoSidedDistance distance;
    const Surface a(coarse);
    const Surface b(fine);
    CHECK(measureTwoSidedDistance(a.view(), b.view(), {}, RunControl(), distance).ok());
    CHECK(beyond(coarse, fine, 1.06 * distance.forward.maximumBound).empty());
    CHECK(beyond(fine, coarse, 1.06 * distance.backward.maximumBound).empty());
    CHECK(!beyond(coarse, fine, 0.999 * distance.forward.maximum).empty());
    CHECK(!beyond(fine, coarse, 0.999 * distance.backward.maximum).empty());
  }
}

void testSchedulesAndCancel()
{
  const TriangleSoup coarse = icosphere(1);
  const TriangleSoup fine = icosphere(4);
  const std::vector<FarPlace> expected = beyond(fine, coarse, 0.03);
  CHECK(expected.size() > 10);
  for (const Schedule schedule : { Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    RunControl control;
    control.schedule = schedule;
    const std::vector<FarPlace> places = beyond(fine, coarse, 0.03, control);
    CHECK_EQUAL(places.size(), expected.size());
    for (std::size_t k = 0; k < std::min(places.size(), expected.size()); ++k)
    {
      CHECK(places[k].triangle == expected[k].triangle && places[k].place == expected[k].place);
    }
  }
  const Surface a(fine);
  const Surface b(coarse);
  std::vector<FarPlace> places;
  const RunControl cancelled(nullptr, []() { return true; });
  CHECK(findPlacesBeyond(a.view(), TriangleTree(b.view()), 0.03, cancelled, places).code ==
    StatusCode::Cancelled);
}
}

int TestDistanceLimit(int, char*[])
{
  testPlanes();
  testFlat();
  testSpike();
  testAgainstBound();
  testSchedulesAndCancel();
  return result();
}
