// A run that is ended again after sites were added: repairs leave all others where they are. One
// that ends early.
#include "Support/Random.h"
#include "TestDiagrams.h"
#include "TestPlacements.h"

#include <algorithm>

namespace
{
using namespace remesh;

void testOthersStay()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.3, 80, 40));
  const EmbeddedSurface surface = test::gaussMapOf(mesh, 0.05);
  RemeshOptions options;
  options.numberOfSites = 400;
  options.exactNumber = true;
  RemeshResult result;
  CHECK(remesh::remesh({ mesh, surface, nullptr, options }, RunControl(), result).ok());
  CHECK(result.topology.certificate.holds());

  // More than there may be: as many must go.
  const Sites before = result.sites;
  const auto d = static_cast<std::size_t>(surface.dimension);
  for (Index k = 1; k <= 6; ++k)
  {
    for (std::size_t c = 0; c < d; ++c)
    {
      result.sites.coordinates.push_back(before.site(0)[c] + 1e-3 * (uniform01(1, k, c + 1) - 0.5));
    }
  }
  result.movedSites = 0;
  CHECK(completeMesh({ mesh, surface, nullptr, options }, RunControl(), result).ok());
  CHECK(result.movedSites > 0); // six were taken away
  test::checkMadeOf(surface, result.sites, result.diagram, result.sums);
  Index stayed = 0;
  for (Index i = 0; i < before.count(); ++i)
  {
    for (Index j = 0; j < result.sites.count(); ++j)
    {
      if (std::equal(before.site(i), before.site(i) + d, result.sites.site(j)))
      {
        ++stayed;
        break;
      }
    }
  }
  CHECK(stayed > 360);
}

/** A run ends at its first diagram where cells have more parts than they may. */
void testFallsApart()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.3, 80, 40));
  const EmbeddedSurface surface = test::gaussMapOf(mesh, 0.05);
  RemeshOptions options;
  options.numberOfSites = 400;
  for (const double most : { 0.99, 1.0 })
  {
    options.maxComponents = most;
    RemeshResult result;
    CHECK(remesh::remesh({ mesh, surface, nullptr, options }, RunControl(), result).ok());
    CHECK_EQUAL(result.fallsApart, most < 1.0);
    CHECK_EQUAL(result.components.count(), 400);
    CHECK_EQUAL(result.placement.positions.empty(), most < 1.0);
  }
}

/** The diagram may go once the vertices are placed; all else stays as it is. */
void testKeepDiagram()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.3, 80, 40));
  const EmbeddedSurface surface = test::gaussMapOf(mesh, 0.05);
  RemeshOptions options;
  options.numberOfSites = 300;
  RemeshResult kept;
  CHECK(remesh::remesh({ mesh, surface, nullptr, options }, RunControl(), kept).ok());
  options.keepDiagram = false;
  RemeshResult result;
  CHECK(remesh::remesh({ mesh, surface, nullptr, options }, RunControl(), result).ok());
  CHECK(kept.diagram.numberOfPieces() > 0);
  CHECK(result.diagram.sites.empty() && result.diagram.weights.empty());
  CHECK(result.dual.triangles == kept.dual.triangles);
  CHECK(result.placement.positions == kept.placement.positions);
  CHECK_EQUAL(result.topology.mesh.eulerCharacteristic, 0);
}
}

int TestCompleteMesh(int, char*[])
{
  testKeepDiagram();
  testFallsApart();
  testOthersStay();
  return test::result();
}
