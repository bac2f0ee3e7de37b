// Optimization/Sampling: on the surface, evenly, by the seed alone.

#include "TestEmbeddings.h"

#include <Eigen/Dense>

#include <algorithm>

using namespace remesh;

namespace
{
constexpr SamplingMethod methods[] = { SamplingMethod::Random, SamplingMethod::Stratified };

/** Barycentric coordinates of a point of R^d in the plane of a facet, by least squares. */
test::Barycentric project(
  const EmbeddedSurface& surface, Index facet, const double* point, double& distance)
{
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  const int d = surface.dimension;
  const auto [p0, p1, p2] = surface.facetCorners[facet];
  const Vector origin(surface.corner(p0), d);
  Eigen::MatrixXd sides(d, 2);
  sides << Vector(surface.corner(p1), d) - origin, Vector(surface.corner(p2), d) - origin;
  const Eigen::VectorXd target = Vector(point, d) - origin;
  const Eigen::Vector2d b = sides.colPivHouseholderQr().solve(target);
  distance = (sides * b - target).norm();
  return { 1.0 - b[0] - b[1], b[0], b[1] };
}

struct Place
{
  Index facet;
  test::Barycentric b;
};

/** The facets of the sites, which come in the facets' order; fewer if one lies on no facet. */
std::vector<Place> placesOf(const EmbeddedSurface& surface, const Sites& sites)
{
  std::vector<Place> places;
  Index facet = 0;
  for (Index site = 0; site < sites.count(); ++site)
  {
    for (; facet < surface.numberOfFacets(); ++facet)
    {
      double distance = 0.0;
      const test::Barycentric b = project(surface, facet, sites.site(site), distance);
      if (distance < 1e-14 && *std::min_element(b.begin(), b.end()) > -1e-12)
      {
        places.push_back({ facet, b });
        break;
      }
    }
  }
  return places;
}

void testOnSurface()
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    for (const int d : { 3, 6, 17 })
    {
      const EmbeddedSurface surface = test::embedded(mesh, d);
      for (const SamplingMethod method : methods)
      {
        for (const Offset n : { 1, 7, 500 })
        {
          const Sites sites = test::sampled(surface, n, 3, method);
          CHECK_EQUAL(sites.count(), n);
          CHECK_EQUAL(sites.dimension, d);
          CHECK_EQUAL(placesOf(surface, sites).size(), std::size_t(n));
        }
      }
    }
  }
}

/** Which of the four similar parts of its facet a place is in: at a corner, or in the middle. */
int quarterOf(const test::Barycentric& b)
{
  for (int k = 0; k < 3; ++k)
  {
    if (b[k] > 0.5)
    {
      return k;
    }
  }
  return 3;
}

/** Sum of (count - expected)^2 / expected over the quarters of all facets. */
double chiSquare(const EmbeddedSurface& surface, const std::vector<Place>& places)
{
  std::vector<double> counts(4 * static_cast<std::size_t>(surface.numberOfFacets()));
  for (const Place& place : places)
  {
    ++counts[4 * static_cast<std::size_t>(place.facet) + quarterOf(place.b)];
  }
  double sum = 0.0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin)
  {
    const double expected =
      static_cast<double>(places.size()) / surface.mass * surface.constants[bin / 4].mass / 4.0;
    sum += (counts[bin] - expected) * (counts[bin] - expected) / expected;
  }
  return sum;
}

/** Random: chi square is k - 1 with deviation sqrt(2 (k - 1)). Stratified: nearly none. */
void testEvenness()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 8, 6));
  for (const int d : { 3, 6 })
  {
    const EmbeddedSurface surface = test::embedded(mesh, d);
    const double freedom = 4.0 * surface.numberOfFacets() - 1.0;
    for (std::uint64_t seed = 0; seed < 3; ++seed)
    {
      const Sites random = test::sampled(surface, 10000, seed, SamplingMethod::Random);
      CHECK_NEAR(
        chiSquare(surface, placesOf(surface, random)), freedom, 5.0 * std::sqrt(2.0 * freedom));
      const Sites strata = test::sampled(surface, 10000, seed, SamplingMethod::Stratified);
      CHECK(chiSquare(surface, placesOf(surface, strata)) < 0.1 * freedom);
    }
  }
}

/** One site in each n-th of the curve: no facet is off by two sites. */
void testStrata()
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    const EmbeddedSurface surface = test::embedded(mesh, 6);
    const Sites sites = test::sampled(surface, 777, 5, SamplingMethod::Stratified);
    std::vector<double> counts(static_cast<std::size_t>(surface.numberOfFacets()));
    for (const Place& place : placesOf(surface, sites))
    {
      ++counts[place.facet];
    }
    for (std::size_t facet = 0; facet < counts.size(); ++facet)
    {
      CHECK_NEAR(counts[facet], 777.0 * surface.constants[facet].mass / surface.mass, 2.0);
    }
  }
}

void testSeeds()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::icosphere(1)), 6);
  for (const SamplingMethod method : methods)
  {
    const Sites sites = test::sampled(surface, 50, 0, method);
    CHECK(test::sampled(surface, 50, 0, method).coordinates == sites.coordinates);
    for (const std::uint64_t seed : { std::uint64_t(1), std::uint64_t(1) << 63 })
    {
      const Sites other = test::sampled(surface, 50, seed, method);
      int equal = 0;
      for (std::size_t k = 0; k < sites.coordinates.size(); ++k)
      {
        equal += sites.coordinates[k] == other.coordinates[k];
      }
      CHECK_EQUAL(equal, 0);
    }
  }
}

void testErrors()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::cube()), 3);
  for (const SamplingMethod method : methods)
  {
    for (const Offset n : { Offset(0), Offset(-1), maximumIndex + 1, Offset(1) << 40 })
    {
      Sites sites;
      const Status status = sampleSurface(surface, n, { method, 0 }, sites);
      CHECK(status.code == StatusCode::InvalidInput);
      CHECK(status.message.find(std::to_string(n)) != std::string::npos);
      CHECK_EQUAL(sites.count(), 0);
    }
  }
}

/** Facets without weight are never drawn, wherever they stand. */
void testZeroWeights()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::cube()), 3);
  std::vector<double> weights(12, 0.0);
  weights[4] = 1e-20;
  weights[9] = 3e-20;
  const FacetSampler sampler(surface, weights);
  Sites sites;
  sites.dimension = 3;
  sites.coordinates.resize(3);
  for (const double along : { 0.0, 0.2499, 0.25, 0.2501, 0.75, 1.0 - 0x1p-53 })
  {
    for (const bool onCurve : { false, true })
    {
      if (onCurve)
      {
        sampler.drawOnCurve(along, sites.site(0));
      }
      else
      {
        sampler.draw(along, 0.3, 0.4, sites.site(0));
      }
      double distance = 0.0;
      const test::Barycentric b = project(surface, along < 0.25 ? 4 : 9, sites.site(0), distance);
      CHECK(distance < 1e-15 && *std::min_element(b.begin(), b.end()) > -1e-15);
    }
  }
}
}

int TestSampling(int, char*[])
{
  testOnSurface();
  testEvenness();
  testStrata();
  testSeeds();
  testErrors();
  testZeroWeights();
  return test::result();
}
