// Sites grown from a coarse tessellation: as many as wanted, evenly spread, and a lower energy.

#include "Features/FeatureGraph.h"
#include "Remesh.h"
#include "TestDiagrams.h"
#include "TestEmbeddings.h"

using namespace remesh;

namespace
{
RemeshOptions optionsOf(Offset numberOfSites, bool coarseStart)
{
  RemeshOptions options;
  options.numberOfSites = numberOfSites;
  options.coarseStart = coarseStart;
  options.placement = VertexPlacement::Centroid;
  return options;
}

RemeshResult resultOf(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const RemeshOptions& options, const Features* features = nullptr,
  Schedule schedule = Schedule::Smp)
{
  RemeshResult result;
  RunControl control;
  control.schedule = schedule;
  CHECK(remesh::remesh({ mesh, surface, features, options }, control, result).ok());
  return result;
}

/** Energy after k steps. */
double energyAfter(const RemeshResult& result, std::size_t k)
{
  return result.convergence.rows[k].energy;
}

void testEnergy()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 60, 36));
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  const RemeshResult drawn = resultOf(mesh, surface, optionsOf(2000, false));
  const RemeshResult grown = resultOf(mesh, surface, optionsOf(2000, true));
  CHECK_EQUAL(grown.sites.count(), 2000);
  CHECK_EQUAL(grown.emptyCells, 0);
  CHECK_EQUAL(grown.convergence.rows.size(), drawn.convergence.rows.size());
  CHECK(grown.evaluations > drawn.evaluations);
  CHECK(energyAfter(grown, 15) < energyAfter(drawn, 25));
  CHECK(energyAfter(grown, 35) < 0.9995 * energyAfter(drawn, 35));
  for (const Schedule schedule : { Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    const RemeshResult again = resultOf(mesh, surface, optionsOf(2000, true), nullptr, schedule);
    CHECK(again.sites.coordinates == grown.sites.coordinates);
  }
  // Too few for a coarse start, and nothing that iterates.
  for (RemeshOptions options : { optionsOf(200, false), optionsOf(2000, false) })
  {
    if (options.numberOfSites == 2000)
    {
      options.lloydIterations = 0;
      options.quasiNewton.iterations = 0;
    }
    const RemeshResult without = resultOf(mesh, surface, options);
    options.coarseStart = true;
    CHECK(resultOf(mesh, surface, options).sites.coordinates == without.sites.coordinates);
  }
}

/**
 * With features: as many vertices as wanted, each patch's by its area; nothing grows where features
 * take many of the points.
 */
void testFeatures(const TriangleSoup& soup, Offset numberOfSites, bool grows)
{
  SurfaceMesh mesh = test::meshOf(soup);
  const Features features = findFeatures(mesh, FeatureOptions());
  EmbeddedSurface surface = test::embedded(mesh, 3);
  separatePatches(features.facetPatches, features.numberOfPatches, surface);
  RemeshOptions options = optionsOf(numberOfSites, true);
  options.exactNumber = true;
  const RemeshResult grown = resultOf(mesh, surface, options, &features);
  CHECK_EQUAL(grown.components.count(), numberOfSites);
  CHECK(grown.topology.preserved());
  test::checkMadeOf(surface, grown.sites, grown.diagram, grown.sums);
  options.coarseStart = false;
  const RemeshResult drawn = resultOf(mesh, surface, options, &features);
  CHECK_EQUAL(grown.sums.totalEnergy < drawn.sums.totalEnergy, grows);
  CHECK_EQUAL(grown.sites.coordinates != drawn.sites.coordinates, grows);
}
}

int TestCoarseStart(int, char*[])
{
  testEnergy();
  testFeatures(test::cube(), 1500, false);
  testFeatures(test::gridPatch(40, 40), 8000, true);
  return test::result();
}
