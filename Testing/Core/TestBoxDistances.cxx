// Eight boxes at once: the same bits for all sets of instructions, and the numbers of the plain
// formula.

#include "Mesh/BoxDistances.h"
#include "TestLanes.h"
#include "TestSupport.h"

#include <cmath>

using namespace remesh;
using test::infinity;
using test::randomPoint;

namespace
{
void testBoxes()
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    BoxGroup boxes;
    double expected[lanes];
    const Point3 point = 2.0 * randomPoint(seed, 99);
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
      expected[box] = (lower - point).cwiseMax(point - upper).cwiseMax(0.0).squaredNorm();
    }
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
}

int TestBoxDistances(int, char*[])
{
  testBoxes();
  return test::result();
}
