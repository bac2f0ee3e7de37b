// Leaves of a range that are in reach: all of them, the nearest nearly first, and few others.

#include "Mesh/BoxTree.h"
#include "Support/Random.h"
#include "TestLanes.h"

#include <vector>

using namespace remesh;

namespace
{
/** Points along a curve that winds about; a leaf is one of them. */
std::vector<Point3> makeCurve(Index count)
{
  std::vector<Point3> points;
  for (Index k = 0; k < count; ++k)
  {
    const double t = 0.002 * k;
    points.emplace_back(std::cos(t), std::sin(1.7 * t), std::cos(2.9 * t + 1.0));
  }
  return points;
}

BoxTree treeOf(const std::vector<Point3>& points)
{
  return { static_cast<Index>(points.size()), RunControl(),
    [&](Index leaf, Point3& lower, Point3& upper)
    {
      lower = lower.cwiseMin(points[leaf]);
      upper = upper.cwiseMax(points[leaf]);
    } };
}

/** Searches a range for the nearest leaf; returns how many were looked at. */
Index checkRange(
  const std::vector<Point3>& points, const BoxTree& tree, Index first, Index last, Point3 place)
{
  double expected = std::numeric_limits<double>::infinity();
  for (Index leaf = first; leaf <= last; ++leaf)
  {
    expected = std::min(expected, (points[leaf] - place).squaredNorm());
  }
  double nearest = std::numeric_limits<double>::infinity();
  Index looks = 0;
  std::vector<char> seen(points.size(), 0);
  tree.visitLeaves(
    first, last, place, [&](double squared) { return squared <= nearest; },
    [&](Index leaf)
    {
      CHECK(leaf >= first && leaf <= last && !seen[leaf]);
      seen[leaf] = 1;
      nearest = std::min(nearest, (points[leaf] - place).squaredNorm());
      ++looks;
    });
  CHECK_NEAR(nearest, expected, 1e-15);
  return looks;
}

void checkTree(Index count)
{
  const std::vector<Point3> points = makeCurve(count);
  const BoxTree tree = treeOf(points);
  CHECK_EQUAL(tree.nodes(tree.levels() - 1), 1);
  double looks = 0.0, leaves = 0.0;
  for (std::uint64_t k = 0; k < 200; ++k)
  {
    const auto [a, b] = std::minmax({ static_cast<Index>(count * uniform01(1, k, 0)),
      static_cast<Index>(count * uniform01(1, k, 1)) });
    looks += checkRange(points, tree, a, b, 1.2 * test::randomPoint(2, k));
    leaves += b - a + 1;
  }
  CHECK(count < 1000 || looks < 0.05 * leaves);
  Index all = 0;
  tree.visitLeaves(
    0, count - 1, Point3::Zero(), [](double) { return true; }, [&](Index) { ++all; });
  CHECK_EQUAL(all, count);
}

/** The tree of a cancelled run is empty, and a search in it finds nothing. */
void testCancelled()
{
  const BoxTree tree(100, RunControl([](double, const char*) {}, [] { return true; }),
    [](Index, Point3&, Point3&) {});
  CHECK(tree.empty());
  tree.visitLeaves(
    0, 99, Point3::Zero(), [](double) { return true; }, [](Index) { CHECK(false); });
}
}

int TestBoxTree(int, char*[])
{
  CHECK(treeOf({}).empty());
  testCancelled();
  for (const Index count : { 1, 7, 8, 9, 64, 65, 511, 5000 })
  {
    checkTree(count);
  }
  return test::result();
}
