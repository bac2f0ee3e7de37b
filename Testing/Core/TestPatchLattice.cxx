// Patches moved apart: far enough, each point known by its patch, and the same coordinates again.

#include "Embedding/Distance.h"
#include "Features/FeatureGraph.h"
#include "TestChecks.h"
#include "TestEmbeddings.h"
#include "TestSurfaces.h"

#include <cmath>

using namespace remesh;

namespace
{
/** A point of the cube [-1, 1]^d; the first of them are corners. */
std::vector<double> pointInCube(int dimension, std::uint64_t k)
{
  std::vector<double> point(static_cast<std::size_t>(dimension));
  for (int c = 0; c < dimension; ++c)
  {
    const double random = 2.0 * uniform01(k, static_cast<std::uint64_t>(c), 3) - 1.0;
    point[static_cast<std::size_t>(c)] = k < 20 ? std::copysign(1.0, random) : random;
  }
  return point;
}

std::vector<double> moved(std::vector<double> point, const PatchLattice& lattice, Index patch)
{
  for (std::size_t c = 0; c < point.size(); ++c)
  {
    point[c] += lattice.offset(patch, static_cast<int>(c));
  }
  return point;
}

void testDistances()
{
  for (const int d : { 1, 2, 3, 6, 12, 13, 700 })
  {
    const double diameter = 2.0 * std::sqrt(static_cast<double>(d));
    for (const Index patches : { 2, 3, 8, 9, 28, 200, 5000 })
    {
      const PatchLattice lattice(d, patches);
      CHECK(lattice.minDistance() > 2.0 * diameter);
      for (std::uint64_t k = 0; k < (d < 100 ? 2000 : 50); ++k)
      {
        const auto a = static_cast<Index>(patches * uniform01(k, 0, 5));
        const auto b = static_cast<Index>(patches * uniform01(k, 1, 5));
        const std::vector<double> x = moved(pointInCube(d, k % 50), lattice, a);
        const std::vector<double> y = moved(pointInCube(d, (k + 7) % 50), lattice, b);
        CHECK_EQUAL(lattice.patchOf(x.data()), a);
        const double distance = std::sqrt(squaredDistance<Eigen::Dynamic>(x.data(), y.data(), d));
        CHECK(a == b ? distance <= 1.001 * diameter : distance >= lattice.minDistance());
      }
    }
  }
  const PatchLattice one;
  const double anywhere = 1e9;
  CHECK_EQUAL(one.patchOf(&anywhere), 0);
  CHECK_EQUAL(one.offset(0, 0), 0.0);
  CHECK(std::isinf(one.minDistance()));
}

/** A cube cut open at its edges: the embedding comes back, and no dimension is added. */
void testSurface()
{
  SurfaceMesh mesh = test::meshOf(test::cube());
  const Features features = findFeatures(mesh, FeatureOptions());
  CHECK_EQUAL(features.numberOfPatches, 6);
  for (const int d : { 3, 6, 9 })
  {
    const EmbeddedSurface before = test::embedded(mesh, d);
    EmbeddedSurface surface = before;
    separatePatches(features.facetPatches, features.numberOfPatches, surface);
    CHECK_EQUAL(surface.dimension, d);
    for (Index f = 0; f < surface.numberOfFacets(); ++f)
    {
      for (const Index corner : surface.facetCorners[f])
      {
        CHECK_EQUAL(surface.patches.patchOf(surface.corner(corner)), features.facetPatches[f]);
        std::vector<double> coordinates(static_cast<std::size_t>(d));
        surface.toCaller(surface.corner(corner), coordinates.data());
        for (int k = 0; k < d; ++k)
        {
          const double wanted = before.toCaller(before.corner(corner)[k], k);
          CHECK(
            std::abs(coordinates[static_cast<std::size_t>(k)] - wanted) <= 1e-14 * surface.unit);
        }
      }
    }
  }
}

/** What is known of edges is what the corners say where they are now, rounded as they are. */
void testEdges()
{
  TriangleSoup soup = test::cube();
  for (Point3& point : soup.points)
  {
    point = Point3(point[0] - 0.3 * point[1], 0.7 * point[1] + 0.1 * point[2], point[2] / 3.0);
  }
  SurfaceMesh mesh = test::meshOf(soup);
  const Features features = findFeatures(mesh, FeatureOptions());
  EmbeddedSurface surface = test::embedded(mesh, 6);
  separatePatches(features.facetPatches, features.numberOfPatches, surface);
  for (Index f = 0; f < surface.numberOfFacets(); ++f)
  {
    const Triple& corners = surface.facetCorners[f];
    for (int k = 0; k < 3; ++k)
    {
      CHECK_EQUAL(surface.constants[f].edge2[k],
        squaredDistance<6>(
          surface.corner(corners[k]), surface.corner(corners[(k + 1) % 3]), surface.dimension));
    }
  }
}

/** Rounding sites keeps them in their patch, where they were, and does so once and for all. */
void testRounding(double away)
{
  TriangleSoup soup = test::cube();
  for (Point3& point : soup.points)
  {
    point += Point3(away, -2.0 * away, 0.3 * away);
  }
  SurfaceMesh mesh = test::meshOf(soup);
  const Features features = findFeatures(mesh, FeatureOptions());
  EmbeddedSurface surface = test::embedded(mesh, 6);
  separatePatches(features.facetPatches, features.numberOfPatches, surface);
  const Sites sites = test::sampled(surface, 300, 1);
  Sites once = sites;
  roundToCaller(surface, once);
  for (Index i = 0; i < sites.count(); ++i)
  {
    CHECK_EQUAL(surface.patches.patchOf(once.site(i)), surface.patches.patchOf(sites.site(i)));
    CHECK(squaredDistance<6>(once.site(i), sites.site(i), 6) <= 1e-28 * std::max(1.0, away * away));
  }
  Sites twice = once;
  roundToCaller(surface, twice);
  CHECK(twice.coordinates == once.coordinates);
}
}

int TestPatchLattice(int, char*[])
{
  testDistances();
  testSurface();
  testEdges();
  for (const double away : { 0.0, 10.0, 1e3, 1e6 })
  {
    testRounding(away);
  }
  return test::result();
}
