// A run that is ended again after sites were added: repairs leave all others where they are.
#include "Support/Random.h"
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
  CHECK(remesh::remesh(mesh, surface, options, RunControl(), result).ok());
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
  CHECK(completeMesh(mesh, surface, options, RunControl(), result).ok());
  CHECK(result.movedSites > 0); // six were taken away
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
}

int TestCompleteMesh(int, char*[])
{
  testOthersStay();
  return test::result();
}
