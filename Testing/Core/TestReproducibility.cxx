// Remesh: the same bytes whatever runs the blocks, in whatever order, and again.

#include "Features/FeatureGraph.h"
#include "Remesh.h"
#include "TestDiagrams.h"
#include "TestEmbeddings.h"
#include "Voronoi/DiagramPoints.h"

#include "vtkSMPTools.h"

#include <cmath>
#include <numeric>
#include <string>

using namespace remesh;

namespace
{
/** The bytes of a result, value by value (structures have padding). */
class Bytes
{
public:
  template <class T>
  void add(const T& value)
  {
    static_assert(std::is_arithmetic_v<T>);
    m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  template <class T, std::size_t N>
  void add(const T (&values)[N])
  {
    for (const T& value : values)
    {
      this->add(value);
    }
  }

  template <class T, std::size_t N>
  void add(const std::array<T, N>& values)
  {
    for (const T& value : values)
    {
      this->add(value);
    }
  }

  void add(const Point3& point)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->add(point[k]);
    }
  }

  template <class T>
  void add(const SharedArray<T>& values)
  {
    this->add(static_cast<const std::vector<T>&>(values));
  }

  void add(const PieceWeights& part)
  {
    this->add(part.fraction());
    this->add(part.weights);
  }

  void add(const SurfaceLocation& location)
  {
    this->add(location.facet);
    this->add(location.b);
  }

  void add(const ConvergenceRow& row)
  {
    this->add(row.iteration);
    this->add(row.energy);
    this->add(row.gradientNorm);
    this->add(row.stepLength); // and not the time
  }

  template <class T>
  void add(const std::vector<T>& values)
  {
    this->add(values.size());
    for (const T& value : values)
    {
      this->add(value);
    }
  }

  template <class... Parts>
  void addAll(const Parts&... parts)
  {
    (this->add(parts), ...);
  }

  const std::string& string() const { return m_bytes; }

private:
  std::string m_bytes;
};

std::string bytesOf(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const RemeshResult& result, const RunControl& control, const Features* features)
{
  Bytes bytes;
  DiagramPoints points;
  CHECK(numberDiagramPoints(mesh, buildCutEdgeTable(mesh, features, control),
    { surface, result.sites, result.diagram }, control, points)
          .ok());
  bytes.add(points.ofVertex);
  for (const DiagramPoint& point : points.points)
  {
    bytes.addAll(point.facet, point.b);
  }
  bytes.addAll(result.sites.coordinates, result.emptyCells, result.evaluations);
  const CellSums& sums = result.sums;
  bytes.addAll(sums.mass, sums.energy, sums.moment, sums.totalEnergy, sums.gradientNorm);
  for (const PlainSums* plain : { &result.plainSums, &result.plainComponentSums })
  {
    bytes.addAll(plain->mass, plain->energy, plain->moment);
  }
  const Diagram& diagram = result.diagram;
  bytes.addAll(diagram.facetBegin, diagram.sites, diagram.facets, diagram.weights, diagram.energies,
    diagram.vertexBegin, diagram.across);
  const Components& components = result.components;
  bytes.addAll(components.ofPiece, components.sites, components.ranks, components.pieceBegin,
    components.pieces, components.mass, components.area, components.energy, components.centroids);
  bytes.addAll(result.locations, result.placement.positions, result.dual.triangles,
    result.dual.repeated, result.dual.edges.edges, result.dual.eulerCharacteristic,
    result.numbersOfNeighbors, result.cellAreas, result.convergence.rows);
  for (const auto& [ends, triangles] : result.dual.edges.irregular)
  {
    bytes.addAll(ends.first, ends.second, triangles);
  }
  return bytes.string();
}

std::string run(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const RemeshOptions& options, Schedule schedule, const Features* features)
{
  RunControl control;
  control.schedule = schedule;
  RemeshResult result;
  CHECK(remesh::remesh({ mesh, surface, features, options }, control, result).ok());
  CHECK(features || result.sites.count() == Index(options.numberOfSites));
  return bytesOf(mesh, surface, result, control, features);
}

/** The product with each back-end that this VTK has, and the two schedules that disturb it. */
void checkCase(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const RemeshOptions& options, const Features* features = nullptr)
{
  const std::string expected = run(mesh, surface, options, Schedule::Smp, features);
  CHECK(run(mesh, surface, options, Schedule::Smp, features) == expected);
  CHECK(run(mesh, surface, options, Schedule::ShuffledBlocks, features) == expected);
  CHECK(run(mesh, surface, options, Schedule::EightThreads, features) == expected);
  const std::string backend = vtkSMPTools::GetBackend();
  for (const char* name : { "Sequential", "STDThread", "TBB" })
  {
    if (vtkSMPTools::SetBackend(name))
    {
      CHECK(run(mesh, surface, options, Schedule::Smp, features) == expected);
    }
  }
  vtkSMPTools::SetBackend(backend.c_str());
  RemeshOptions other = options;
  other.seed = options.seed + 1;
  CHECK(run(mesh, surface, other, Schedule::Smp, features) != expected);
}

/** The intake, with facets to merge, to drop and to turn. */
void testIntake()
{
  TriangleSoup soup = test::torus(1.0, 0.4, 120, 80);
  const std::size_t count = soup.triangles.size();
  for (std::size_t t = 0; t < count; t += 7)
  {
    const auto [a, b, c] = soup.triangles[t];
    soup.points.push_back(soup.points[a]);
    soup.triangles[t] = { static_cast<Offset>(soup.points.size()) - 1, c, b };
    soup.triangles.push_back({ b, a, c });
    soup.triangles.push_back({ b, a, b });
  }
  soup.inputCells.resize(soup.triangles.size());
  std::iota(soup.inputCells.begin(), soup.inputCells.end(), Offset(0));
  std::string expected;
  for (const Schedule schedule :
    { Schedule::Smp, Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    RunControl control;
    control.schedule = schedule;
    SurfaceMesh mesh;
    IntakeReport report;
    CHECK(buildSurfaceMesh(soup, IntakeOptions(), control, mesh, report).ok());
    CHECK_EQUAL(report.mergedPoints, report.droppedDuplicate);
    CHECK_EQUAL(report.mergedPoints, report.droppedDegenerate);
    CHECK_EQUAL(report.mergedPoints, report.flippedFacets);
    CHECK_EQUAL(report.components, 1);
    const EdgeTable edges = buildEdgeTable(mesh.facetPoints, control);
    Bytes bytes;
    bytes.addAll(mesh.points, mesh.facetPoints, mesh.facetCorners, mesh.cornerPoints,
      mesh.facetInputCells, edges.facetEdges, edges.edgeFacetsBegin, edges.edgeFacets);
    for (std::size_t f = 0; f < mesh.facetInputPoints.size(); ++f)
    {
      bytes.add(mesh.facetInputPoints[f]);
    }
    expected = expected.empty() ? bytes.string() : expected;
    CHECK(bytes.string() == expected);
  }
}

/** The embedding itself runs in blocks, too. */
void testEmbedding(const SurfaceMesh& mesh)
{
  std::string expected;
  for (const Schedule schedule :
    { Schedule::Smp, Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    RunControl control;
    control.schedule = schedule;
    EmbeddedSurface surface;
    CHECK(embedSurface(mesh, positionCoordinates(mesh), control, surface).ok());
    Bytes bytes;
    bytes.addAll(surface.corners, surface.center, surface.unit, surface.mass);
    for (const FacetConstants& constants : surface.constants)
    {
      bytes.addAll(constants.mass, constants.edge2);
    }
    expected = expected.empty() ? bytes.string() : expected;
    CHECK(bytes.string() == expected);
  }
}

/** Energies with weights, from facet to facet. */
void testDensity(const SurfaceMesh& mesh)
{
  std::vector<double> densities;
  for (const Triple& points : mesh.facetPoints)
  {
    densities.push_back(std::exp(mesh.points[points[0]].x()));
  }
  EmbeddedSurface surface = test::embedded(mesh, 6);
  weightByDensity(densities, surface);
  RemeshOptions options;
  options.numberOfSites = 400;
  options.lloydIterations = 2;
  options.quasiNewton.iterations = 4;
  checkCase(mesh, surface, options);
  CHECK(run(mesh, surface, options, Schedule::Smp, nullptr) !=
    run(mesh, test::embedded(mesh, 6), options, Schedule::Smp, nullptr));
}

/** Patches that are moved apart, their copies of sites, and the fit. */
void testFeatures()
{
  SurfaceMesh mesh = test::meshOf(test::cube());
  const Features features = findFeatures(mesh, FeatureOptions());
  EmbeddedSurface surface = test::embedded(mesh, 6);
  separatePatches(features.facetPatches, features.numberOfPatches, surface);
  RemeshOptions options;
  options.numberOfSites = 900; // more than a block of the fit
  options.exactNumber = true;
  options.lloydIterations = 2;
  options.quasiNewton.iterations = 4;
  options.placement = VertexPlacement::Fit;
  checkCase(mesh, surface, options, &features);
  RemeshResult result;
  CHECK(remesh::remesh({ mesh, surface, &features, options }, RunControl(), result).ok());
  CHECK(result.movedSites > 0);
  test::checkMadeOf(surface, result.sites, result.diagram, result.sums);
}
}

int TestReproducibility(int, char*[])
{
  const SurfaceMesh fine = test::meshOf(test::torus(1.0, 0.4, 30, 18));
  const SurfaceMesh coarse = test::meshOf(test::cube());
  testIntake();
  testEmbedding(fine);
  testFeatures();
  testDensity(fine);
  for (const int d : { 3, 6 })
  {
    RemeshOptions options;
    options.seed = 5;
    options.lloydIterations = 2;
    options.quasiNewton.iterations = 4;
    options.numberOfSites = 400; // more blocks than are run at once
    checkCase(fine, test::embedded(fine, d), options);
    options.sampling = SamplingMethod::Random;
    options.numberOfSites = 150;
    checkCase(coarse, test::embedded(coarse, d), options);
  }
  return test::result();
}
