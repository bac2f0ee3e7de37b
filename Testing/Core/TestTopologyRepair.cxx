// Delaunay/TopologyRepair: thin spikes, with too few sites around their tips, come out closed.

#include "Delaunay/TopologyRepair.h"
#include "Embedding/Embedding.h"
#include "Remesh.h"
#include "TestDuals.h"

using namespace remesh;

namespace
{
/** A sphere with six spikes along the axes. */
SurfaceMesh spikySphere()
{
  TriangleSoup soup = test::icosphere(5);
  for (Point3& point : soup.points)
  {
    const double angle = std::acos(std::min(1.0, point.cwiseAbs().maxCoeff() / point.norm()));
    point *= 1.0 + 3.0 * std::exp(-std::pow(angle / 0.1, 2.0));
  }
  return test::meshOf(soup);
}

EmbeddedSurface inSpace(const SurfaceMesh& mesh)
{
  EmbeddedSurface surface;
  CHECK(embedSurface(mesh, positionCoordinates(mesh), RunControl(), surface).ok());
  return surface;
}

RemeshOptions withSites(Offset count, std::uint64_t seed)
{
  RemeshOptions options;
  options.numberOfSites = count;
  options.seed = seed;
  return options;
}

/** What the optimiser alone gives has defects somewhere; what remesh() gives has none anywhere. */
void testSpikes()
{
  const SurfaceMesh mesh = spikySphere();
  const EmbeddedSurface surface = inSpace(mesh);
  int repaired = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed)
  {
    const Offset count = 800;
    RemeshResult result;
    CHECK(remesh::remesh(mesh, surface, withSites(count, seed), RunControl(), result).ok());
    CHECK_EQUAL(result.sites.count(), Index(count));
    CHECK_EQUAL(result.emptyCells, 0);
    CHECK(result.dual.defects.empty());
    CHECK_EQUAL(result.dual.repeated, 0);
    CHECK_EQUAL(result.dual.eulerCharacteristic, 2);
    const test::Shape shape = test::shapeOf(result.dual.triangles);
    CHECK(shape.isManifold());
    CHECK_EQUAL(shape.borderEdges, 0);
    CHECK_EQUAL(shape.vertices, static_cast<int>(count));
    CHECK_EQUAL(result.convergence.rows.size(), std::size_t(36)); // 1 + 5 Lloyd + 30 quasi-Newton
    repaired += result.movedSites > 0;
  }
  CHECK(repaired > 0);
}

/** Sites that stay: all but as many as there are defects. */
void testMovesOnlyDonors()
{
  const SurfaceMesh mesh = spikySphere();
  const EmbeddedSurface surface = inSpace(mesh);
  int seen = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed)
  {
    const Sites sites = test::sampled(surface, 1500, seed);
    const test::Computed result = test::computed(surface, sites);
    const test::DualOf made = test::dualOf(mesh, surface, result);
    Sites moved = sites;
    const Index count = moveSitesToDefects(
      surface, result.diagram, made.components, made.dual, result.sums, moved);
    Index changed = 0;
    for (Index i = 0; i < sites.count(); ++i)
    {
      changed += !std::equal(sites.site(i), sites.site(i) + 3, moved.site(i));
    }
    CHECK_EQUAL(changed, count);
    const auto defects = static_cast<Index>(made.dual.defects.size());
    CHECK_EQUAL(count, 100 * defects > sites.count() ? 0 : defects);
    seen += defects > 0;
  }
  CHECK(seen > 0);
}

/** Without iterations the sites are the caller's, defects or not. */
void testNothingAsked()
{
  const SurfaceMesh mesh = spikySphere();
  const EmbeddedSurface surface = inSpace(mesh);
  RemeshOptions options = withSites(800, 1);
  options.lloydIterations = 0;
  options.quasiNewton.iterations = 0;
  options.initialSites = test::sampled(surface, 800, 1);
  RemeshResult result;
  CHECK(remesh::remesh(mesh, surface, options, RunControl(), result).ok());
  CHECK_EQUAL(result.movedSites, 0);
  for (std::size_t k = 0; k < result.sites.coordinates.size(); ++k)
  {
    CHECK_NEAR(result.sites.coordinates[k], options.initialSites.coordinates[k], 1e-15);
  }
}

/** Too few points for the shape: left as it is, and it ends. */
void testHopeless()
{
  const SurfaceMesh mesh = spikySphere();
  const EmbeddedSurface surface = inSpace(mesh);
  RemeshResult result;
  CHECK(remesh::remesh(mesh, surface, withSites(20, 1), RunControl(), result).ok());
  CHECK_EQUAL(result.sites.count(), 20);
}
}

int TestTopologyRepair(int, char*[])
{
  testSpikes();
  testMovesOnlyDonors();
  testNothingAsked();
  testHopeless();
  return test::result();
}
