// Delaunay/TopologyRepair: thin spikes, with too few sites around their tips, come out closed.

#include "Delaunay/SiteRevision.h"
#include "Delaunay/TopologyRepair.h"
#include "Embedding/Distance.h"
#include "Embedding/Embedding.h"
#include "Features/FeatureGraph.h"
#include "Remesh.h"
#include "TestDuals.h"

#include <limits>
#include <numeric>
#include <set>

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

/** What the optimiser alone gives fails somewhere; what remesh() gives fails nowhere. */
void testSpikes()
{
  const SurfaceMesh mesh = spikySphere();
  const EmbeddedSurface surface = inSpace(mesh);
  int repaired = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed)
  {
    const Offset count = 800;
    RemeshOptions options = withSites(count, seed);
    options.exactNumber = true;
    RemeshResult result;
    CHECK(remesh::remesh({ mesh, surface, nullptr, options }, RunControl(), result).ok());
    CHECK_EQUAL(result.components.count(), Index(count));
    CHECK_EQUAL(result.emptyCells, 0);
    CHECK(result.topology.preserved());
    CHECK(result.dual.repeated.empty());
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

/** Sites are added where the certificate fails, as many go elsewhere, and all others stay. */
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
    Certificate certificate;
    CHECK(
      certify({ made.joins, result.diagram, made.components }, made.dual, RunControl(), certificate)
        .ok());
    const VertexPlaces places{ surface, result.sites, result.diagram };
    const Refinement refinement =
      refineTopology({ places, made.components, made.dual }, certificate, false);
    const auto count = static_cast<Index>(refinement.added.size() / 3);
    CHECK(refinement.removed.empty());
    CHECK_EQUAL(count > 0, !certificate.holds());
    CHECK(count <= certificate.violations());
    const Index kept = 700;
    for (const Index extra : { 0, 2, 400 })
    {
      Sites revised = sites;
      const Revision revision = reviseSites({ places, made.components, made.dual }, result.sums,
        refinement, { certificate, made.components.count() + extra, kept }, revised);
      CHECK(revision.added >= count);
      CHECK_EQUAL(revision.added - revision.removed, extra);
      CHECK_EQUAL(revised.count(), sites.count() + extra);
      std::set<std::vector<double>> before;
      for (Index i = 0; i < sites.count(); ++i)
      {
        before.insert({ sites.site(i), sites.site(i) + 3 });
      }
      Index stayed = 0;
      for (Index i = 0; i < revised.count() - revision.added; ++i)
      {
        stayed += before.count({ revised.site(i), revised.site(i) + 3 }) > 0;
      }
      CHECK_EQUAL(stayed, sites.count() - revision.removed);
      // The last ones are those that were not to go.
      CHECK(
        std::equal(sites.site(sites.count() - kept), sites.site(sites.count() - kept) + 3 * kept,
          revised.site(revised.count() - revision.added - kept)));
      // No two come to the same vertex of the diagram.
      double least = std::numeric_limits<double>::infinity();
      for (Index i = revised.count() - revision.added; i < revised.count(); ++i)
      {
        for (Index j = revised.count() - revision.added; j < i; ++j)
        {
          least =
            std::min(least, squaredDistance<Eigen::Dynamic>(revised.site(i), revised.site(j), 3));
        }
      }
      CHECK(least > 1e-12);
    }
    seen += count > 0;
  }
  CHECK(seen > 0);
}

/** Where one region has all the cells with the least energy, sites that go leave no hole there. */
void testDonorsApart()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(5));
  const EmbeddedSurface surface = inSpace(mesh);
  Sites sites = test::sampled(surface, 1000, 3);
  const Sites more = test::sampled(surface, 20000, 4);
  for (Index i = 0; i < more.count(); ++i) // ten times as dense around a pole
  {
    const double* site = more.site(i);
    if (site[2] > 0.9 * std::sqrt(site[0] * site[0] + site[1] * site[1] + site[2] * site[2]))
    {
      sites.coordinates.insert(sites.coordinates.end(), site, site + 3);
    }
  }
  const test::Computed result = test::computed(surface, sites);
  const test::DualOf made = test::dualOf(mesh, surface, result);
  const VertexPlaces places{ surface, result.sites, result.diagram };
  for (const Index fewer : { 10, 100 })
  {
    Sites revised = sites;
    const Revision revision = reviseSites({ places, made.components, made.dual }, result.sums,
      Refinement(), { Certificate(), made.components.count() - fewer, 0 }, revised);
    CHECK_EQUAL(revision.removed, fewer);
    std::set<std::vector<double>> left;
    for (Index i = 0; i < revised.count(); ++i)
    {
      left.insert({ revised.site(i), revised.site(i) + 3 });
    }
    std::vector<char> goes;
    for (Index i = 0; i < sites.count(); ++i)
    {
      goes.push_back(left.count({ sites.site(i), sites.site(i) + 3 }) == 0);
    }
    CHECK_EQUAL(std::accumulate(goes.begin(), goes.end(), Index(0)), fewer);
    for (const auto& [a, b, c] : made.dual.triangles)
    {
      const auto isGone = [&](Index k) { return static_cast<int>(goes[made.components.sites[k]]); };
      CHECK(isGone(a) + isGone(b) + isGone(c) <= 1);
    }
  }
}

/** Spheres apart from each other beside a cube, whose edges are features: closed patches. */
struct ClosedPatches
{
  static constexpr int spheres = 5;

  SurfaceMesh mesh;
  Features features;
  EmbeddedSurface surface;

  ClosedPatches()
    : mesh(test::meshOf(soup()))
    , features(findFeatures(mesh, FeatureOptions()))
    , surface(inSpace(mesh))
  {
    separatePatches(this->features.facetPatches, this->features.numberOfPatches, this->surface);
  }

  static TriangleSoup soup()
  {
    std::vector<Point3> points;
    std::vector<std::array<Offset, 3>> triangles;
    const auto append = [&](const TriangleSoup& part, double x, double size)
    {
      const auto first = static_cast<Offset>(points.size());
      for (const Point3& point : part.points)
      {
        points.push_back(size * point + Point3(x, 0.0, 0.0));
      }
      for (const auto& [a, b, c] : part.triangles)
      {
        triangles.push_back({ first + a, first + b, first + c });
      }
    };
    append(test::cube(), -4.0, 1.0);
    for (int k = 0; k < spheres; ++k)
    {
      append(test::icosphere(2), 4.0 * k, 1.0 / (k + 1.0));
    }
    return test::makeSoup(points, triangles);
  }

  /** The sites of each patch. */
  std::vector<Index> countSites(const Sites& sites) const
  {
    std::vector<Index> counts(static_cast<std::size_t>(this->features.numberOfPatches), 0);
    for (Index i = 0; i < sites.count(); ++i)
    {
      ++counts[this->surface.patches.patchOf(sites.site(i))];
    }
    return counts;
  }
};

/** However few vertices are wanted, closed patches keep the four sites they cannot do without. */
void testClosedPatches()
{
  const ClosedPatches parts;
  CHECK_EQUAL(parts.features.numberOfPatches, 6 + parts.spheres);
  for (const Offset asked : { 4, 30, 40, 60 }) // the cube's corners and edges take some
  {
    RemeshOptions options = withSites(asked, 0);
    options.exactNumber = true;
    RemeshResult result;
    CHECK(
      remesh::remesh({ parts.mesh, parts.surface, &parts.features, options }, RunControl(), result)
        .ok());
    for (const Index count : parts.countSites(result.sites))
    {
      CHECK(count >= 4);
    }
    for (Offset piece = 0; piece < result.diagram.numberOfPieces(); ++piece)
    {
      CHECK_EQUAL(parts.surface.patches.patchOf(result.sites.site(result.diagram.sites[piece])),
        parts.features.facetPatches[result.diagram.facets[piece]]);
    }
    CHECK_EQUAL(result.topology.mesh.components, Offset(1 + parts.spheres));
  }

  // Neither as donors nor where they are told to go.
  Sites sites = test::sampled(parts.surface, 2000, 1);
  const test::Computed computed = test::computed(parts.surface, sites);
  const test::DualOf made = test::dualOf(parts.mesh, parts.surface, computed);
  Refinement refinement;
  refinement.removed.resize(1000);
  std::iota(refinement.removed.begin(), refinement.removed.end(), Index(500));
  const Revision revision =
    reviseSites({ { parts.surface, computed.sites, computed.diagram }, made.components, made.dual },
      computed.sums, refinement, { Certificate(), 0, 0 }, sites);
  CHECK_EQUAL(revision.removed, 2000 - 4 * parts.features.numberOfPatches);
  for (const Index count : parts.countSites(sites))
  {
    CHECK_EQUAL(count, 4);
  }
}

/** A site for a triangle comes as far from all three of its sites; none comes to its neighbours. */
void testRefineTriangles()
{
  const SurfaceMesh mesh = spikySphere();
  const EmbeddedSurface surface = inSpace(mesh);
  const test::Computed result = test::computed(surface, test::sampled(surface, 1500, 0));
  const test::DualOf made = test::dualOf(mesh, surface, result);
  const VertexPlaces places{ surface, result.sites, result.diagram };
  const auto count = static_cast<Index>(made.dual.triangles.size());
  for (Index t = 0; t < count; t += 50)
  {
    const Refinement refinement =
      refineTriangles({ places, made.components, made.dual }, { t, (t + 1) % count, t });
    CHECK(refinement.removed.empty());
    CHECK(refinement.added.size() == 3 || refinement.added.size() == 6);
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const Index vertex : made.dual.triangles[t])
    {
      const double* site = result.sites.site(made.components.sites[vertex]);
      const double squared = squaredDistance<Eigen::Dynamic>(site, refinement.added.data(), 3);
      least = std::min(least, squared);
      most = std::max(most, squared);
    }
    CHECK_NEAR(most, least, 1e-12);
  }
  std::vector<Index> all(made.dual.triangles.size());
  std::iota(all.begin(), all.end(), Index(0));
  const Refinement refinement = refineTriangles({ places, made.components, made.dual }, all);
  CHECK(refinement.added.size() / 3 <= static_cast<std::size_t>(made.components.count()) / 3);
  CHECK(refinement.meetings.size() == refinement.added.size() / 3);
}

/** Four sites are too few for a torus: as many more as it takes, as many as allowed, or none. */
void testExtraPoints()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 36, 18));
  const EmbeddedSurface surface = inSpace(mesh);
  RemeshOptions options = withSites(4, 1);
  options.exactNumber = true;
  for (const Offset most : { Offset(0), Offset(2), maximumIndex })
  {
    options.maximumExtraPoints = most;
    RemeshResult result;
    CHECK(remesh::remesh({ mesh, surface, nullptr, options }, RunControl(), result).ok());
    CHECK_EQUAL(result.wantedVertices, 4);
    CHECK_EQUAL(result.topology.preserved(), most > 2);
    CHECK_EQUAL(
      result.topology.mesh.eulerCharacteristic == 0 && result.topology.preserved(), most > 2);
    CHECK(result.components.count() <= 4 + most);
    CHECK(most <= 2 || result.components.count() >= 7); // of each triangulation of a torus
    CHECK(most <= 2 || result.components.count() < 80);
  }
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
  CHECK(remesh::remesh({ mesh, surface, nullptr, options }, RunControl(), result).ok());
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
  CHECK(remesh::remesh({ mesh, surface, nullptr, withSites(20, 1) }, RunControl(), result).ok());
  CHECK_EQUAL(result.sites.count(), 20);
}
}

int TestTopologyRepair(int, char*[])
{
  testSpikes();
  testMovesOnlyDonors();
  testDonorsApart();
  testClosedPatches();
  testRefineTriangles();
  testExtraPoints();
  testNothingAsked();
  testHopeless();
  return test::result();
}
