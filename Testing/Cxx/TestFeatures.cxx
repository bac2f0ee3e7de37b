// What the remesher keeps of creases, corners, borders, non-manifold edges and labels.

#include "TestBytes.h"
#include "TestMeasures.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkIntArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

using namespace remesh;
using namespace remesh::test;

namespace
{
using Filter = vtkSmartPointer<vtkAnisotropicRemesher>;

constexpr int creaseEdges = 1; // `EdgeType`

Filter remesh(
  vtkPolyData* input, vtkIdType points, double anisotropy = 0.04, const char* labels = nullptr)
{
  auto filter = Filter::New();
  filter->SetInputData(input);
  filter->SetNumberOfPoints(points);
  filter->SetAnisotropy(anisotropy);
  filter->SetFeatureLabelArray(labels);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty());
  CHECK(messages.warnings().empty());
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), points);
  return filter;
}

/** Length of the mesh's edges with both ends where `onFeature` holds, and of some valence. */
double lengthAlong(vtkPolyData* mesh, const std::function<bool(const Point3&)>& onFeature,
  const std::function<bool(int)>& wanted)
{
  double length = 0.0;
  for (const auto& [edge, valence] : valencesOf(mesh))
  {
    const Point3 a = pointOf(mesh, edge.first);
    const Point3 b = pointOf(mesh, edge.second);
    if (wanted(valence) && onFeature(a) && onFeature(b) && onFeature(0.5 * (a + b)))
    {
      length += (b - a).norm();
    }
  }
  return length;
}

bool near(double a, double b)
{
  return std::abs(a - b) < 1e-9;
}

/** On two of the planes that bound the cube, or three in its corners. */
bool onCubeEdge(const Point3& p)
{
  int planes = 0;
  for (int k = 0; k < 3; ++k)
  {
    planes += near(p[k], 0.0) || near(p[k], 1.0);
  }
  return planes >= 2;
}

/** A box, from the twelve triangles of a cube, for many and few points. */
void testBox()
{
  const auto input = polyDataOf(cube());
  for (const double anisotropy : { 0.0, 0.04, 0.3 })
  {
    for (const vtkIdType points : { 20, 150, 1000 })
    {
      const Filter filter = remesh(input, points, anisotropy);
      vtkPolyData* mesh = filter->GetOutput();
      CHECK(isClosedManifold(mesh));
      CHECK_EQUAL(eulerCharacteristicOf(mesh), 2);
      CHECK_NEAR(std::abs(volumeOf(mesh)), 1.0, 1e-12);
      CHECK_NEAR(areaOf(mesh), 6.0, 1e-12);
      const double kept = lengthAlong(mesh, onCubeEdge, [](int valence) { return valence == 2; });
      CHECK_NEAR(kept, 12.0, 1e-12);
      CHECK_NEAR(lengthsOfEdges(filter->GetEdgesOutput())[creaseEdges], 12.0, 1e-12);
    }
  }
}

/** How patches are kept apart inside is not seen outside: all places are on the cube. */
void testEmbeddings()
{
  const vtkSmartPointer<vtkPolyData> input = polyDataOf(cube());
  double bounds[6];
  input->GetBounds(bounds);
  const double scale = 0.1 * input->GetLength();
  const Filter filter = remesh(input, 200, 0.1);
  const std::pair<vtkPolyData*, const char*> arrays[] = { { filter->GetOutput(), "Embedding" },
    { filter->GetVoronoiCellsOutput(), "Embedding" }, { filter->GetSitesOutput(), "Embedding" },
    { filter->GetSitesOutput(), "Centroid" } };
  for (const auto& [output, name] : arrays)
  {
    const auto array = arrayOf(output->GetPointData(), name);
    CHECK(array->GetNumberOfTuples() > 0);
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      double normal = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const double x = array->GetComponent(i, k);
        CHECK(x >= bounds[2 * k] - 1e-6 && x <= bounds[2 * k + 1] + 1e-6);
        normal += std::pow(array->GetComponent(i, 3 + k), 2);
      }
      CHECK_NEAR(std::sqrt(normal), scale, 1e-6); // each side has one
    }
  }
}

/** Every copy of a site has the vertex of the first; sums over copies are those of the mesh. */
void testCopies()
{
  const Filter filter = remesh(polyDataOf(cube()), 100);
  vtkPointData* sites = filter->GetSitesOutput()->GetPointData();
  const auto merged = arrayOf(sites, "MergedSiteId");
  const auto patches = arrayOf(sites, "PatchId");
  std::map<double, std::vector<double>> copies; // patches of each vertex
  for (vtkIdType i = 0; i < merged->GetNumberOfTuples(); ++i)
  {
    CHECK(merged->GetComponent(i, 0) <= static_cast<double>(i));
    copies[merged->GetComponent(i, 0)].push_back(patches->GetComponent(i, 0));
  }
  CHECK_EQUAL(copies.size(), std::size_t(100));
  int corners = 0;
  for (auto& [vertex, own] : copies)
  {
    CHECK(own.size() <= 3);
    corners += own.size() == 3;
    std::sort(own.begin(), own.end());
    CHECK(std::unique(own.begin(), own.end()) == own.end());
  }
  CHECK_EQUAL(corners, 8);
  for (const char* name : { "CellArea", "CellMass", "CellEnergy" })
  {
    const double total = sumOf(arrayOf(sites, name));
    CHECK_NEAR(sumOf(arrayOf(filter->GetOutput()->GetPointData(), name)), total, 1e-12 * total);
  }
  const auto ids = arrayOf(filter->GetOutput()->GetPointData(), "SiteId");
  for (vtkIdType k = 0; k < ids->GetNumberOfTuples(); ++k)
  {
    CHECK(copies.count(ids->GetComponent(k, 0)) == 1);
  }
}

/** Triangles whose three sites do not meet in a vertex of the Voronoi cells. */
int trianglesApartFromCells(vtkAnisotropicRemesher* filter)
{
  vtkPolyData* cells = filter->GetVoronoiCellsOutput();
  const auto merged = arrayOf(cells->GetCellData(), "MergedSiteId");
  std::vector<std::set<double>> meeting(static_cast<std::size_t>(cells->GetNumberOfPoints()));
  forEachPolygon(cells,
    [&](vtkIdType cell, const std::vector<vtkIdType>& ids)
    {
      for (const vtkIdType id : ids)
      {
        meeting[id].insert(merged->GetComponent(cell, 0));
      }
    });
  std::set<std::set<double>> triples;
  for (const std::set<double>& sites : meeting)
  {
    if (sites.size() == 3)
    {
      triples.insert(sites);
    }
  }
  const auto ids = arrayOf(filter->GetOutput()->GetPointData(), "SiteId");
  int apart = 0;
  forEachPolygon(filter->GetOutput(),
    [&](vtkIdType, const std::vector<vtkIdType>& corners)
    {
      std::set<double> sites;
      for (const vtkIdType corner : corners)
      {
        sites.insert(ids->GetComponent(corner, 0));
      }
      apart += triples.count(sites) == 0 ? 1 : 0;
    });
  return apart;
}

/**
 * Creases closer to each other than the points are spaced, in a thin plate whose faces differ in
 * size and in a spike: the mesh is the dual of the cells there, too.
 */
void testNearCreases()
{
  for (const double anisotropy : { 0.0, 0.04 })
  {
    TriangleSoup plate = cube();
    for (Point3& p : plate.points)
    {
      p = p[2] > 0.5 ? Point3(0.91 * p[0] + 0.01, 0.83 * p[1] + 0.02, 0.02) : p;
    }
    CHECK_EQUAL(trianglesApartFromCells(remesh(polyDataOf(plate), 400, anisotropy)), 0);
    TriangleSoup spike = tetrahedron();
    for (Point3& p : spike.points)
    {
      p = Point3(p[0], 0.07 * p[1] + 0.01 * p[0], 0.1 * p[2] + 0.04 * p[0]);
    }
    CHECK_EQUAL(trianglesApartFromCells(remesh(polyDataOf(spike), 300, anisotropy)), 0);
  }
}

/** Three sheets on one line: they stay joined, and the line and all borders stay. */
void testThreeSheets()
{
  for (const double anisotropy : { 0.0, 0.04 })
  {
    const auto input = polyDataOf(threeSheets());
    const Filter filter = remesh(input, 120, anisotropy);
    vtkPolyData* mesh = filter->GetOutput();
    const auto everywhere = [](const Point3&) { return true; };
    CHECK_NEAR(lengthAlong(mesh, everywhere, [](int v) { return v == 3; }), 1.0, 1e-12);
    CHECK_NEAR(lengthAlong(mesh, everywhere, [](int v) { return v == 1; }), 9.0, 1e-12);
    CHECK_NEAR(lengthAlong(mesh, everywhere, [](int v) { return v > 3; }), 0.0, 1e-300);
    CHECK_NEAR(areaOf(mesh), areaOf(input), 1e-12);
    const auto valences = valencesOf(mesh);
    const auto nonManifold = std::count_if(
      valences.begin(), valences.end(), [](const auto& edge) { return edge.second > 2; });
    CHECK(nonManifold > 1);
    const auto told = arrayOf(mesh->GetFieldData(), "NumberOfNonManifoldEdges");
    CHECK_EQUAL(told->GetComponent(0, 0), static_cast<double>(nonManifold));
  }
}

/** A tube of square section, open at both ends: four creases and two borders. */
TriangleSoup squareTube(int segments)
{
  TriangleSoup soup;
  const Point3 section[4] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  for (int i = 0; i <= segments; ++i)
  {
    for (const Point3& p : section)
    {
      soup.points.push_back(p + Point3(0, 0, 3.0 * i / segments));
    }
  }
  for (int i = 0; i < segments; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Offset a = 4 * i + k;
      const Offset b = 4 * i + (k + 1) % 4;
      soup.triangles.push_back({ a, b, b + 4 });
      soup.triangles.push_back({ a, b + 4, a + 4 });
    }
  }
  return soup;
}

void testOpenTube()
{
  const Filter filter = remesh(polyDataOf(squareTube(7)), 200, 0.0);
  vtkPolyData* mesh = filter->GetOutput();
  CHECK_EQUAL(eulerCharacteristicOf(mesh), 0);
  CHECK_NEAR(areaOf(mesh), 12.0, 1e-11);
  CHECK_NEAR(lengthAlong(
               mesh, [](const Point3&) { return true; }, [](int v) { return v == 1; }),
    8.0, 1e-12);
  const auto onCrease = [](const Point3& p)
  { return (near(p[0], 0) || near(p[0], 1)) && (near(p[1], 0) || near(p[1], 1)); };
  CHECK_NEAR(lengthAlong(mesh, onCrease, [](int v) { return v == 2; }), 12.0, 1e-11);
}

/** A round border without corners gets its points, and the disk stays one. */
void testDisk()
{
  TriangleSoup soup;
  const int n = 64;
  soup.points.push_back(Point3::Zero());
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / n;
    soup.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    soup.triangles.push_back({ 0, 1 + i, 1 + (i + 1) % n });
  }
  const auto input = polyDataOf(soup);
  const Filter filter = remesh(input, 300);
  CHECK_EQUAL(eulerCharacteristicOf(filter->GetOutput()), 1);
  CHECK_NEAR(areaOf(filter->GetOutput()), areaOf(input), 1e-4);
}

/** Two values of a cell array on a plane: the border between them is kept. */
void testLabels()
{
  const auto input = polyDataOf(gridPatch(8, 8));
  vtkNew<vtkIntArray> labels;
  labels->SetName("Region");
  double border = 0.0;
  forEachPolygon(input,
    [&](vtkIdType, const std::vector<vtkIdType>& ids)
    {
      const Point3 center =
        (pointOf(input, ids[0]) + pointOf(input, ids[1]) + pointOf(input, ids[2])) / 3.0;
      labels->InsertNextValue(center[0] < 0.5 ? 3 : 7);
    });
  input->GetCellData()->AddArray(labels);
  border = 1.0;
  const auto onBorder = [](const Point3& p) { return near(p[0], 0.5); };
  const auto inside = [](int v) { return v == 2; };
  const Filter with = remesh(input, 150, 0.0, "Region");
  CHECK_NEAR(lengthAlong(with->GetOutput(), onBorder, inside), border, 1e-12);
  const Filter without = remesh(input, 150, 0.0);
  CHECK(lengthAlong(without->GetOutput(), onBorder, inside) < 0.5 * border);
  CHECK_NEAR(areaOf(with->GetOutput()), 1.0, 1e-12);

  auto missing = Filter::New();
  missing->SetInputData(input);
  missing->SetFeatureLabelArray("Nowhere");
  Messages messages(missing);
  missing->Update();
  CHECK_EQUAL(messages.errors().size(), std::size_t(1));
}

/** Noise of a scan is no crease: nothing is fixed on a sphere with rough normals. */
void testNoise()
{
  TriangleSoup soup = icosphere(5);
  for (std::size_t i = 0; i < soup.points.size(); ++i)
  {
    const double random = std::sin(12.9898 * static_cast<double>(i)) * 43758.5453;
    soup.points[i] *= 1.0 + 0.012 * (random - std::floor(random));
  }
  const Filter filter = remesh(polyDataOf(soup), 500);
  CHECK(isClosedManifold(filter->GetOutput()));
  CHECK_EQUAL(lengthsOfEdges(filter->GetEdgesOutput())[creaseEdges], 0.0);
}

/** Off, the cube's edges are cut across: with its points at the centroids, the mesh is smaller. */
void testOff()
{
  auto filter = Filter::New();
  const auto input = polyDataOf(cube());
  filter->SetInputData(input);
  filter->SetNumberOfPoints(150);
  filter->SetVertexPlacement(vtkAnisotropicRemesher::CENTROID);
  filter->PreserveFeaturesOff();
  filter->Update();
  CHECK_EQUAL(filter->GetSitesOutput()->GetNumberOfPoints(), 150);
  CHECK(areaOf(filter->GetOutput()) < 0.999 * areaOf(input));
}

/** So few points that corners and curves need more: a warning, and a sane mesh. */
void testTooFew()
{
  auto filter = Filter::New();
  filter->SetInputData(polyDataOf(squareTube(2)));
  filter->SetNumberOfPoints(9);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty());
  CHECK_EQUAL(messages.warnings().size(), std::size_t(1));
  CHECK(
    messages.warnings()[0].find("Corners and curves of the surface need 8") != std::string::npos);
  CHECK_EQUAL(eulerCharacteristicOf(filter->GetOutput()), 0);
}

}

int TestFeatures(int, char*[])
{
  testBox();
  testCopies();
  testEmbeddings();
  testNearCreases();
  testThreeSheets();
  testOpenTube();
  testDisk();
  testLabels();
  testNoise();
  testOff();
  testTooFew();
  return result();
}
