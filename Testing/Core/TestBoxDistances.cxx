// Eight boxes at once: the same bits for all sets of instructions, and the numbers of the plain
// formula; the boxes that meet another one.

#include "Mesh/BoxDistances.h"
#include "TestLanes.h"
#include "TestSupport.h"

#include <algorithm>
#include <cmath>

using namespace remesh;
using test::infinity;
using test::randomPoint;

namespace
{
/** Random boxes, one of them without a point as a rule; calls `visit(box, lower, upper)`. */
template <class Visit>
BoxGroup randomBoxes(std::uint64_t seed, const Visit& visit)
{
  BoxGroup boxes;
  for (int box = 0; box < lanes; ++box)
  {
    const Point3 a = randomPoint(seed, 2 * box);
    const Point3 b = randomPoint(seed, 2 * box + 1);
    const bool empty = box == static_cast<int>(seed % 9);
    const Point3 lower = empty ? Point3(Point3::Constant(infinity)) : Point3(a.cwiseMin(b));
    const Point3 upper = empty ? Point3(-lower) : Point3(a.cwiseMax(b));
    for (int axis = 0; axis < 3; ++axis)
    {
      boxes.lower[axis][box] = lower[axis];
      boxes.upper[axis][box] = upper[axis];
    }
    visit(box, lower, upper);
  }
  return boxes;
}

void testDistances()
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    double expected[lanes];
    const Point3 point = 2.0 * randomPoint(seed, 99);
    const auto measure = [&](int box, const Point3& lower, const Point3& upper)
    { expected[box] = (lower - point).cwiseMax(point - upper).cwiseMax(0.0).squaredNorm(); };
    const BoxGroup boxes = randomBoxes(seed, measure);
    double baseline[lanes];
    boxDistanceEvaluation(InstructionSet::Baseline)({ boxes, point.data(), baseline });
    for (int box = 0; box < lanes; ++box)
    {
      CHECK(baseline[box] == expected[box] || std::abs(baseline[box] - expected[box]) < 1e-15);
    }
    for (const InstructionSet set : test::availableSets())
    {
      double squared[lanes];
      boxDistanceEvaluation(set)({ boxes, point.data(), squared });
      CHECK(std::equal(baseline, baseline + lanes, squared));
    }
  }
}

void testMeeting()
{
  int met = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    const Point3 center = randomPoint(seed, 99);
    const Point3 half = 0.2 * (randomPoint(seed, 98) + Point3::Constant(0.5));
    const Point3 lower = center - half;
    const Point3 upper = center + half;
    unsigned expected = 0;
    const BoxGroup boxes = randomBoxes(seed,
      [&](int box, const Point3& otherLower, const Point3& otherUpper)
      {
        const bool meets = (lower.array() <= otherUpper.array()).all() &&
          (otherLower.array() <= upper.array()).all();
        expected |= meets ? 1U << box : 0U;
        met += meets;
      });
    for (const InstructionSet set : test::availableSets())
    {
      CHECK_EQUAL(boxMeetingEvaluation(set)({ boxes, lower.data(), upper.data() }), expected);
    }
  }
  CHECK(met > 100 && met < 1400); // of 1600
}

/** Boxes that touch meet, whatever the sign of a zero. */
void testTouching()
{
  BoxGroup boxes;
  std::fill_n(boxes.lower[0], 3 * lanes, 0.0);
  std::fill_n(boxes.upper[0], 3 * lanes, 1.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    boxes.lower[axis][0] = -0.0;
    boxes.lower[axis][1] = -1.0;
    boxes.upper[axis][1] = 0.0;
    boxes.lower[axis][2] = -1.0;
    boxes.upper[axis][2] = -0.0;
  }
  for (const InstructionSet set : test::availableSets())
  {
    for (const double zero : { 0.0, -0.0 })
    {
      const Point3 here = Point3::Constant(zero);
      const Point3 low = Point3::Constant(-1.0);
      const Point3 high = Point3::Constant(1.0);
      CHECK_EQUAL(boxMeetingEvaluation(set)({ boxes, low.data(), here.data() }), 0xFFU);
      CHECK_EQUAL(boxMeetingEvaluation(set)({ boxes, here.data(), high.data() }), 0xFFU);
      CHECK_EQUAL(boxMeetingEvaluation(set)({ boxes, here.data(), here.data() }), 0xFFU);
    }
  }
}
}

int TestBoxDistances(int, char*[])
{
  testDistances();
  testMeeting();
  testTouching();
  return test::result();
}
