// Repair/SiteProposals: where triangles on one side of a thin sheet lie next to the other side,
// sites are added until they do not.

#include "Repair/Facing.h"
#include "TestPlacements.h"
#include "TestSurfaces.h"

#include <tuple>

using namespace remesh;

int TestStrays(int, char*[])
{
  using Case = std::tuple<double, double, int>;
  for (const auto& [thickness, anisotropy, number] : { Case(0.02, 0.02, 1000), Case(0.03, 0.0, 500),
         Case(0.03, 0.02, 1000), Case(0.05, 0.04, 500), Case(0.08, 0.1, 500) })
  {
    const SurfaceMesh mesh = test::meshOf(test::leaf(5, thickness));
    const EmbeddedSurface surface = test::gaussMapOf(mesh, anisotropy);
    RemeshOptions options;
    options.numberOfSites = number;
    options.exactNumber = true;
    RemeshResult result;
    CHECK(remesh::remesh({ mesh, surface, nullptr, options }, RunControl(), result).ok());
    CHECK_EQUAL(result.components.count(), number);
    CHECK(result.topology.preserved());
    CHECK_EQUAL(result.placement.edits.flippedEdges, 0); // so the mesh is still the dual
    const Task task{ mesh, surface, nullptr, options };
    const WrongTriangles wrong = findWrongTriangles(task, MeshSteps::Move, RunControl(), result);
    CHECK(wrong.inverted.empty());
    CHECK(wrong.strays.empty());
  }
  return test::result();
}
