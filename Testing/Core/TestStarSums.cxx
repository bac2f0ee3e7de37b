// What samples add to the triangles around a vertex: the same bits for all sets of instructions,
// and the numbers of the plain formulas.

#include "Placement/StarSums.h"
#include "TestLanes.h"
#include "TestSupport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

using namespace remesh;
using test::infinity;
using test::randomPoint;

namespace
{
Point3 pointOf(const double (&values)[3])
{
  return { values[0], values[1], values[2] };
}

/** Triangles around a corner and samples near them; each second triangle faces the other way. */
struct Star
{
  std::vector<StarTriangle> triangles;
  std::vector<SampleGroup> groups;
  Index count;
  Point3 shift;

  Star(std::uint64_t seed, std::size_t size, Index samples)
    : triangles(size)
    , groups(static_cast<std::size_t>((samples + lanes - 1) / lanes), SampleGroup{})
    , count(samples)
    , shift(0.1 * randomPoint(seed, 0))
  {
    for (std::size_t t = 0; t < size; ++t)
    {
      const Point3 first = 4.0 * randomPoint(seed, 3 * t + 1);
      const Point3 second = 4.0 * randomPoint(seed, 3 * t + 2);
      const Point3 normal = randomPoint(seed, 3 * t + 3).normalized();
      for (int k = 0; k < 3; ++k)
      {
        triangles[t].first[k] = first[k];
        triangles[t].second[k] = second[k];
        triangles[t].normal[k] = t == 1 ? 0.0 : normal[k]; // one without area
      }
      triangles[t].sums = static_cast<Index>(size - 1 - t);
      triangles[t].corner = static_cast<int>(t % 3);
    }
    for (Index i = 0; i < samples; ++i)
    {
      const Point3 offset = randomPoint(seed + 1000, i);
      const Point3 normal = randomPoint(seed + 2000, i).normalized();
      SampleGroup& group = groups[i / lanes];
      for (int k = 0; k < 3; ++k)
      {
        group.offset[k][i % lanes] = static_cast<float>(offset[k]);
        group.normal[k][i % lanes] = static_cast<float>(normal[k]);
      }
      group.weight[i % lanes] = static_cast<float>(0.1 + uniform01(seed, i, 9));
    }
  }
};

constexpr double unit = 0.5;

struct Sums
{
  std::vector<TriangleSums> sums;
  std::vector<Index> others;
};

Sums summed(const Star& star, InstructionSet set)
{
  Sums result{ std::vector<TriangleSums>(star.triangles.size(), TriangleSums{}),
    std::vector<Index>(static_cast<std::size_t>(star.count)) };
  const Index others = starSummation(set)({ star.triangles, star.groups.data(), unit, star.count,
    star.shift.data(), result.sums.data(), result.others.data() });
  result.others.resize(static_cast<std::size_t>(others));
  return result;
}

/** By definition, one sample and one triangle at a time. */
Sums plainlySummed(const Star& star)
{
  Sums result{ std::vector<TriangleSums>(star.triangles.size(), TriangleSums{}), {} };
  for (Index i = 0; i < star.count; ++i)
  {
    const SampleGroup& group = star.groups[i / lanes];
    Point3 way = star.shift;
    Point3 normal;
    for (int k = 0; k < 3; ++k)
    {
      way[k] += unit * group.offset[k][i % lanes];
      normal[k] = group.normal[k][i % lanes];
    }
    double nearest = infinity;
    const StarTriangle* best = nullptr;
    for (const StarTriangle& triangle : star.triangles)
    {
      const double u = pointOf(triangle.first).dot(way);
      const double v = pointOf(triangle.second).dot(way);
      const double height = std::abs(pointOf(triangle.normal).dot(way));
      if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && pointOf(triangle.normal).dot(normal) > 0.0 &&
        height < nearest)
      {
        nearest = height;
        best = &triangle;
      }
    }
    if (!best)
    {
      result.others.push_back(i);
      continue;
    }
    const double weight = group.weight[i % lanes];
    const double residual = pointOf(best->normal).dot(way) * pointOf(best->normal).dot(normal);
    double b[3];
    b[(best->corner + 1) % 3] = pointOf(best->first).dot(way);
    b[(best->corner + 2) % 3] = pointOf(best->second).dot(way);
    b[best->corner] = 1.0 - b[(best->corner + 1) % 3] - b[(best->corner + 2) % 3];
    const double products[lanes] = { normal[0] * normal[0], normal[0] * normal[1],
      normal[0] * normal[2], normal[1] * normal[1], normal[1] * normal[2], normal[2] * normal[2],
      1.0, 0.0 };
    TriangleSums& sums = result.sums[best->sums];
    for (int k = 0; k < 3; ++k)
    {
      for (int l = 0; l < lanes; ++l)
      {
        sums.pairs[k][l] += weight * b[k] * b[k] * products[l];
        sums.pairs[3 + k][l] += weight * b[k] * b[(k + 1) % 3] * products[l];
      }
      for (int l = 0; l < 3; ++l)
      {
        sums.slopes[k][l] += weight * b[k] * residual * normal[l];
        sums.slopes[k][3 + l] += weight * b[k] * normal[l];
      }
      sums.slopes[k][6] += weight * b[k] * residual * residual;
      sums.slopes[k][7] += weight * b[k];
    }
    sums.farthest = std::max(sums.farthest, residual * residual);
  }
  return result;
}

std::array<double, sizeof(TriangleSums) / sizeof(double)> valuesOf(const TriangleSums& sums)
{
  std::array<double, sizeof(TriangleSums) / sizeof(double)> values;
  std::memcpy(values.data(), &sums, sizeof sums);
  return values;
}

void checkEqual(const Sums& a, const Sums& b, double tolerance)
{
  CHECK(a.others == b.others);
  for (std::size_t t = 0; t < a.sums.size(); ++t)
  {
    const auto x = valuesOf(a.sums[t]);
    const auto y = valuesOf(b.sums[t]);
    for (std::size_t k = 0; k < x.size(); ++k)
    {
      CHECK(std::abs(x[k] - y[k]) <= tolerance);
    }
  }
}

void testStars()
{
  std::size_t above = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed)
  {
    const Star star(seed, 1 + seed % 9, static_cast<Index>(seed % 29));
    const Sums baseline = summed(star, InstructionSet::Baseline);
    checkEqual(baseline, plainlySummed(star), 1e-13);
    above += static_cast<std::size_t>(star.count) - baseline.others.size();
    for (const InstructionSet set : test::availableSets())
    {
      checkEqual(summed(star, set), baseline, 0.0);
    }
  }
  CHECK(above > 1000);
}

/** A sample whose foot is given adds the same as one whose foot is found. */
void testGiven()
{
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed)
  {
    const Star one(seed, 1, 1);
    const Sums found = summed(one, InstructionSet::Baseline);
    if (!found.others.empty())
    {
      continue;
    }
    const StarTriangle& triangle = one.triangles[0];
    Point3 way = one.shift;
    double normal[3];
    for (int k = 0; k < 3; ++k)
    {
      way[k] += unit * one.groups[0].offset[k][0];
      normal[k] = one.groups[0].normal[k][0];
    }
    const double u = pointOf(triangle.first).dot(way);
    const double v = pointOf(triangle.second).dot(way);
    const double b[3] = { 1.0 - u - v, u, v };
    Sums given{ { TriangleSums{} }, {} };
    addSample(normal, one.groups[0].weight[0], b,
      pointOf(triangle.normal).dot(way) * pointOf(triangle.normal).dot(pointOf(normal)),
      given.sums[0]);
    checkEqual(given, found, 1e-14);
    ++compared;
  }
  CHECK(compared > 2);
}
}

int TestStarSums(int, char*[])
{
  testStars();
  testGiven();
  return test::result();
}
