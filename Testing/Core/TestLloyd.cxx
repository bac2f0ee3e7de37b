// Optimization/Lloyd: the energy falls as theory says, its gradient is right, no cell stays empty.

#include "Optimization/EmptyCells.h"
#include "Optimization/Lloyd.h"
#include "TestDiagrams.h"

#include <algorithm>

using namespace remesh;

namespace
{
/** What a step to the centroids gains at least: m_i |g_i - x_i|^2 = |moment_i|^2 / m_i, summed. */
double minGain(const CellSums& sums, int dimension)
{
  double gain = 0.0;
  for (std::size_t k = 0; k < sums.moment.size(); ++k)
  {
    const double mass = sums.mass[k / static_cast<std::size_t>(dimension)];
    gain += mass > 0.0 ? sums.moment[k] * sums.moment[k] / mass : 0.0;
  }
  return gain;
}

/** Step by step, against the bound; the rows tell the same. */
void checkDescent(const EmbeddedSurface& surface, Sites sites, int steps)
{
  RestrictedVoronoi voronoi(surface);
  CellSums sums;
  Convergence convergence;
  Index empty = 0;
  CHECK(relaxLloyd({ voronoi, surface, 1, sites, sums, convergence, empty }, 0, RunControl()).ok());
  CHECK_EQUAL(convergence.rows.size(), std::size_t(1));
  CHECK_EQUAL(convergence.rows[0].stepLength, 0.0);
  int rises = 0;
  for (int step = 0; step < steps; ++step)
  {
    const double energy = sums.totalEnergy;
    const double gain = minGain(sums, surface.dimension);
    Convergence two;
    CHECK(relaxLloyd({ voronoi, surface, 1, sites, sums, two, empty }, 1, RunControl()).ok());
    rises += !(sums.totalEnergy <= energy - gain + 1e-13 * energy);
    CHECK_EQUAL(two.rows.size(), std::size_t(2));
    CHECK_NEAR(two.rows[0].energy, energy, 1e-14 * energy); // the same sites, looked at again
    CHECK_EQUAL(two.rows[1].energy, sums.totalEnergy);
    CHECK_EQUAL(two.rows[1].gradientNorm, sums.gradientNorm);
    CHECK_EQUAL(two.rows[1].stepLength, 1.0);
    CHECK_EQUAL(two.rows[1].iteration, 1);
  }
  CHECK_EQUAL(rises, 0);
  CHECK_EQUAL(empty, 0);
  const test::Computed again = test::computed(surface, sites);
  CHECK_NEAR(again.sums.totalEnergy, sums.totalEnergy, 1e-13 * sums.totalEnergy);
  CHECK_NEAR(again.sums.gradientNorm, sums.gradientNorm, 1e-13 * surface.mass);
}

void testDescent()
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    for (const int d : { 3, 6, 17 })
    {
      const EmbeddedSurface surface = test::embedded(mesh, d);
      for (std::uint64_t seed = 0; seed < 2; ++seed)
      {
        checkDescent(surface, test::sampled(surface, 60, seed), 50);
      }
    }
  }
}

/**
 * After many steps the energy is near that of the hexagonal lattice, which is the least possible in
 * the plane: G = n F / A^2 against 5 / (18 sqrt 3).
 */
void testHexagonal()
{
  const double hexagonal = 5.0 / (18.0 * std::sqrt(3.0));
  const SurfaceMesh mesh = test::meshOf(test::icosphere(4));
  for (const int d : { 3, 6 })
  {
    const EmbeddedSurface surface = test::embedded(mesh, d);
    Sites sites = test::sampled(surface, 500, 1);
    RestrictedVoronoi voronoi(surface);
    CellSums sums;
    Convergence convergence;
    Index empty = 0;
    CHECK(
      relaxLloyd({ voronoi, surface, 1, sites, sums, convergence, empty }, 100, RunControl()).ok());
    const double g = sites.count() * sums.totalEnergy / (surface.mass * surface.mass);
    CHECK(g > 0.9 * hexagonal && g <= 1.03 * hexagonal);
  }
}

/** -2 moment against central differences of the energy; exact but for h^2 and rounding / h. */
void testGradient()
{
  const double h = 0x1p-17;
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    for (const int d : { 3, 6, 17 })
    {
      const EmbeddedSurface surface = test::embedded(mesh, d);
      Sites sites = test::shaken(test::sampled(surface, 30, 1), 0.05, 1);
      RestrictedVoronoi voronoi(surface);
      CellSums sums, moved;
      CHECK(voronoi.integrate(sites, RunControl(), sums).ok());
      double largest = 0.0;
      for (std::size_t k = 0; k < sites.coordinates.size(); k += 7)
      {
        const double middle = sites.coordinates[k];
        double energies[2];
        for (const int side : { 0, 1 })
        {
          sites.coordinates[k] = middle + (2 * side - 1) * h;
          CHECK(voronoi.integrate(sites, RunControl(), moved).ok());
          energies[side] = moved.totalEnergy;
        }
        sites.coordinates[k] = middle;
        const double slope = (energies[1] - energies[0]) / (2.0 * h);
        largest = std::max(largest, std::abs(slope + 2.0 * sums.moment[k]));
      }
      CHECK_NEAR(largest / sums.gradientNorm, 0.0, 1e-7);
    }
  }
}

/** A few steps from sites of which many have no cell: all end up with a fair one. */
void checkFilled(const EmbeddedSurface& surface, Sites sites)
{
  const Index n = sites.count();
  RestrictedVoronoi voronoi(surface);
  CellSums sums;
  Convergence convergence;
  Index empty = -1;
  CHECK(
    relaxLloyd({ voronoi, surface, 1, sites, sums, convergence, empty }, 20, RunControl()).ok());
  CHECK_EQUAL(empty, 0);
  CHECK_EQUAL(sites.count(), n);
  const double mean = surface.mass / n;
  CHECK(*std::min_element(sums.mass.begin(), sums.mass.end()) > 1e-3 * mean);
  for (const double coordinate : sites.coordinates)
  {
    CHECK(std::abs(coordinate) <= 1.0); // centroids lie in the hull of the surface
  }
  for (std::size_t row = 1; row < convergence.rows.size(); ++row)
  {
    CHECK(convergence.rows[row].energy <= convergence.rows[row - 1].energy * (1.0 + 1e-13));
  }
}

void testEmptyCells()
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    for (const int d : { 3, 6 })
    {
      const EmbeddedSurface surface = test::embedded(mesh, d);
      const Sites sites = test::sampled(surface, 80, 1);
      Sites coincident = sites, far = sites;
      for (Index site = 0; site < sites.count(); ++site)
      {
        std::copy_n(sites.site(0), d, coincident.site(site));
        far.site(site)[0] += site % 4 == 0 ? 0.0 : 100.0;
      }
      checkFilled(surface, coincident);
      checkFilled(surface, far);
    }
  }
}

/**
 * Cells that only touch the surface, along the border and within rounding: mirror images of sites
 * beyond it, with lower ids, on a square that is turned so that nothing is exact.
 */
void testTouchingCells()
{
  TriangleSoup soup = test::gridPatch(3, 3);
  const Eigen::AngleAxisd turn(0.7, Point3(1, 2, 3).normalized());
  for (Point3& point : soup.points)
  {
    point = turn * point;
  }
  const SurfaceMesh mesh = test::meshOf(soup);
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  for (int seed = 0; seed < 20; ++seed)
  {
    std::vector<Point3> places;
    for (int s = 0; s < 10; ++s)
    {
      const double x = 0.02 + 0.1 * uniform01(seed, s, 1);
      const double y = (s + uniform01(seed, s, 2)) / 10.0;
      places.insert(places.begin(), turn * Point3(-x, y, 0));
      places.emplace_back(turn * Point3(x, y, 0));
    }
    checkFilled(surface, test::sitesAt(surface, places));
  }
}

/** One site goes to the centroid of the surface in one step. */
void testOneSite()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::icosphere(2)), 3);
  Sites sites = test::shaken(test::sampled(surface, 1, 1), 3.0, 1);
  RestrictedVoronoi voronoi(surface);
  CellSums sums;
  Convergence convergence;
  Index empty = 0;
  CHECK(relaxLloyd({ voronoi, surface, 1, sites, sums, convergence, empty }, 2, RunControl()).ok());
  // The centre of the sphere is the centroid; another step changes nothing.
  for (int k = 0; k < 3; ++k)
  {
    CHECK_NEAR(sites.site(0)[k], 0.0, 1e-15);
  }
  CHECK_NEAR(sums.gradientNorm, 0.0, 1e-14);
}
}

int TestLloyd(int, char*[])
{
  testDescent();
  testHexagonal();
  testGradient();
  testEmptyCells();
  testTouchingCells();
  testOneSite();
  return test::result();
}
