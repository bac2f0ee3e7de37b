// Eight triangles at once: the same bits for all sets of instructions, and the numbers of the plain
// formulas.

#include "Placement/StarHeights.h"
#include "TestLanes.h"
#include "TestSupport.h"

#include <cmath>

using namespace remesh;
using test::infinity;
using test::randomPoint;

namespace
{
struct Star
{
  std::vector<StarGroup> groups;
  std::vector<Point3> first, second, normal;

  Star(std::uint64_t seed, std::size_t triangles)
    : groups((triangles + lanes - 1) / lanes)
  {
    for (std::size_t t = 0; t < triangles; ++t)
    {
      this->first.push_back(4.0 * randomPoint(seed, 3 * t));
      this->second.push_back(4.0 * randomPoint(seed, 3 * t + 1));
      this->normal.push_back(randomPoint(seed, 3 * t + 2).normalized());
      for (int k = 0; k < 3; ++k)
      {
        this->groups[t / lanes].first[k][t % lanes] = this->first[t][k];
        this->groups[t / lanes].second[k][t % lanes] = this->second[t][k];
        this->groups[t / lanes].normal[k][t % lanes] = this->normal[t][k];
      }
    }
  }
};

void testStars()
{
  int above = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed)
  {
    const Star star(seed, 1 + seed % 19);
    const Point3 way = randomPoint(seed, 98);
    const Point3 facing = randomPoint(seed, 99);
    std::vector<double> baseline(star.groups.size() * lanes);
    starHeightEvaluation(InstructionSet::Baseline)(
      { star.groups, way.data(), facing.data(), baseline.data() });
    for (std::size_t t = 0; t < baseline.size(); ++t)
    {
      if (t >= star.first.size())
      {
        CHECK_EQUAL(baseline[t], infinity);
        continue;
      }
      const double u = star.first[t].dot(way);
      const double v = star.second[t].dot(way);
      const bool isAbove = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && star.normal[t].dot(facing) > 0.0;
      above += isAbove;
      const double height = star.normal[t].dot(way);
      CHECK(isAbove ? std::abs(baseline[t] - height * height) < 1e-15 : baseline[t] == infinity);
    }
    for (const InstructionSet set : test::availableSets())
    {
      std::vector<double> squared(baseline.size());
      starHeightEvaluation(set)({ star.groups, way.data(), facing.data(), squared.data() });
      CHECK(squared == baseline);
    }
  }
  CHECK(above > 200);
}
}

int TestStarHeights(int, char*[])
{
  testStars();
  return test::result();
}
