// Optimization/QuasiNewton: it descends, faster than Lloyd's steps, and stops where it should.

#include "Optimization/EmptyCells.h"
#include "Optimization/Lloyd.h"
#include "Optimization/QuasiNewton.h"
#include "TestDiagrams.h"

#include <cmath>

using namespace remesh;

namespace
{
/** A minimisation from sampled sites, its first row made by no step. */
struct Run
{
  Sites sites;
  CellSums sums;
  Convergence convergence;
  Index empty = 0;
  int evaluations = 0;
};

Run minimized(const EmbeddedSurface& surface, Sites sites, const QuasiNewtonOptions& options)
{
  Run run;
  run.sites = std::move(sites);
  RestrictedVoronoi voronoi(surface);
  CHECK(relaxLloyd(
    { voronoi, surface, 1, run.sites, run.sums, run.convergence, run.empty }, 0, RunControl())
          .ok());
  CHECK(minimizeQuasiNewton(
    { voronoi, surface, 1, run.sites, run.sums, run.convergence, run.empty }, options, RunControl())
          .ok());
  run.evaluations = voronoi.evaluations();
  return run;
}

QuasiNewtonOptions steps(int iterations)
{
  QuasiNewtonOptions options;
  options.iterations = iterations;
  return options;
}

/** Each row is lower than the last; the sums on return are those of the sites on return. */
void testDescent()
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    for (const int d : { 3, 6, 17 })
    {
      const EmbeddedSurface surface = test::embedded(mesh, d);
      const Run run = minimized(surface, test::sampled(surface, 60, 1), steps(40));
      const auto& rows = run.convergence.rows;
      for (std::size_t k = 1; k < rows.size(); ++k)
      {
        CHECK(rows[k].energy < rows[k - 1].energy);
        CHECK(rows[k].stepLength > 0.0 && rows[k].stepLength <= 1.0);
        CHECK_EQUAL(rows[k].iteration, static_cast<int>(k));
      }
      CHECK_EQUAL(run.empty, 0);
      CHECK_EQUAL(rows.back().energy, run.sums.totalEnergy);
      const test::Computed again = test::computed(surface, run.sites);
      CHECK_NEAR(again.sums.totalEnergy, run.sums.totalEnergy, 1e-13 * run.sums.totalEnergy);
    }
  }
}

/** No step is longer than twice the root mean square radius of the cell it leaves. */
void testStepsStayNear()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::torus(1.0, 0.4, 36, 18)), 6);
  Sites start = test::sampled(surface, 400, 2);
  for (Index i = 0; i < 300; ++i) // most of them in one place, from which they spread
  {
    for (int k = 0; k < 6; ++k)
    {
      start.site(i)[k] = 0.5 * start.site(399)[k] + 0.5 * start.site(i)[k];
    }
  }
  Run before = minimized(surface, start, steps(0));
  int longest = 0;
  for (int count = 1; count < 12; ++count)
  {
    Run run = minimized(surface, start, steps(count));
    for (Index i = 0; i < start.count(); ++i)
    {
      const double most = 2.0 * std::sqrt(before.sums.energy[i] / before.sums.mass[i]);
      const double length =
        std::sqrt(test::exactDistance2(run.sites.site(i), before.sites.site(i), 6));
      CHECK(length <= most * (1.0 + 1e-9));
      longest += length > 0.999 * most;
    }
    before = std::move(run);
  }
  CHECK(longest > 0); // there are some that would be longer
}

/** Without a history a step is Lloyd's. */
void testFirstStepIsLloyds()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 36, 18));
  const EmbeddedSurface surface = test::embedded(mesh, 6);
  const Sites start = test::sampled(surface, 100, 2);
  QuasiNewtonOptions options = steps(3);
  options.historyLength = 0;
  const Run run = minimized(surface, start, options);
  Sites lloyd = start;
  RestrictedVoronoi voronoi(surface);
  CellSums sums;
  Convergence convergence;
  Index empty = 0;
  CHECK(relaxLloyd({ voronoi, surface, 1, lloyd, sums, convergence, empty }, 3, RunControl()).ok());
  for (std::size_t k = 0; k < lloyd.coordinates.size(); ++k)
  {
    CHECK_NEAR(run.sites.coordinates[k], lloyd.coordinates[k], 1e-12);
  }
}

/** How far a step is from Lloyd's direction, as a part of its length; `before` is where it began.
 */
double angleToLloyds(const Run& before, const Run& after)
{
  Eigen::VectorXd step(before.sums.moment.size());
  Eigen::VectorXd lloyds(before.sums.moment.size());
  for (Eigen::Index k = 0; k < step.size(); ++k)
  {
    step[k] = after.sites.coordinates[k] - before.sites.coordinates[k];
    lloyds[k] = before.sums.moment[k] / before.sums.mass[k / before.sites.dimension];
  }
  lloyds.normalize();
  return (step - step.dot(lloyds) * lloyds).norm() / step.norm();
}

/** The curvature that the energy showed along a step: its sign tells whether the pair is of use. */
double curvatureAlong(const Run& before, const Run& after)
{
  double product = 0.0;
  for (std::size_t k = 0; k < before.sums.moment.size(); ++k)
  {
    product += (after.sites.coordinates[k] - before.sites.coordinates[k]) *
      (before.sums.moment[k] - after.sums.moment[k]);
  }
  return product;
}

/** Where a step shows no positive curvature, the pair before stays: the next is not Lloyd's. */
void testRefusedPairs()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::icosphere(2)), 3);
  int refused = 0;
  for (const auto& [sites, seed] : { std::pair(5, 4), std::pair(10, 2), std::pair(10, 4) })
  {
    const Sites start = test::sampled(surface, sites, static_cast<std::uint64_t>(seed));
    const auto after = [&](int count)
    {
      QuasiNewtonOptions options = steps(count);
      options.historyLength = 1;
      return minimized(surface, start, options);
    };
    Run before = after(0);
    bool wasRefused = false;
    for (int count = 1; count < 14; ++count)
    {
      Run run = after(count);
      CHECK_EQUAL(run.convergence.rows.size(), static_cast<std::size_t>(count) + 1);
      const double angle = angleToLloyds(before, run);
      CHECK(count > 1 ? angle > 1e-3 : angle < 1e-9);
      refused += wasRefused;
      wasRefused = curvatureAlong(before, run) < 0.0;
      before = std::move(run);
    }
  }
  CHECK(refused > 5);
}

/** As many evaluations of Lloyd's method end higher, and with a larger gradient. */
void testFasterThanLloyd()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(4));
  const EmbeddedSurface surface = test::embedded(mesh, 6);
  const Sites start = test::sampled(surface, 400, 3);
  const Run run = minimized(surface, start, steps(60));
  Sites lloyd = start;
  RestrictedVoronoi voronoi(surface);
  CellSums sums;
  Convergence convergence;
  Index empty = 0;
  CHECK(relaxLloyd(
    { voronoi, surface, 1, lloyd, sums, convergence, empty }, run.evaluations - 1, RunControl())
          .ok());
  CHECK(run.sums.totalEnergy < sums.totalEnergy);
  CHECK(run.sums.gradientNorm < sums.gradientNorm);
}

/** With enough iterations the gradient vanishes: a centroidal tessellation. */
void testConvergence()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(2));
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  const Run run = minimized(surface, test::sampled(surface, 20, 4), steps(400));
  const auto& rows = run.convergence.rows;
  CHECK(rows.back().gradientNorm <= 1e-5 * rows.front().gradientNorm);
}

void testTolerances()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(3));
  const EmbeddedSurface surface = test::embedded(mesh, 6);
  const Sites start = test::sampled(surface, 100, 5);
  QuasiNewtonOptions options = steps(200);
  options.gradientTolerance = 0.1;
  const Run gradient = minimized(surface, start, options);
  const auto& g = gradient.convergence.rows;
  CHECK(g.size() < 200);
  CHECK(g.back().gradientNorm <= 0.1 * g.front().gradientNorm);
  CHECK(g[g.size() - 2].gradientNorm > 0.1 * g.front().gradientNorm);
  options = steps(200);
  options.energyTolerance = 1e-3;
  const Run energy = minimized(surface, start, options);
  const auto& e = energy.convergence.rows;
  CHECK(e.size() < 200);
  const std::size_t last = e.size() - 1;
  CHECK(e[last - 1].energy - e[last].energy <= 1e-3 * e[last - 1].energy);
  CHECK(e[last - 2].energy - e[last - 1].energy > 1e-3 * e[last - 1].energy);
}
}

int TestQuasiNewton(int, char*[])
{
  testDescent();
  testStepsStayNear();
  testFirstStepIsLloyds();
  testRefusedPairs();
  testFasterThanLloyd();
  testConvergence();
  testTolerances();
  return test::result();
}
