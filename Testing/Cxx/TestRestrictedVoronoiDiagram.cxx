// vtkRestrictedVoronoiDiagram: given sites are kept as they are, and each gets its cell.

#include "TestBytes.h"
#include "TestMeasures.h"

#include "Mesh/ClosestPoint.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkRestrictedVoronoiDiagram.h"

#include "vtkUnstructuredGrid.h"

using namespace remesh;
using namespace remesh::test;

namespace
{
vtkSmartPointer<vtkRestrictedVoronoiDiagram> run(
  vtkPolyData* surface, vtkDataObject* sites, bool gaussMap = false)
{
  auto filter = vtkSmartPointer<vtkRestrictedVoronoiDiagram>::New();
  filter->SetEmbeddingMode(
    gaussMap ? vtkRestrictedVoronoiDiagram::GAUSS_MAP : vtkRestrictedVoronoiDiagram::POSITION);
  filter->SetInputData(surface);
  filter->SetSitesData(sites);
  filter->Update();
  return filter;
}

double valueOf(vtkRestrictedVoronoiDiagram* filter, const char* name, vtkIdType site)
{
  return arrayOf(filter->GetSitesOutput()->GetPointData(), name)->GetComponent(site, 0);
}

/** Facts that hold for any sites. */
void checkCommon(vtkRestrictedVoronoiDiagram* filter, vtkPolyData* surface, vtkPointSet* given)
{
  vtkPolyData* sites = filter->GetSitesOutput();
  const double area = areaOf(surface);
  CHECK_EQUAL(sites->GetNumberOfPoints(), given->GetNumberOfPoints());
  CHECK_NEAR(sumOf(arrayOf(sites->GetPointData(), "CellArea")), area, 1e-12 * area);
  CHECK_NEAR(areaOf(filter->GetVoronoiCellsOutput()), area, 1e-12 * area);
  CHECK_NEAR(sumOf(arrayOf(filter->GetOutput()->GetPointData(), "CellArea")), area, 1e-12 * area);
  std::set<double> nonEmpty;
  for (vtkIdType i = 0; i < sites->GetNumberOfPoints(); ++i)
  {
    CHECK_EQUAL(valueOf(filter, "SiteId", i), static_cast<double>(i));
    CHECK_EQUAL(valueOf(filter, "MergedSiteId", i), static_cast<double>(i));
    if (valueOf(filter, "CellArea", i) > 0.0)
    {
      nonEmpty.insert(static_cast<double>(i));
    }
  }
  for (vtkPolyData* output : { filter->GetOutput(), filter->GetVoronoiCellsOutput() })
  {
    vtkFieldData* data = output == filter->GetOutput()
      ? static_cast<vtkFieldData*>(output->GetPointData())
      : static_cast<vtkFieldData*>(output->GetCellData());
    const auto ids = arrayOf(data, "SiteId");
    std::set<double> seen;
    for (vtkIdType k = 0; k < ids->GetNumberOfTuples(); ++k)
    {
      seen.insert(ids->GetComponent(k, 0));
    }
    CHECK(seen == nonEmpty);
  }
  vtkTable* table = filter->GetConvergenceOutput();
  CHECK_EQUAL(table->GetNumberOfRows(), 1);
  CHECK_EQUAL(arrayOf(table->GetRowData(), "StepLength")->GetComponent(0, 0), 0.0);
  CHECK_EQUAL(arrayOf(table->GetRowData(), "Iteration")->GetComponent(0, 0), 0.0);
  CHECK_EQUAL(filter->GetNumberOfIterations(), 0);
  CHECK_EQUAL(filter->GetNumberOfEvaluations(), 1);
}

/** Sites on a square grid: where cells tie, what the perturbation leaves is no polygon. */
void testTies(Index resolution, const Eigen::Matrix3d& rotation)
{
  TriangleSoup soup = gridPatch(resolution, resolution);
  Eigen::AlignedBox3d box;
  for (const Point3& point : soup.points)
  {
    box.extend(point);
  }
  std::vector<Point3> places;
  for (int k = 0; k < 64; ++k)
  {
    const Point3 share((k % 8 + 0.5) / 8.0, (k / 8 + 0.5) / 8.0, 0.0);
    places.push_back(rotation * (box.min() + share.cwiseProduct(box.sizes())));
  }
  for (Point3& point : soup.points)
  {
    point = rotation * point;
  }
  const auto surface = polyDataOf(soup);
  const auto sites = pointsOnly(places);
  const auto filter = run(surface, sites);
  checkCommon(filter, surface, sites);
  vtkPolyData* cells = filter->GetVoronoiCellsOutput();
  CHECK(cells->GetNumberOfPolys() > 0);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellPoints(cell, ids);
    std::vector<Point3> corners(static_cast<std::size_t>(ids->GetNumberOfIds()));
    Point3 area = Point3::Zero();
    double length = 0.0;
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      cells->GetPoint(ids->GetId(static_cast<vtkIdType>(k)), corners[k].data());
      length = std::max(length, (corners[k] - corners[0]).norm());
      area += 0.5 * (corners[k == 0 ? 0 : k - 1] - corners[0]).cross(corners[k] - corners[0]);
    }
    CHECK(area.norm() > 1e-14 * length * box.sizes().maxCoeff()); // neither point nor line
  }
}

/** A site in the middle of each face of a cube, in a shuffled order: each face is a cell. */
void testCubeFaces()
{
  const auto surface = polyDataOf(cube());
  const std::vector<Point3> places = { { 0.5, 0.5, 1 }, { 0, 0.5, 0.5 }, { 0.5, 1, 0.5 },
    { 0.5, 0.5, 0 }, { 1, 0.5, 0.5 }, { 0.5, 0, 0.5 } };
  const auto sites = pointsOnly(places);
  const auto filter = run(surface, sites);
  filter->SetVertexPlacement(vtkRestrictedVoronoiDiagram::CENTROID);
  filter->Update();
  checkCommon(filter, surface, sites);
  CHECK_EQUAL(filter->GetDimension(), 3);
  for (vtkIdType i = 0; i < 6; ++i)
  {
    CHECK_NEAR(valueOf(filter, "CellArea", i), 1.0, 1e-15);
    CHECK_NEAR(valueOf(filter, "CellMass", i), 1.0, 1e-15);
    CHECK_NEAR(valueOf(filter, "CellEnergy", i), 1.0 / 6.0, 1e-15);
    CHECK_EQUAL(valueOf(filter, "NumberOfNeighbors", i), 4.0);
    CHECK_NEAR((pointOf(filter->GetSitesOutput(), i) - places[i]).norm(), 0.0, 1e-15);
  }
  // The gradient is zero, and the dual an octahedron.
  const auto gradient = arrayOf(filter->GetConvergenceOutput()->GetRowData(), "GradientNorm");
  CHECK_NEAR(gradient->GetComponent(0, 0), 0.0, 1e-15);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), 8);
  CHECK(isClosedManifold(filter->GetOutput()));
  CHECK_NEAR(volumeOf(filter->GetOutput()), 1.0 / 6.0, 1e-15);
}

/** With `Embedding` a site is where the array says; without, on the surface. */
void testEmbeddingOrProjection()
{
  const auto surface = polyDataOf(cube());
  // Two points over the top and bottom, one far beyond a corner.
  const auto sites = pointsOnly({ { 0.5, 0.5, 9 }, { 0.5, 0.5, -8 }, { 30, 30, 30 } });
  const auto projected = run(surface, sites);
  checkCommon(projected, surface, sites);
  for (vtkIdType i = 0; i < 3; ++i)
  {
    const Point3 expected[3] = { { 0.5, 0.5, 1 }, { 0.5, 0.5, 0 }, { 1, 1, 1 } };
    Point3 x;
    arrayOf(projected->GetSitesOutput()->GetPointData(), "Embedding")->GetTuple(i, x.data());
    CHECK_NEAR((x - expected[i]).norm(), 0.0, 1e-15);
    CHECK(valueOf(projected, "CellArea", i) > 0.0);
  }

  // The same points as places in R^3: the bisector of the first two is z = 1/2, the third is empty.
  addPointArray<vtkDoubleArray>(sites, "Embedding", 3, [](const Point3& p, int c) { return p[c]; });
  const auto placed = run(surface, sites);
  checkCommon(placed, surface, sites);
  CHECK_NEAR(valueOf(placed, "CellArea", 0), 3.0, 1e-14);
  CHECK_NEAR(valueOf(placed, "CellArea", 1), 3.0, 1e-14);
  CHECK_EQUAL(valueOf(placed, "CellArea", 2), 0.0);
  CHECK_EQUAL(valueOf(placed, "CellMass", 2), 0.0);
  CHECK_EQUAL(valueOf(placed, "CellEnergy", 2), 0.0);
  CHECK_EQUAL(valueOf(placed, "NumberOfNeighbors", 2), 0.0);
  CHECK_EQUAL(valueOf(placed, "NumberOfNeighbors", 0), 1.0);
  CHECK_EQUAL(pointOf(placed->GetSitesOutput(), 2), Point3(30, 30, 30));
  Point3 centroid;
  arrayOf(placed->GetSitesOutput()->GetPointData(), "Centroid")->GetTuple(2, centroid.data());
  CHECK_NEAR((centroid - Point3(30, 30, 30)).norm(), 0.0, 1e-13);
  CHECK_EQUAL(placed->GetOutput()->GetNumberOfPoints(), 2);
  // int |x - (1/2, 1/2, 9)|^2 over the upper half of the cube: top, and four sides.
  const double top = 64.0 + 1.0 / 6.0;
  const double side = 0.5 * (0.25 + 1.0 / 12.0) + (std::pow(8.5, 3) - 512.0) / 3.0;
  CHECK_NEAR(valueOf(placed, "CellEnergy", 0), top + 4.0 * side, 1e-11);

  // An array of another size is not these sites' embedding: projected again.
  const auto inSpace = run(surface, sites, true);
  CHECK_EQUAL(inSpace->GetDimension(), 6);
  CHECK(valueOf(inSpace, "CellArea", 2) > 0.0);
}

/** Sites are put where no triangle is closer, by trying all. */
void testClosestPlaces()
{
  const TriangleSoup surface = ellipsoid(3);
  std::vector<Point3> places;
  for (const Point3& p : icosphere(3).points)
  {
    places.push_back(ellipsoidCenter() + 2.0 * std::abs(p[0] + 0.5 * p[1]) * p);
  }
  vtkNew<vtkRestrictedVoronoiDiagram> filter;
  filter->SetAnisotropy(0.0);
  filter->SetInputData(polyDataOf(surface));
  filter->SetSitesData(pointsOnly(places));
  filter->Update();
  const auto embedding = arrayOf(filter->GetSitesOutput()->GetPointData(), "Embedding");
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    double squared = HUGE_VAL;
    for (const auto& [a, b, c] : surface.triangles)
    {
      squared = std::min(squared,
        closestOnTriangle(places[i], surface.points[a], surface.points[b], surface.points[c])
          .squared);
    }
    const Point3 site = tupleOf(embedding, static_cast<vtkIdType>(i));
    CHECK_NEAR((site - places[i]).norm(), std::sqrt(squared), 1e-14);
  }
}

/** Equal sites: the lower id wins. One site: all is its cell. */
void testFewSites()
{
  const auto surface = polyDataOf(cube());
  const auto twice = pointsOnly({ { 0, 0, 0 }, { 1, 1, 1 }, { 0, 0, 0 }, { 1, 1, 1 } });
  const auto filter = run(surface, twice);
  checkCommon(filter, surface, twice);
  CHECK_NEAR(valueOf(filter, "CellArea", 0), 3.0, 1e-14);
  CHECK_NEAR(valueOf(filter, "CellArea", 1), 3.0, 1e-14);
  CHECK_EQUAL(valueOf(filter, "CellArea", 2), 0.0);
  CHECK_EQUAL(valueOf(filter, "CellArea", 3), 0.0);

  const auto one = pointsOnly({ { 0.2, 0.3, 0 } });
  const auto whole = run(surface, one);
  checkCommon(whole, surface, one);
  CHECK_EQUAL(whole->GetOutput()->GetNumberOfPoints(), 1);
  CHECK_EQUAL(whole->GetOutput()->GetNumberOfCells(), 0);
  CHECK_EQUAL(whole->GetEdgesOutput()->GetNumberOfCells(), 0);
  CHECK_EQUAL(valueOf(whole, "NumberOfNeighbors", 0), 0.0);
  CHECK_EQUAL(whole->GetVoronoiCellsOutput()->GetNumberOfCells(), 12);
}

/** Any vtkPointSet gives sites, and its cells do not matter. */
void testKindsOfSites()
{
  const auto surface = polyDataOf(icosphere(2));
  const auto points = polyDataOf(icosphere(0));
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points->GetPoints());
  const auto fromMesh = run(surface, points, true);
  const auto fromGrid = run(surface, grid, true);
  checkCommon(fromMesh, surface, points);
  checkSame(contentsOf(fromGrid), contentsOf(fromMesh), "sites of another type");
  // The dual of the icosahedron's corners on a finer sphere is the icosahedron.
  CHECK_EQUAL(fromMesh->GetOutput()->GetNumberOfPolys(), 20);
  CHECK(isClosedManifold(fromMesh->GetOutput()));
  for (vtkIdType i = 0; i < 12; ++i)
  {
    CHECK_EQUAL(valueOf(fromMesh, "NumberOfNeighbors", i), 5.0);
  }
}

/** The remesher's sites give the remesher's diagram, to the byte. */
void testRoundTrip(const TriangleSoup& soup, double anisotropy, const char* where)
{
  const auto surface = polyDataOf(soup);
  vtkNew<vtkAnisotropicRemesher> remesher;
  remesher->SetInputData(surface);
  remesher->SetAnisotropy(anisotropy);
  remesher->SetNumberOfPoints(250);
  remesher->SetNumberOfLloydIterations(5);
  vtkNew<vtkRestrictedVoronoiDiagram> diagram;
  diagram->SetInputData(surface);
  diagram->SetAnisotropy(anisotropy);
  diagram->SetSitesConnection(remesher->GetOutputPort(vtkAnisotropicRemesher::SITES));
  diagram->Update();
  checkCommon(diagram, surface, remesher->GetSitesOutput());
  const std::vector<Content> expected = contentsOf(remesher);
  const std::vector<Content> contents = contentsOf(diagram);
  for (const int port : { vtkAnisotropicRemesher::SURFACE, vtkAnisotropicRemesher::VORONOI_CELLS,
         vtkAnisotropicRemesher::SITES, vtkAnisotropicRemesher::EDGES })
  {
    checkSame(
      contents[port], expected[port], where + std::string(", port ") + std::to_string(port));
  }
}
}

int TestRestrictedVoronoiDiagram(int, char*[])
{
  testCubeFaces();
  testTies(16, Eigen::Matrix3d::Identity());
  const Point3 axis = Point3(1.0, 2.0, 3.0).normalized();
  testTies(240, Eigen::AngleAxisd(0.7, axis).toRotationMatrix());
  testEmbeddingOrProjection();
  testClosestPlaces();
  testFewSites();
  testKindsOfSites();
  testRoundTrip(icosphere(3), 0.04, "sphere at the origin");
  testRoundTrip(ellipsoid(3), 0.04, "ellipsoid elsewhere");
  testRoundTrip(ellipsoid(3), 0.0, "ellipsoid in R^3");
  testRoundTrip(torus(1.0, 0.3, 60, 30), 0.1, "torus");
  TriangleSoup far = torus(1.0, 0.3, 60, 30);
  for (Point3& point : far.points)
  {
    point += Point3(0.26, 1e-3, 100.0);
  }
  testRoundTrip(far, 0.1, "torus far away");
  return result();
}
