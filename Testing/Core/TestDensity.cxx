// Embedding's density: it weights sums and gradient, and a run spaces the points by its 4th root.

#include "Remesh.h"
#include "TestDiagrams.h"

using namespace remesh;

namespace
{
/** Random densities between 1 and 16, one to a facet. */
std::vector<double> randomDensities(const SurfaceMesh& mesh)
{
  std::vector<double> densities;
  for (Index f = 0; f < mesh.numberOfFacets(); ++f)
  {
    densities.push_back(std::exp2(4.0 * uniform01(3, f, 0)));
  }
  return densities;
}

/** Each sum is the plain one, facet by facet, times the density. */
void testSums()
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    for (const int d : { 3, 6, 70 })
    {
      const EmbeddedSurface plain = test::embedded(mesh, d);
      EmbeddedSurface surface = plain;
      const std::vector<double> densities = randomDensities(mesh);
      weightByDensity(densities, surface);
      const Sites sites = test::sampled(plain, 30, 1);
      const test::Computed expected = test::computed(plain, sites);
      const test::Computed result = test::computed(surface, sites);
      std::vector<double> mass(30, 0.0), energy(30, 0.0);
      double total = 0.0;
      for (Offset p = 0; p < expected.diagram.numberOfPieces(); ++p)
      {
        const Index facet = expected.diagram.facets[p];
        const PieceIntegral integral = expected.diagram.integralOf(p);
        mass[expected.diagram.sites[p]] +=
          densities[facet] * integral.fraction() * plain.constants[facet].mass;
        energy[expected.diagram.sites[p]] += densities[facet] * integral.energy;
        total += densities[facet] * integral.energy;
      }
      const double unit = surface.densityUnit;
      for (Index i = 0; i < sites.count(); ++i)
      {
        CHECK_NEAR(result.sums.mass[i] * unit, mass[i], 1e-12 * plain.mass);
        CHECK_NEAR(result.sums.energy[i] * unit, energy[i], 1e-12 * total);
      }
      CHECK_NEAR(result.sums.totalEnergy * unit, total, 1e-12 * total);

      PlainSums sums;
      CHECK(sumSitesPlainly(surface, sites, result.diagram, RunControl(), sums).ok());
      CHECK_NEAR(test::largestDifference(sums.mass, expected.sums.mass), 0.0, 1e-13 * plain.mass);
      CHECK_NEAR(
        test::largestDifference(sums.energy, expected.sums.energy), 0.0, 1e-13 * plain.mass);
      CHECK_NEAR(
        test::largestDifference(sums.moment, expected.sums.moment), 0.0, 1e-13 * plain.mass);
    }
  }
}

/** grad_i = -2 moment_i, by central differences of the weighted energy. */
void testGradient()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 24, 12));
  EmbeddedSurface surface = test::embedded(mesh, 6);
  weightByDensity(randomDensities(mesh), surface);
  const Sites sites = test::sampled(surface, 40, 2);
  const test::Computed at = test::computed(surface, sites);
  constexpr double step = 1e-5;
  for (const Index site : { 0, 13, 39 })
  {
    for (int k = 0; k < 6; ++k)
    {
      const auto energyWith = [&](double shift)
      {
        Sites moved = sites;
        moved.site(site)[k] += shift;
        return test::computed(surface, moved).sums.totalEnergy;
      };
      const double slope = (energyWith(step) - energyWith(-step)) / (2.0 * step);
      CHECK_NEAR(slope, -2.0 * at.sums.moment[6 * site + k], 1e-5 * at.sums.gradientNorm);
    }
  }
}

/** The square, dense beyond x = 1/2. */
struct HalfDense
{
  SurfaceMesh mesh = test::meshOf(test::gridPatch(40, 40));
  EmbeddedSurface surface = test::embedded(mesh, 3);

  explicit HalfDense(double ratio, double scale = 1.0)
  {
    std::vector<double> densities;
    for (const auto& [a, b, c] : this->mesh.facetPoints)
    {
      const double middle =
        (this->mesh.points[a] + this->mesh.points[b] + this->mesh.points[c])[0] / 3.0;
      densities.push_back(scale * (middle > 0.5 ? ratio : 1.0));
    }
    weightByDensity(densities, this->surface);
  }
};

RemeshResult remeshed(
  const HalfDense& input, int iterations, Offset numberOfSites = 2000, bool coarseStart = true)
{
  RemeshOptions options;
  options.numberOfSites = numberOfSites;
  options.coarseStart = coarseStart;
  options.quasiNewton.iterations = iterations;
  options.lloydIterations = iterations > 0 ? 5 : 0;
  RemeshResult result;
  CHECK(remesh::remesh({ input.mesh, input.surface, nullptr, options }, RunControl(), result).ok());
  return result;
}

/**
 * Density 16 : 1 gives spacing 1 : 2, in the first sampling and in the end; and with a coarse
 * start, which is closer to the least energy, where the row of cells between weighs less.
 */
void testSpacing()
{
  const HalfDense input(16.0);
  for (const auto& [iterations, numberOfSites] : { std::pair(0, 2000), { 40, 2000 }, { 40, 8000 } })
  {
    const RemeshResult result = remeshed(input, iterations, numberOfSites, numberOfSites > 2000);
    double denseArea = 0.0, dense = 0.0;
    for (Index k = 0; k < result.components.count(); ++k)
    {
      if (result.components.centroids[k][0] > 0.5)
      {
        denseArea += result.components.area[k];
        dense += 1.0;
      }
    }
    const double sparse = result.components.count() - dense;
    const double ratio = std::sqrt(dense / denseArea / (sparse / (1.0 - denseArea)));
    CHECK_NEAR(ratio, 2.0, 0.04);
  }
}

/** Only ratios matter: to the bit, where the factor is a power of four. */
void testScale()
{
  const RemeshResult one = remeshed(HalfDense(16.0), 10);
  for (const double scale : { 0x1.0p-400, 4.0, 0x1.0p400 })
  {
    const RemeshResult other = remeshed(HalfDense(16.0, scale), 10);
    CHECK(other.sites.coordinates == one.sites.coordinates);
    CHECK(other.sums.mass == one.sums.mass);
  }
  const HalfDense even(1.0);
  CHECK_NEAR(even.surface.mass * even.surface.densityUnit * even.surface.unit * even.surface.unit,
    1.0, 1e-12);
}
}

int TestDensity(int, char*[])
{
  testSums();
  testGradient();
  testSpacing();
  testScale();
  return test::result();
}
