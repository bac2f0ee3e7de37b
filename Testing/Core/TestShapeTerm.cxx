// What triangles' shapes add to the fit: its slopes against differences of the energy, and where it
// has none.

#include "Placement/ShapeTerm.h"
#include "TestLanes.h"
#include "TestSupport.h"

#include <Eigen/Eigenvalues>

using namespace remesh;
using test::randomPoint;

namespace
{
/** A metric, and the same as lengths of ways mapped by a matrix. */
struct Metric
{
  Eigen::Matrix3d map;

  explicit Metric(std::uint64_t seed)
    : map(Eigen::Matrix3d::Identity())
  {
    for (int k = 0; k < 3; ++k)
    {
      map.col(k) += 0.8 * randomPoint(seed, 100 + k);
    }
  }
  Symmetric3<double> tensor() const { return symmetricOf(map.transpose() * map); }
};

/** (phi - 1 + 1e-4)^(3/4), by the triangle's edges in the metric. */
double energyOf(const Corners& corners, const Metric& metric)
{
  double squares = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    squares += (metric.map * (corners[(k + 1) % 3] - corners[k])).squaredNorm();
  }
  const double area = facetArea(Point3(metric.map * corners[0]), Point3(metric.map * corners[1]),
    Point3(metric.map * corners[2]));
  const double phi = squares / (4.0 * std::sqrt(3.0) * area);
  return std::pow(phi - 1.0 + 1e-4, 0.75);
}

Corners randomCorners(std::uint64_t seed)
{
  return { randomPoint(seed, 1), randomPoint(seed, 2), randomPoint(seed, 3) };
}

/** Within the triangle's plane; across it, the term says nothing. */
void testSlopes()
{
  constexpr double step = 1e-6;
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    const Corners corners = randomCorners(seed);
    const Metric metric(seed);
    ShapeTerm term;
    if (!findShapeTerm(corners, metric.tensor(), term) || energyOf(corners, metric) > 5.0)
    {
      continue;
    }
    ++compared;
    const Point3 normal = facetNormal(corners[0], corners[1], corners[2]);
    const Point3 along[2] = { (corners[1] - corners[0]).normalized(),
      normal.cross(corners[1] - corners[0]).normalized() };
    for (int k = 0; k < 3; ++k)
    {
      CHECK_NEAR(term.slopes[k].dot(normal), 0.0, 1e-9 * (1.0 + term.slopes[k].norm()));
      for (const Point3& way : along)
      {
        Corners after = corners;
        Corners before = corners;
        after[k] += step * way;
        before[k] -= step * way;
        const double slope = (energyOf(before, metric) - energyOf(after, metric)) / (2.0 * step);
        CHECK_NEAR(term.slopes[k].dot(way), slope, 1e-4 * (1.0 + std::abs(slope)));
      }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrixOf(term.block));
    CHECK(solver.eigenvalues()[0] >= -1e-9 * solver.eigenvalues()[2]);
    CHECK(solver.eigenvalues()[1] > 0.0);
  }
  CHECK(compared > 100);
}

/** Equilateral in the metric: no slope, in whatever unit. */
void testEquilateral()
{
  for (const double size : { 1e-70, 1.0, 1e70 })
  {
    const Corners corners = { Point3::Zero(), Point3(2.0 * size, 0.0, 0.0),
      Point3(size, std::sqrt(3.0) / 2.0 * size, 0.0) };
    Symmetric3<double> metric; // lengths in it are near 1
    metric << 1.0, 0.0, 0.0, 4.0, 0.0, 9.0;
    ShapeTerm term;
    CHECK(findShapeTerm(corners, metric / size / size, term));
    for (const Point3& slope : term.slopes)
    {
      CHECK_NEAR(slope.norm() * size, 0.0, 1e-12);
    }
  }
}

void testNone()
{
  ShapeTerm term;
  const Point3 a(1.0, 2.0, 3.0);
  const Point3 b(2.0, 2.0, 3.0);
  const Symmetric3<double> usual = symmetricOf(Eigen::Matrix3d::Identity());
  const Symmetric3<double> none = Symmetric3<double>::Zero();
  const Symmetric3<double> line = symmetricProduct(Point3(1.0, 0.0, 0.0), Point3(1.0, 0.0, 0.0));
  for (const auto& [corners, metric] :
    { std::pair(Corners{ a, b, a }, usual), std::pair(Corners{ a, b, 0.5 * (a + b) }, usual),
      std::pair(Corners{ a, b, Point3::Zero() }, none),
      std::pair(Corners{ a, b, Point3(0.0, 0.0, 3.0) }, line) })
  {
    CHECK(!findShapeTerm(corners, metric, term));
    CHECK(term.block.isZero(0.0) && term.slopes[0].isZero(0.0) && term.slopes[2].isZero(0.0));
  }
}
}

int TestShapeTerm(int, char*[])
{
  testSlopes();
  testEquilateral();
  testNone();
  return test::result();
}
