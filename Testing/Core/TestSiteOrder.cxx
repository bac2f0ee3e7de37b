// Optimization/SiteOrder: scattered sites are known as such, and each keeps its number in a run.

#include "Optimization/SiteOrder.h"
#include "Remesh.h"
#include "Support/Random.h"
#include "TestEmbeddings.h"

#include <algorithm>
#include <numeric>

using namespace remesh;

namespace
{
std::vector<Index> shuffled(Index count)
{
  std::vector<Index> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [](Index a, Index b) { return uniform01(1, a, 0) < uniform01(1, b, 0); });
  return order;
}

void testOrder()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(4));
  for (const int d : { 3, 6, 17 })
  {
    const EmbeddedSurface surface = test::embedded(mesh, d);
    const Sites sites = test::sampled(surface, 1000, 1);
    CHECK(!areScattered(sites));
    const Sites scattered = inOrder(sites, shuffled(1000));
    CHECK(areScattered(scattered));
    const std::vector<Index> order = orderInSpace(scattered);
    const Sites ordered = inOrder(scattered, order);
    CHECK(!areScattered(ordered));
    CHECK(inFormerOrder(ordered, order).coordinates == scattered.coordinates);
  }
  Sites plane; // of fewer coordinates than three
  plane.dimension = 2;
  plane.coordinates = { 0.0, 0.0, 1.0, 1.0, 0.0, 0.1, 1.0, 0.9 };
  CHECK(areScattered(plane));
  CHECK(!areScattered(Sites{}));
}

/** A run from scattered sites ends with the sites of one in order, each under its own number. */
void testRun()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(3));
  const EmbeddedSurface surface = test::embedded(mesh, 6);
  RemeshOptions options;
  options.numberOfSites = 300;
  options.lloydIterations = 2;
  options.quasiNewton.iterations = 4;
  options.initialSites = test::sampled(surface, 300, 3);
  RemeshResult inTurn;
  CHECK(remesh::remesh({ mesh, surface, nullptr, options }, RunControl(), inTurn).ok());
  const std::vector<Index> order = shuffled(300);
  options.initialSites = inOrder(options.initialSites, order);
  CHECK(areScattered(options.initialSites));
  RemeshResult scattered;
  CHECK(remesh::remesh({ mesh, surface, nullptr, options }, RunControl(), scattered).ok());
  const Sites expected = inOrder(inTurn.sites, order);
  CHECK_EQUAL(scattered.sites.count(), expected.count());
  for (std::size_t k = 0; k < expected.coordinates.size(); ++k)
  {
    CHECK_NEAR(scattered.sites.coordinates[k], expected.coordinates[k], 1e-9);
  }
}
}

int TestSiteOrder(int, char*[])
{
  testOrder();
  testRun();
  return test::result();
}
