// What the remesher makes of every kind of surface that a vtkPolyData may hold.

#include "TestBytes.h"
#include "TestMeasures.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkGaussMapEmbedding.h"
#include "vtkNew.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"

#include <functional>

using namespace remesh;
using namespace remesh::test;

namespace
{
using Cell = std::vector<vtkIdType>;
using Filter = vtkSmartPointer<vtkAnisotropicRemesher>;

void addCells(vtkCellArray* array, const std::vector<Cell>& cells)
{
  for (const Cell& cell : cells)
  {
    array->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
}

vtkSmartPointer<vtkPolyData> makePolyData(const std::vector<Point3>& points,
  const std::vector<Cell>& polygons, const std::vector<Cell>& strips = {})
{
  auto data = pointsOnly(points);
  vtkNew<vtkCellArray> polys;
  addCells(polys, polygons);
  data->SetPolys(polys);
  vtkNew<vtkCellArray> stripArray;
  addCells(stripArray, strips);
  data->SetStrips(stripArray);
  return data;
}

/** Runs the remesher and checks what holds for any surface of this area. */
Filter remesh(vtkPolyData* input, vtkIdType sites, double area, std::size_t warnings = 0)
{
  auto filter = Filter::New();
  filter->SetInputData(input);
  filter->SetNumberOfPoints(sites);
  filter->SetNumberOfLloydIterations(3);
  filter->SetNumberOfNewtonIterations(5);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty());
  CHECK_EQUAL(messages.warnings().size(), warnings);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), sites);
  CHECK(filter->GetOutput()->GetNumberOfPolys() > 0);
  CHECK_NEAR(areaOf(filter->GetVoronoiCellsOutput()), area, 1e-12 * area);
  for (const int port : { vtkAnisotropicRemesher::SURFACE, vtkAnisotropicRemesher::SITES })
  {
    vtkPolyData* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
    CHECK_NEAR(sumOf(arrayOf(output->GetPointData(), "CellArea")), area, 1e-12 * area);
  }
  const auto fact = arrayOf(filter->GetOutput()->GetFieldData(), "EulerCharacteristic");
  CHECK_EQUAL(
    fact->GetComponent(0, 0), static_cast<double>(eulerCharacteristicOf(filter->GetOutput())));
  return filter;
}

/** Area of the pieces that came from each of the input's cells. */
std::map<vtkIdType, double> areasOfInputCells(vtkAnisotropicRemesher* filter)
{
  vtkPolyData* cells = filter->GetVoronoiCellsOutput();
  const auto ids = arrayOf(cells->GetCellData(), "InputCellId");
  std::map<vtkIdType, double> areas;
  forEachPolygon(cells,
    [&](vtkIdType cell, const Cell& points)
    { areas[static_cast<vtkIdType>(ids->GetComponent(cell, 0))] += polygonArea(cells, points); });
  return areas;
}

void checkInputCells(vtkAnisotropicRemesher* filter, const std::map<vtkIdType, double>& expected)
{
  const std::map<vtkIdType, double> areas = areasOfInputCells(filter);
  CHECK_EQUAL(areas.size(), expected.size());
  for (const auto& [cell, area] : expected)
  {
    CHECK(areas.count(cell) == 1);
    CHECK_NEAR(areas.count(cell) ? areas.at(cell) : 0.0, area, 1e-13);
  }
}

const std::vector<Cell> cubeQuads = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
  { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };

void testQuadrilateralsAndStrips()
{
  const std::vector<Point3> points = cube().points;
  const Filter quads = remesh(makePolyData(points, cubeQuads), 150, 6.0);
  checkInputCells(quads, { { 0, 1 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { 4, 1 }, { 5, 1 } });
  CHECK(isClosedManifold(quads->GetOutput()));
  CHECK_EQUAL(eulerCharacteristicOf(quads->GetOutput()), 2);
  CHECK(volumeOf(quads->GetOutput()) > 0.9);

  const std::vector<Cell> strips = { { 0, 1, 4, 5, 6, 7, 2, 3, 0, 1 }, { 4, 6, 0, 2 },
    { 1, 3, 5, 7 } };
  const Filter fromStrips = remesh(makePolyData(points, {}, strips), 150, 6.0);
  checkInputCells(fromStrips, { { 0, 4 }, { 1, 1 }, { 2, 1 } });
  CHECK(volumeOf(fromStrips->GetOutput()) > 0.9);

  // Quadrilaterals, triangles and a strip, among vertices, lines and points of no use.
  std::vector<Point3> more = points;
  more.emplace_back(50, 60, 70);
  const auto mixed =
    makePolyData(more, { cubeQuads[0], { 4, 5, 7 }, { 4, 7, 6 }, cubeQuads[2], cubeQuads[3] },
      { { 4, 6, 0, 2 }, { 1, 3, 5, 7 } });
  vtkNew<vtkCellArray> verts;
  addCells(verts, { { 8 }, { 0, 1 } });
  mixed->SetVerts(verts);
  vtkNew<vtkCellArray> lines;
  addCells(lines, { { 0, 8, 3 } });
  mixed->SetLines(lines);
  const Filter fromMixed = remesh(mixed, 150, 6.0);
  checkInputCells(
    fromMixed, { { 3, 1 }, { 4, 0.5 }, { 5, 0.5 }, { 6, 1 }, { 7, 1 }, { 8, 1 }, { 9, 1 } });
  CHECK(volumeOf(fromMixed->GetOutput()) > 0.9);
}

/** A letter L and an arrow: nothing is added outside. */
void testConcavePolygons()
{
  const auto letter =
    makePolyData({ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 1, 0 }, { 1, 1, 0 }, { 1, 4, 0 }, { 0, 4, 0 } },
      { { 0, 1, 2, 3, 4, 5 } });
  const Filter filter = remesh(letter, 80, 6.0);
  vtkPolyData* cells = filter->GetVoronoiCellsOutput();
  for (vtkIdType i = 0; i < cells->GetNumberOfPoints(); ++i)
  {
    const Point3 p = pointOf(cells, i);
    CHECK(p[0] <= 1.0 + 1e-14 || p[1] <= 1.0 + 1e-14);
  }
  remesh(makePolyData({ { 0, 0, 0 }, { 4, -1, 0 }, { 1, 0, 0 }, { 4, 1, 0 } }, { { 0, 1, 2, 3 } }),
    40, 1.0);
}

void testMoebiusStrip()
{
  const auto input = polyDataOf(moebiusStrip(100));
  const Filter filter = remesh(input, 120, areaOf(input), 1);
  CHECK_EQUAL(eulerCharacteristicOf(filter->GetOutput()), 0);
  std::map<int, double> lengths = lengthsOfEdges(filter->GetEdgesOutput());
  CHECK_EQUAL(lengths.count(3), std::size_t(0));
  double border = 0.0; // once round twice
  for (vtkIdType i = 0; i < 100; ++i)
  {
    for (const vtkIdType side : { 0, 1 })
    {
      const vtkIdType next = i < 99 ? 2 * i + 2 + side : 1 - side;
      border += (pointOf(input, next) - pointOf(input, 2 * i + side)).norm();
    }
  }
  CHECK_NEAR(lengths[2], border, 1e-12);
}

void testThreeSheets()
{
  const Filter filter = remesh(polyDataOf(threeSheets()), 90, 3.0);
  std::map<int, double> lengths = lengthsOfEdges(filter->GetEdgesOutput());
  CHECK_NEAR(lengths[3], 1.0, 1e-14);
  CHECK_NEAR(lengths[2], 9.0, 1e-13);
}

void testComponents()
{
  TriangleSoup soup = icosphere(3);
  append(soup, icosphere(3), Point3(4, 0, 0));
  const auto input = polyDataOf(soup);
  const Filter filter = remesh(input, 200, areaOf(input));
  CHECK_EQUAL(filter->GetNumberOfInputComponents(), 2);
  CHECK(isClosedManifold(filter->GetOutput()));
  CHECK_EQUAL(eulerCharacteristicOf(filter->GetOutput()), 4);
}

/** Sum of the triangles' area vectors along z. */
double areaAlongZ(vtkPolyData* mesh)
{
  double sum = 0.0;
  forEachPolygon(mesh,
    [&](vtkIdType, const Cell& ids)
    {
      const Point3 a = pointOf(mesh, ids[1]) - pointOf(mesh, ids[0]);
      const Point3 b = pointOf(mesh, ids[2]) - pointOf(mesh, ids[0]);
      sum += 0.5 * a.cross(b)[2];
    });
  return sum;
}

/** An open patch has no inside: it stays as it is, wherever it lies. */
void testOrientation()
{
  for (const bool turned : { false, true })
  {
    for (const double z : { -1000.0, 0.0, 1000.0 })
    {
      TriangleSoup soup = gridPatch(8, 8, Point3(500.0, 0.0, z));
      for (std::size_t t = 0; turned && t < soup.triangles.size(); ++t)
      {
        flip(soup, t);
      }
      const Filter filter = remesh(polyDataOf(soup), 100, 1.0);
      const double along = areaAlongZ(filter->GetOutput());
      CHECK(turned ? along < -0.5 : along > 0.5);
      const auto normals = arrayOf(filter->GetOutput()->GetPointData(), "Normals");
      for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
      {
        CHECK_NEAR(normals->GetComponent(i, 2), turned ? -1.0 : 1.0, 1e-12);
      }
    }
  }
  // One triangle turned the wrong way follows the rest; a sphere inside out stays so.
  TriangleSoup odd = gridPatch(8, 8);
  flip(odd, 5);
  const auto upward =
    arrayOf(remesh(polyDataOf(odd), 100, 1.0)->GetOutput()->GetPointData(), "Normals");
  CHECK_NEAR(upward->GetRange(2)[0], 1.0, 1e-12);
  TriangleSoup inward = icosphere(3);
  for (std::size_t t = 0; t < inward.triangles.size(); ++t)
  {
    flip(inward, t);
  }
  const auto ball = polyDataOf(inward);
  CHECK(volumeOf(remesh(ball, 100, areaOf(ball))->GetOutput()) < -3.0);
}

/** As from CAD: each face of a cube has its own points, with its own normals. */
void testSplitPoints()
{
  std::vector<Point3> points;
  std::vector<Point3> normals;
  std::vector<Cell> faces;
  for (const Cell& quad : cubeQuads)
  {
    const std::vector<Point3> corners = cube().points;
    const Point3 normal =
      (corners[quad[1]] - corners[quad[0]]).cross(corners[quad[2]] - corners[quad[0]]);
    faces.emplace_back();
    for (const vtkIdType corner : quad)
    {
      faces.back().push_back(static_cast<vtkIdType>(points.size()));
      points.push_back(corners[corner]);
      normals.push_back(normal);
    }
  }
  const auto input = makePolyData(points, faces);
  vtkNew<vtkDoubleArray> array;
  array->SetNumberOfComponents(3);
  for (const Point3& normal : normals)
  {
    array->InsertNextTuple(normal.data());
  }
  array->SetName("CAD");
  input->GetPointData()->SetNormals(array);
  const Filter filter = remesh(input, 150, 6.0);
  CHECK_EQUAL(filter->GetNumberOfMergedPoints(), 16);
  CHECK_EQUAL(filter->GetNumberOfInputComponents(), 1);
  CHECK(isClosedManifold(filter->GetOutput()));
  CHECK(volumeOf(filter->GetOutput()) > 0.9);
  checkInputCells(filter, { { 0, 1 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { 4, 1 }, { 5, 1 } });
}

/** Given normals count by direction alone; estimated ones come close to them. */
void testSphereNormals()
{
  const auto plain = polyDataOf(icosphere(4));
  std::vector<vtkSmartPointer<vtkPolyData>> outputs;
  std::vector<Content> sites;
  for (const double length : { 0.0, 1.0, 4.0 })
  {
    const auto input = vtkSmartPointer<vtkPolyData>::New();
    input->ShallowCopy(plain);
    if (length > 0.0)
    {
      addPointArray<vtkDoubleArray>(
        input, "N", 3, [length](const Point3& p, int c) { return length * p[c]; });
      input->GetPointData()->SetActiveNormals("N");
    }
    const Filter filter = remesh(input, 300, areaOf(plain));
    outputs.emplace_back(filter->GetOutput());
    sites.push_back(contentOf(filter->GetSitesOutput()));
    vtkPolyData* output = filter->GetOutput();
    const auto normals = arrayOf(output->GetPointData(), "Normals");
    CHECK_EQUAL(output->GetPointData()->GetNormals(), normals.Get());
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      Point3 normal;
      normals->GetTuple(i, normal.data());
      CHECK_NEAR(normal.norm(), 1.0, 1e-14);
      CHECK((normal - pointOf(output, i).normalized()).norm() < (length > 0.0 ? 0.01 : 0.02));
    }
  }
  checkSame(sites[2], sites[1], "normals of length 4");
  CHECK(sites[1].at("point Embedding") != sites[0].at("point Embedding"));
}

/** Points that are nearly one, and triangles that are there twice or flat. */
void testRepairs()
{
  TriangleSoup soup = gridPatch(4, 4);
  append(soup, gridPatch(4, 4), Point3(1.0 + 1e-7, 0.0, 0.0));
  soup.triangles.push_back(soup.triangles[3]);
  soup.triangles.push_back({ 0, 1, 2 }); // on a line
  for (int k = 0; k < 2; ++k)
  {
    soup.inputCells.push_back(static_cast<Offset>(soup.inputCells.size()));
  }
  const auto input = polyDataOf(soup);
  const auto run = [&](double tolerance)
  {
    auto filter = Filter::New();
    filter->SetInputData(input);
    filter->SetNumberOfPoints(50);
    filter->SetMergeTolerance(tolerance);
    filter->Update();
    CHECK_EQUAL(filter->GetNumberOfDroppedTriangles(), 2);
    return filter;
  };
  const Filter apart = run(0.0);
  CHECK_EQUAL(apart->GetNumberOfInputComponents(), 2);
  CHECK_EQUAL(apart->GetNumberOfMergedPoints(), 0);
  const Filter merged = run(1e-4);
  CHECK_EQUAL(merged->GetNumberOfInputComponents(), 1);
  CHECK_EQUAL(merged->GetNumberOfMergedPoints(), 5);
  CHECK_NEAR(areaOf(merged->GetVoronoiCellsOutput()), 2.0, 1e-6);
}

/** VTK closes a torus with strips as wide as its rounding: they are no surface. */
void testClosedByRounding()
{
  vtkNew<vtkParametricTorus> shape;
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(shape);
  source->SetUResolution(120);
  source->SetVResolution(60);
  source->Update();
  const Filter filter = remesh(source->GetOutput(), 1000, areaOf(source->GetOutput()));
  CHECK_EQUAL(filter->GetNumberOfDroppedTriangles(), 358); // two of each of 119 + 60 squares
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), 2000);
  const auto preserved = arrayOf(filter->GetOutput()->GetFieldData(), "TopologyPreserved");
  CHECK_EQUAL(preserved->GetTuple1(0), 1.0);
  CHECK_EQUAL(
    arrayOf(filter->GetOutput()->GetFieldData(), "NumberOfFlippedTriangles")->GetTuple1(0), 0.0);
}

/** A slit as wide as rounding stays, as points of other coordinates are others, and is told. */
void testSlit()
{
  TriangleSoup soup = gridPatch(4, 4);
  append(soup, gridPatch(4, 4), Point3(1.0 + 4e-16, 0.0, 0.0));
  for (const double tolerance : { 0.0, 1e-12 })
  {
    auto filter = Filter::New();
    filter->SetInputData(polyDataOf(soup));
    filter->SetNumberOfPoints(50);
    filter->SetMergeTolerance(tolerance);
    Messages messages(filter);
    filter->Update();
    CHECK_EQUAL(filter->GetNumberOfInputComponents(), tolerance > 0.0 ? 1 : 2);
    CHECK_EQUAL(messages.warnings().size(), std::size_t(tolerance > 0.0 ? 0 : 1));
    CHECK(tolerance > 0.0 ||
      messages.warnings()[0].find("MergeTolerance of 1e-12") != std::string::npos);
  }
}

/** The warnings of a run. */
std::vector<std::string> warningsOf(vtkPolyData* input)
{
  const auto filter = Filter::New();
  filter->SetInputData(input);
  filter->SetNumberOfPoints(300);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty());
  return messages.warnings();
}

void testDoubledSheet()
{
  TriangleSoup soup = gridPatch(8, 8);
  CHECK(warningsOf(polyDataOf(soup)).empty());
  const std::size_t count = soup.triangles.size();
  for (std::size_t t = 0; t < count; ++t)
  {
    const auto [a, b, c] = soup.triangles[t];
    soup.triangles.push_back({ b, a, c });
    soup.inputCells.push_back(static_cast<Offset>(soup.inputCells.size()));
  }
  const auto warnings = warningsOf(polyDataOf(soup));
  CHECK(warnings.size() == 1 && warnings[0].find("there twice") != std::string::npos);
}

/** Single precision far from the origin, as of maps. */
void testRoundedCoordinates()
{
  TriangleSoup soup;
  append(soup, gridPatch(40, 40), Point3(45000.0, 540000.0, 30.0));
  vtkSmartPointer<vtkPolyData> input = polyDataOf(soup);
  CHECK(warningsOf(input).empty());
  vtkNew<vtkPoints> single;
  single->SetDataType(VTK_FLOAT);
  single->DeepCopy(input->GetPoints());
  CHECK_EQUAL(single->GetDataType(), VTK_FLOAT);
  input->SetPoints(single);
  const auto warnings = warningsOf(input);
  CHECK(!warnings.empty() && warnings[0].find("double precision") != std::string::npos);
}
}

int TestSurfaceKinds(int, char*[])
{
  testQuadrilateralsAndStrips();
  testConcavePolygons();
  testMoebiusStrip();
  testThreeSheets();
  testComponents();
  testOrientation();
  testSplitPoints();
  testSphereNormals();
  testRepairs();
  testClosedByRounding();
  testSlit();
  testDoubledSheet();
  testRoundedCoordinates();
  return result();
}
