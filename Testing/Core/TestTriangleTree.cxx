// The tree of triangles against a look at all of them; signed distances to a box by its formula.

#include "Comparison/PointDistance.h"
#include "Support/Random.h"
#include "TestTriangles.h"

#include <set>

using namespace remesh;
using namespace remesh::test;

namespace
{
Point3 randomPoint(std::uint64_t index, double reach)
{
  return { reach * (2.0 * uniform01(1, index, 0) - 1.0),
    reach * (2.0 * uniform01(1, index, 1) - 1.0), reach * (2.0 * uniform01(1, index, 2) - 1.0) };
}

void testAgainstAll(const TriangleSoup& soup)
{
  const Surface surface(soup);
  const TriangleTree tree(surface.view());
  Index hint = noIndex;
  for (std::uint64_t k = 0; k < 300; ++k)
  {
    const Point3 point = randomPoint(k, k % 2 ? 1.5 : 20.0);
    std::vector<double> all;
    for (const auto& [a, b, c] : surface.triangles)
    {
      all.push_back(
        closestOnTriangle(point, surface.points[a], surface.points[b], surface.points[c]).squared);
    }
    const TriangleTree::Place place = tree.closest(point, hint);
    hint = place.slot;
    CHECK_EQUAL(place.at.squared, *std::min_element(all.begin(), all.end()));
    CHECK_EQUAL(all[tree.triangleOf(place.slot)], place.at.squared);
    CHECK_NEAR((tree.positionOf(place) - point).squaredNorm(), place.at.squared, 1e-12);

    const double reach = 1.1 * std::sqrt(place.at.squared) + 0.02;
    std::vector<TriangleTree::Place> closest;
    // Known to be no farther than the closest one, another one, one that is not there, or nothing.
    const double squared = place.at.squared;
    for (const double near :
      { squared, all[0], 0.5 * squared, std::numeric_limits<double>::infinity() })
    {
      tree.findClosest(point, { 0.1, 0.02 }, near, closest);
      std::set<Index> slots;
      for (const TriangleTree::Place& one : closest)
      {
        CHECK_EQUAL(all[tree.triangleOf(one.slot)], one.at.squared);
        slots.insert(one.slot);
      }
      CHECK_EQUAL(slots.size(), closest.size());
      CHECK_EQUAL(closest.size(),
        static_cast<std::size_t>(
          std::count_if(all.begin(), all.end(), [&](double d) { return d <= reach * reach; })));
    }
  }
}

/** Eight points find what each alone does, near each other or not, from what others have found. */
void testPackets(const TriangleSoup& soup)
{
  const Surface surface(soup);
  const TriangleTree tree(surface.view());
  TriangleTree::Packet packet;
  std::fill_n(packet.slots, lanes, noIndex);
  for (std::uint64_t k = 0; k < 300; ++k)
  {
    const Point3 center = randomPoint(k, 1.2);
    for (int lane = 0; lane < lanes; ++lane)
    {
      const Point3 point = center + randomPoint(1000 + lanes * k + lane, k % 3 == 0 ? 2.0 : 0.05);
      for (int axis = 0; axis < 3; ++axis)
      {
        packet.points.point[axis][lane] = point[axis];
      }
    }
    tree.findClosest(packet);
    for (int lane = 0; lane < lanes; ++lane)
    {
      const Point3 point = packet.points.at(lane);
      const double squared = tree.closest(point).at.squared;
      CHECK_NEAR(packet.points.squared[lane], squared, 1e-14);
      CHECK_NEAR(tree.closestOn(packet.slots[lane], point).at.squared, squared, 1e-14);
    }
  }
}

/** So narrow triangles that they are measured one point at a time. */
TriangleSoup needles()
{
  TriangleSoup soup = makeSoup({}, {});
  for (int k = 0; k < 60; ++k)
  {
    const Index first = static_cast<Index>(soup.points.size());
    const Point3 start = randomPoint(3 * k, 1.0);
    const Point3 end = randomPoint(3 * k + 1, 1.0);
    soup.points.insert(
      soup.points.end(), { start, end, start + 1e-6 * randomPoint(3 * k + 2, 1.0) });
    soup.triangles.push_back({ first, first + 1, first + 2 });
  }
  return soup;
}

/** All pairs of triangles whose boxes meet are visited, none twice. */
void testMeeting(const TriangleSoup& soup)
{
  const Surface surface(soup);
  const TriangleTree tree(surface.view());
  std::set<std::pair<Index, Index>> visited;
  std::vector<Index> scratch;
  for (Index group = 0; group < tree.numberOfGroups(); ++group)
  {
    tree.visitMeeting(group, scratch,
      [&](Index slot, Index other)
      {
        CHECK(slot < other);
        CHECK(visited.emplace(slot, other).second);
      });
  }
  const auto boxOf = [&](Index slot)
  {
    const auto& [a, b, c] = tree.cornersOf(slot);
    return Eigen::AlignedBox3d(a).extend(b).extend(c);
  };
  std::size_t meeting = 0;
  for (Index slot = 0; slot < tree.size(); ++slot)
  {
    for (Index other = slot + 1; other < tree.size(); ++other)
    {
      const bool meets = boxOf(slot).intersects(boxOf(other));
      CHECK(!meets || visited.count({ slot, other }) == 1);
      meeting += meets;
    }
  }
  CHECK(visited.size() <= 3 * meeting); // few others
}

void testSizes()
{
  testAgainstAll(makeSoup({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }));
  testAgainstAll(tetrahedron());
  testAgainstAll(cube());
  testAgainstAll(gridPatch(7, 3));
  testAgainstAll(torus(1.0, 0.3, 23, 9));

  // Triangles without area are left out.
  TriangleSoup soup = cube();
  soup.triangles.push_back({ 0, 0, 1 });
  soup.triangles.push_back({ 2, 2, 2 });
  const Surface surface(soup);
  const TriangleTree tree(surface.view());
  for (std::uint64_t k = 0; k < 100; ++k)
  {
    CHECK(tree.triangleOf(tree.closest(randomPoint(k, 2.0)).slot) < 12);
  }
  const Surface nothing = surfaceWithoutArea();
  const TriangleTree none(nothing.view());
  CHECK(none.empty());
  CHECK_EQUAL(none.closest(Point3::Zero()).slot, noIndex);
  TriangleTree::Packet packet{};
  std::fill_n(packet.slots, lanes, noIndex);
  none.findClosest(packet);
  CHECK(
    std::all_of(packet.slots, packet.slots + lanes, [](Index slot) { return slot == noIndex; }));
}

/** At a million triangles, copies of the corners would be the larger part of the tree. */
void testHoldsNoCorners()
{
  Surface surface(cube());
  const TriangleTree tree(surface.view());
  surface.points.front().x() += 1.0;
  for (Index slot = 0; slot < tree.size(); ++slot)
  {
    CHECK(tree.cornersOf(slot) == surface.view().corners(tree.triangleOf(slot)));
  }
}

/** Negative inside of the unit cube. */
double signedDistanceToCube(const Point3& point)
{
  const Point3 beyond = (point - Point3::Constant(0.5)).cwiseAbs() - Point3::Constant(0.5);
  return beyond.cwiseMax(0.0).norm() + std::min(0.0, beyond.maxCoeff());
}

void testSides()
{
  const Surface surface(cube());
  const TriangleTree tree(surface.view());
  const SideNormals sides(surface.view());
  std::vector<Point3> points;
  for (std::uint64_t k = 0; k < 2000; ++k)
  {
    points.push_back(Point3::Constant(0.5) + randomPoint(k, 1.5));
  }
  // Straight off corners and edges, where the closest place is shared by many triangles.
  points.insert(
    points.end(), { { -1, -1, -1 }, { 2, 0.5, 2 }, { 1.1, 1.1, 0.3 }, { 0.5, 0.5, 0.4 } });
  points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  PointDistances result;
  const std::vector<double>& distances = result.distances;
  const std::vector<char>& behind = result.behind;
  CHECK(measurePointDistances(points, tree, &sides, RunControl(), result).ok());
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
  {
    CHECK_NEAR(behind[k] ? -distances[k] : distances[k], signedDistanceToCube(points[k]), 1e-14);
  }
  CHECK(std::isnan(distances.back()));
  CHECK(measurePointDistances(points, tree, nullptr, RunControl(), result).ok());
  CHECK(behind.empty());
  // So far away that no distance can be told from infinity.
  const std::vector<Point3> far = { { 1e200, 0.0, 0.0 }, { 0.5, 0.5, 3.0 } };
  CHECK(measurePointDistances(far, tree, &sides, RunControl(), result).ok());
  CHECK(std::isnan(distances[0]) && behind[0] == 0);
  CHECK_NEAR(distances[1], 2.0, 1e-14);
}
}

int TestTriangleTree(int, char*[])
{
  testMeeting(makeSoup({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }));
  testMeeting(tetrahedron());
  testMeeting(gridPatch(40, 30));
  testPackets(makeSoup({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }));
  testPackets(cube());
  testPackets(torus(1.0, 0.3, 60, 25));
  testPackets(needles());
  testHoldsNoCorners();
  testMeeting(torus(1.0, 0.3, 60, 25));
  testSizes();
  testSides();
  return result();
}
