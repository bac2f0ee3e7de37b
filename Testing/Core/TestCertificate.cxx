// Delaunay/Certificate: holds only where the dual has the surface's topology, counts what fails by
// the definition, and holds where there are enough sites; at pinches, where each sheet is right.

#include "Comparison/MeshTopology.h"
#include "Delaunay/CellDisks.h"
#include "Delaunay/Certificate.h"
#include "Features/FeatureGraph.h"
#include "Remesh.h"
#include "TestDuals.h"
#include "Voronoi/DiagramPoints.h"

#include <set>

using namespace remesh;

namespace
{
MeshTopology topologyOf(const std::vector<Triple>& triangles, Index numberOfPoints)
{
  MeshTopology topology;
  CHECK(measureConnectivity(
    triangles, buildEdgeTable(triangles), numberOfPoints, RunControl(), topology)
          .ok());
  return topology;
}

Certificate certificateOf(const test::Computed& result, const test::DualOf& made)
{
  Certificate certificate;
  CHECK(
    certify({ made.joins, result.diagram, made.components }, made.dual, RunControl(), certificate)
      .ok());
  return certificate;
}

/** Vertices - edges + faces of each closed cell, told apart by the points of the diagram. */
std::vector<int> eulerCharacteristics(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const test::Computed& result, const test::DualOf& made)
{
  DiagramPoints points;
  CHECK(numberDiagramPoints(
    mesh, made.joins.edges, { surface, result.sites, result.diagram }, RunControl(), points)
          .ok());
  std::vector<int> characteristics;
  for (Index k = 0; k < made.components.count(); ++k)
  {
    std::set<Offset> vertices;
    std::set<std::pair<Offset, Offset>> edges;
    const Offset begin = made.components.pieceBegin[k];
    const Offset end = made.components.pieceBegin[k + 1];
    for (Offset p = begin; p < end; ++p)
    {
      const Index piece = made.components.pieces[p];
      const Offset first = result.diagram.vertexBegin[piece];
      const Offset last = result.diagram.vertexBegin[piece + 1];
      for (Offset v = first; v < last; ++v)
      {
        const Offset a = points.ofVertex[v];
        const Offset b = points.ofVertex[v + 1 < last ? v + 1 : first];
        vertices.insert(a);
        edges.insert(std::minmax(a, b));
      }
    }
    characteristics.push_back(static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
      static_cast<int>(end - begin));
  }
  return characteristics;
}

struct Counts
{
  int proven = 0;
  int failed = 0;
  int missed = 0; ///< not proven, though the mesh is as it should be
};

/** Whatever the sites: disks are counted as by definition, and what is proven is true. */
void checkRandomSites(const TriangleSoup& soup, int dimension, Offset most, Counts& counts)
{
  const SurfaceMesh mesh = test::meshOf(soup);
  const EmbeddedSurface surface = test::embedded(mesh, dimension);
  const MeshTopology whole = topologyOf(mesh.facetPoints, mesh.numberOfPoints());
  for (std::uint64_t seed = 0; seed < 12; ++seed)
  {
    const Offset n = 1 + static_cast<Offset>(seed) * most / 11;
    const Sites sites = test::sampled(surface, n, seed, SamplingMethod::Stratified);
    const test::Computed result = test::computed(surface, sites);
    const test::DualOf made = test::dualOf(mesh, surface, result);
    std::vector<char> isDisk;
    CHECK(findDisks({ made.joins, result.diagram, made.components }, RunControl(), isDisk).ok());
    const std::vector<int> expected = eulerCharacteristics(mesh, surface, result, made);
    CHECK_EQUAL(isDisk.size(), expected.size());
    for (std::size_t k = 0; k < isDisk.size(); ++k)
    {
      CHECK_EQUAL(isDisk[k] != 0, expected[k] == 1);
    }
    const bool same =
      haveSameTopology(whole, topologyOf(made.dual.triangles, made.components.count()));
    const bool proven = certificateOf(result, made).holds();
    CHECK(same || !proven);
    counts.proven += proven;
    counts.failed += !proven;
    counts.missed += same && !proven;
  }
}

void testRandomSites()
{
  for (const int dimension : { 3, 6 })
  {
    for (const TriangleSoup& soup : { test::icosphere(3), test::torus(1.0, 0.3, 40, 16),
           test::torus(1.0, 0.1, 60, 8), test::gridPatch(12, 12), test::moebiusStrip(60) })
    {
      Counts counts;
      checkRandomSites(soup, dimension, 400, counts);
      CHECK(counts.failed > 0);
      if (soup.points.size() != test::moebiusStrip(60).points.size()) // as narrow as a cell
      {
        CHECK(counts.proven > 0);
      }
    }
  }
}

/** One cell, two halves, three slices of a sphere; the hemispheres' border is no segment. */
void testFewSites()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(3));
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  const auto certified = [&](const std::vector<Point3>& points)
  {
    const test::Computed result = test::computed(surface, test::sitesAt(surface, points));
    return certificateOf(result, test::dualOf(mesh, surface, result));
  };
  CHECK_EQUAL(certified({ { 0, 0, 1 } }).cells.size(), std::size_t(1));
  CHECK_EQUAL(certified({ { 0, 0, 1 }, { 0, 0, -1 } }).cells.size(), std::size_t(2));
  const Certificate slices = certified({ { 1, 0, 0 }, { -0.5, 0.8, 0 }, { -0.5, -0.8, 0 } });
  CHECK(slices.cells.empty());
  CHECK(slices.edges.empty()); // each has two ends
  CHECK_EQUAL(slices.vertices.size(), std::size_t(1));
  const Certificate simplex =
    certified({ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } });
  CHECK(simplex.holds());
}

/** A band of cells around a tube, and cells that reach from border to border. */
void testBands()
{
  TriangleSoup tube = test::torus(1.0, 0.2, 40, 12);
  tube.triangles.resize(tube.triangles.size() / 2);
  tube.inputCells.resize(tube.triangles.size());
  const SurfaceMesh mesh = test::meshOf(tube);
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  Sites sites = test::sampled(surface, 6, 1, SamplingMethod::Stratified);
  const test::Computed result = test::computed(surface, sites);
  const test::DualOf made = test::dualOf(mesh, surface, result);
  CHECK(!certificateOf(result, made).cells.empty());

  const SurfaceMesh square = test::meshOf(test::gridPatch(6, 6));
  const EmbeddedSurface flat = test::embedded(square, 3);
  const test::Computed stripes = test::computed(
    flat, test::sitesAt(flat, { { 0.1, 0.5, 0 }, { 0.5, 0.5, 0 }, { 0.9, 0.5, 0 } }));
  const Certificate certificate = certificateOf(stripes, test::dualOf(square, flat, stripes));
  CHECK_EQUAL(certificate.cells.size(), std::size_t(3)); // none has a triangle
  CHECK_EQUAL(certificate.edges.size(), std::size_t(2)); // from border to border
}

RemeshResult remeshed(const TriangleSoup& soup, Offset n)
{
  SurfaceMesh mesh = test::meshOf(soup);
  FeatureOptions featureOptions;
  featureOptions.spacing = 0.1;
  const Features features = findFeatures(mesh, featureOptions);
  EmbeddedSurface surface = test::embedded(mesh, 6);
  if (features.numberOfPatches > 1)
  {
    separatePatches(features.facetPatches, features.numberOfPatches, surface);
  }
  RemeshOptions options;
  options.numberOfSites = n;
  options.exactNumber = true;
  options.lloydIterations = 2;
  options.quasiNewton.iterations = 3;
  RemeshResult result;
  CHECK(remesh::remesh({ mesh, surface, &features, options }, RunControl(), result).ok());
  return result;
}

/** Along features: proven where the mesh is as it should be, with borders, creases and corners. */
void testFeatures()
{
  TriangleSoup tube = test::torus(1.0, 0.4, 36, 18);
  tube.triangles.resize(tube.triangles.size() / 2);
  tube.inputCells.resize(tube.triangles.size());
  for (const TriangleSoup& soup :
    { test::cube(), test::gridPatch(9, 9), tube, test::moebiusStrip(60), test::icosphere(1) })
  {
    for (const Offset n : { 30, 150, 400 })
    {
      const RemeshResult result = remeshed(soup, n);
      const TopologyResult& topology = result.topology;
      CHECK(topology.preserved() || n < 100);
      CHECK(haveSameTopology(topology.surface, topology.mesh) || !topology.preserved());
      CHECK_EQUAL(topology.describe().empty(), topology.preserved());
      CHECK_EQUAL(result.components.count(), Index(n));
    }
  }
}

/** Of surfaces that are pinched nothing is proven, but there is nothing to repair either. */
void testPinches()
{
  TriangleSoup balls = test::icosphere(3);
  test::append(balls, test::icosphere(3), 2.0 * balls.points[0]);
  for (const TriangleSoup& soup :
    { balls, test::patchWithHoles(9, { { 2, 2 }, { 3, 3 }, { 6, 5 } }) })
  {
    const RemeshResult result = remeshed(soup, 400);
    const TopologyResult& topology = result.topology;
    CHECK(!topology.preserved());
    CHECK(topology.certificate.holds());
    CHECK(haveSameTopology(topology.surface, topology.mesh));
    CHECK_EQUAL(topology.mesh.nonManifoldPoints, 1);
    CHECK_EQUAL(result.components.count(), Index(400)); // none more were tried
  }
  // A cell all around a tube is none of two disks.
  const TriangleSoup tube = test::torus(1.0, 0.05, 60, 16);
  TriangleSoup tubes = tube;
  test::append(tubes, tube, Point3(2.1, 0, 0));
  for (std::size_t k = tube.points.size(); k < tubes.points.size(); ++k)
  {
    Point3& point = tubes.points[k];
    point = (point - tubes.points[0]).norm() < 1e-9 ? tubes.points[0] : point;
  }
  const RemeshResult few = remeshed(tubes, 16);
  CHECK_EQUAL(few.seams.pinches.size(), std::size_t(1));
  if (few.seams.pinches.empty())
  {
    return;
  }
  const Index cell = few.seams.components[few.seams.pinches[0].point];
  const std::vector<Index>& failing = few.topology.certificate.cells;
  CHECK(std::binary_search(failing.begin(), failing.end(), cell));
}

/** So it is where three sheets meet on a line, also at its ends, where three borders end. */
void testThreeSheets()
{
  const RemeshResult result = remeshed(test::threeSheets(), 220);
  CHECK(!result.topology.preserved());
  CHECK(result.topology.certificate.holds());
  CHECK_EQUAL(result.topology.mesh.eulerCharacteristic, 1);
  CHECK_EQUAL(result.components.count(), Index(220));
  CHECK_EQUAL(result.movedSites, 0);
}
}

int TestCertificate(int, char*[])
{
  testFewSites();
  testBands();
  testRandomSites();
  testFeatures();
  testPinches();
  testThreeSheets();
  return test::result();
}
