// Voronoi/KeptPieces: with an earlier diagram at hand, that of other sites is the same to the bit.

#include "Features/FeatureGraph.h"
#include "TestDiagrams.h"
#include "TestSiteEdits.h"

#include <cstring>

using namespace remesh;

namespace
{
template <class Value>
bool sameBytes(const std::vector<Value>& a, const std::vector<Value>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

void checkSame(const test::Computed& a, const test::Computed& b)
{
  CHECK(a.owners == b.owners);
  CHECK(a.diagram.facetBegin == b.diagram.facetBegin);
  CHECK(a.diagram.sites == b.diagram.sites);
  CHECK(a.diagram.facets == b.diagram.facets);
  CHECK(a.diagram.vertexBegin == b.diagram.vertexBegin);
  CHECK(a.diagram.across == b.diagram.across);
  CHECK(sameBytes(a.diagram.weights, b.diagram.weights));
  CHECK(sameBytes(a.diagram.energies, b.diagram.energies));
  CHECK(a.sums.mass == b.sums.mass);
  CHECK(a.sums.energy == b.sums.energy && a.sums.moment == b.sums.moment);
}

test::Computed decomposed(
  const EmbeddedSurface& surface, const Sites& sites, const test::Computed* earlier)
{
  test::Computed result;
  RestrictedVoronoi voronoi(surface);
  std::optional<EarlierSites> known;
  if (earlier)
  {
    known.emplace(EarlierSites{ earlier->sites, earlier->owners });
    result.diagram = earlier->diagram;
  }
  CHECK(
    voronoi.decompose(sites, RunControl(), result.sums, result.diagram, known ? &*known : nullptr)
      .ok());
  result.owners = voronoi.owners();
  result.sites = sites;
  // What was told of the owners must not outlive the diagram.
  CellSums sums;
  const Sites moved = test::shaken(sites, 0.02, 5);
  CHECK(voronoi.integrate(moved, RunControl(), sums).ok());
  CellSums alone;
  CHECK(RestrictedVoronoi(surface).integrate(moved, RunControl(), alone).ok());
  CHECK_NEAR(test::largestDifference(sums.mass, alone.mass), 0.0, 1e-13 * surface.mass);
  return result;
}

/** How many facets keep their pieces. */
Index countKept(const EmbeddedSurface& surface, const test::Computed& earlier, const Sites& sites)
{
  KeptPieces kept(surface, { earlier.sites, earlier.owners }, earlier.diagram);
  CHECK(kept.find(sites, RunControl()).ok());
  Index count = 0;
  for (Index facet = 0; facet < surface.numberOfFacets(); ++facet)
  {
    count += kept.keeps(facet);
  }
  return count;
}

/** Chains of changes, each diagram made from the one before. */
void checkChain(const EmbeddedSurface& surface, Sites sites, std::uint64_t seed)
{
  test::Computed last = decomposed(surface, sites, nullptr);
  checkSame(last, decomposed(surface, sites, &last)); // nothing has changed
  CHECK_EQUAL(countKept(surface, last, sites),
    surface.dimension < manyDimensions ? surface.numberOfFacets() : 0);
  for (int round = 0; round < 8; ++round)
  {
    for (int k = 0; k < 1 << (round % 4); ++k)
    {
      test::edit(sites, surface, seed, 10 * round + k);
    }
    const test::Computed next = decomposed(surface, sites, &last);
    checkSame(next, decomposed(surface, sites, nullptr));
    last = next;
  }
}

void testRandomSites()
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    for (const int d : { 3, 6, 17, 70 })
    {
      const EmbeddedSurface surface = test::embedded(mesh, d);
      checkChain(surface, test::sampled(surface, 90, 2), 1);
      checkChain(surface, test::sampled(surface, 5, 3), 2);
      checkChain(surface, test::sampled(surface, 1, 3), 5);
    }
  }
}

/** Sites at the surface's points: distances that are equal, and decided by the order of the ids. */
void testTies()
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    checkChain(test::embedded(mesh, 3), test::sitesAt(test::embedded(mesh, 3), mesh.points), 3);
  }
  const SurfaceMesh grid = test::meshOf(test::gridPatch(12, 12));
  checkChain(test::embedded(grid, 3), test::sitesAt(test::embedded(grid, 3), grid.points), 4);
}

/** Patches that are put apart, and facets of other weights. */
void testPatches()
{
  SurfaceMesh mesh = test::meshOf(test::cube());
  const Features features = findFeatures(mesh, FeatureOptions());
  EmbeddedSurface surface = test::embedded(mesh, 6);
  separatePatches(features.facetPatches, features.numberOfPatches, surface);
  std::vector<double> densities;
  for (Index facet = 0; facet < surface.numberOfFacets(); ++facet)
  {
    densities.push_back(1.0 + uniform01(1, facet, 0));
  }
  weightByDensity(densities, surface);
  checkChain(surface, test::sampled(surface, 90, 2), 6);
}

/** What a diagram that was cancelled knows of owners is not believed later. */
void testCancelled()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::torus(1.0, 0.4, 24, 12)), 6);
  const test::Computed earlier = test::computed(surface, test::sampled(surface, 100, 2));
  const Sites moved = test::shaken(earlier.sites, 0.1, 5);
  CellSums expected;
  CHECK(RestrictedVoronoi(surface).integrate(moved, RunControl(), expected).ok());
  for (int asked = 0; asked < 40; ++asked)
  {
    int calls = 0;
    const RunControl control({}, [&]() { return calls++ >= asked; });
    RestrictedVoronoi voronoi(surface);
    CellSums sums;
    Diagram diagram = earlier.diagram;
    const EarlierSites known{ earlier.sites, earlier.owners };
    if (voronoi.decompose(earlier.sites, control, sums, diagram, &known).ok())
    {
      break;
    }
    CHECK(voronoi.integrate(moved, RunControl(), sums).ok());
    CHECK_NEAR(test::largestDifference(sums.mass, expected.mass), 0.0, 1e-13 * surface.mass);
  }
}

/** One site that moves changes a few facets around it. */
void testFewChange()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::torus(1.0, 0.4, 96, 48)), 6);
  const test::Computed earlier = test::computed(surface, test::sampled(surface, 900, 2));
  Sites sites = earlier.sites;
  sites.site(450)[0] += 1e-3;
  const Index changed = surface.numberOfFacets() - countKept(surface, earlier, sites);
  KeptPieces kept(surface, { earlier.sites, earlier.owners }, earlier.diagram);
  CHECK(kept.find(sites, RunControl()).ok());
  CHECK(changed > 0);
  CHECK(100 * changed < 2 * surface.numberOfFacets());
  const std::vector<Index> around = kept.sitesAround(sites);
  CHECK(std::binary_search(around.begin(), around.end(), 450));
  CHECK(around.size() < 40);
  // What is kept stays where it is, if there is room.
  Diagram diagram = earlier.diagram;
  diagram.weights.reserve(2 * diagram.weights.size());
  const PieceWeights* const memory = diagram.weights.data();
  CellSums sums;
  const EarlierSites known{ earlier.sites, earlier.owners };
  CHECK(RestrictedVoronoi(surface).decompose(sites, RunControl(), sums, diagram, &known).ok());
  CHECK(diagram.weights.data() == memory);
}
}

int TestKeptPieces(int, char*[])
{
  testRandomSites();
  testTies();
  testPatches();
  testCancelled();
  testFewChange();
  return test::result();
}
