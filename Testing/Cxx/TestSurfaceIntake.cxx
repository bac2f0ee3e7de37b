// Adaptors/SurfaceIntake: every kind of cell and array that a vtkPolyData may hold.

#include "../Core/TestSupport.h"
#include "Adaptors/SurfaceIntake.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <initializer_list>
#include <limits>

using namespace remesh;

namespace
{
using Cell = std::vector<vtkIdType>;
using Triangle = std::array<Offset, 3>;

struct Cells
{
  std::vector<Cell> verts;
  std::vector<Cell> lines;
  std::vector<Cell> polys;
  std::vector<Cell> strips;
};

vtkSmartPointer<vtkCellArray> cellArray(const std::vector<Cell>& cells, bool wide = true)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  if (wide)
  {
    array->Use64BitStorage();
  }
  else
  {
    array->Use32BitStorage();
  }
  for (const Cell& cell : cells)
  {
    array->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  return array;
}

vtkSmartPointer<vtkPolyData> polyData(
  const std::vector<Point3>& points, const Cells& cells, int pointType = VTK_DOUBLE)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> vtkpoints;
  vtkpoints->SetDataType(pointType);
  for (const Point3& point : points)
  {
    vtkpoints->InsertNextPoint(point.data());
  }
  data->SetPoints(vtkpoints);
  data->SetVerts(cellArray(cells.verts));
  data->SetLines(cellArray(cells.lines));
  data->SetPolys(cellArray(cells.polys));
  data->SetStrips(cellArray(cells.strips));
  return data;
}

TriangleSoup read(vtkPolyData* data)
{
  TriangleSoup soup;
  const Status status = readTriangleSoup(data, soup);
  CHECK_EQUAL(status.message, "");
  CHECK_EQUAL(soup.inputCells.size(), soup.triangles.size());
  return soup;
}

/** Twice the sum of the triangles' area vectors, projected on z, and of their areas. */
std::array<double, 2> areasOf(const TriangleSoup& soup)
{
  std::array<double, 2> sums = { 0.0, 0.0 };
  for (const auto& [a, b, c] : soup.triangles)
  {
    const Point3 normal = (soup.points[b] - soup.points[a]).cross(soup.points[c] - soup.points[a]);
    sums[0] += normal[2];
    sums[1] += normal.norm();
  }
  return sums;
}

TriangleSoup readPolygon(const std::vector<Point3>& points, const Cell& cell)
{
  return read(polyData(points, { {}, {}, { cell }, {} }));
}

const std::vector<Point3> square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };

void testTriangles()
{
  const std::vector<Cell> cells = { { 0, 1, 2 }, { 2, 3, 0 } };
  const std::vector<Triangle> expected = { { 0, 1, 2 }, { 2, 3, 0 } };
  for (const bool wide : { false, true })
  {
    auto data = polyData(square, {});
    data->SetPolys(cellArray(cells, wide));
    const TriangleSoup soup = read(data);
    CHECK(soup.triangles == expected);
    CHECK(soup.inputCells == std::vector<Offset>({ 0, 1 }));
    CHECK(soup.points == square);
  }
}

void testPointTypes()
{
  const std::vector<Point3> points = { { 0.1, -3, 0 }, { 7, 1.0 / 3.0, 2 }, { 5, -1, 1e-3 } };
  for (const int type : { VTK_DOUBLE, VTK_FLOAT, VTK_INT, VTK_SHORT })
  {
    auto data = polyData(points, { {}, {}, { { 0, 1, 2 } }, {} }, type);
    const TriangleSoup soup = read(data);
    for (vtkIdType i = 0; i < 3; ++i)
    {
      std::array<double, 3> stored{};
      data->GetPoint(i, stored.data());
      CHECK(soup.points[i] == Point3(stored[0], stored[1], stored[2]));
    }
  }
  // A float is taken as it is, not as the nearest short decimal.
  auto data = polyData(points, { {}, {}, { { 0, 1, 2 } }, {} }, VTK_FLOAT);
  CHECK_EQUAL(read(data).points[0][0], static_cast<double>(0.1f));
}

void testCellIds()
{
  // Verts, lines, polygons, strips: that is how vtkPolyData numbers cells.
  const Cells cells = { { { 0 }, { 1, 2 } }, { { 0, 1, 2 } }, { { 0, 1, 2 }, { 0, 1, 2, 3 } },
    { { 3, 2, 0, 1 } } };
  auto data = polyData(square, cells);
  const TriangleSoup soup = read(data);
  CHECK(soup.inputCells == std::vector<Offset>({ 3, 4, 4, 5, 5 }));
  for (const Offset cell : soup.inputCells)
  {
    CHECK(data->GetCellType(cell) != VTK_POLY_LINE && data->GetCellType(cell) != VTK_POLY_VERTEX);
  }
  // Triangles alone take the short way, and count the same.
  const TriangleSoup plain =
    read(polyData(square, { { { 0 } }, { { 0, 1 } }, { { 0, 1, 2 } }, {} }));
  CHECK(plain.inputCells == std::vector<Offset>({ 2 }));
}

void testStrips()
{
  // A strip of four triangles, all facing +z; the odd ones turn.
  std::vector<Point3> points;
  for (int i = 0; i < 6; ++i)
  {
    points.emplace_back(i / 2, i % 2 == 0 ? 1 : 0, 0);
  }
  const TriangleSoup soup =
    read(polyData(points, { {}, {}, {}, { { 0, 1, 2, 3, 4, 5 }, { 0, 1 } } }));
  CHECK(soup.triangles ==
    std::vector<Triangle>({ { 0, 1, 2 }, { 1, 3, 2 }, { 2, 3, 4 }, { 3, 5, 4 } }));
  CHECK_NEAR(areasOf(soup)[0], 4.0, 1e-15);
}

void testQuadrilaterals()
{
  const std::vector<Triangle> along02 = { { 0, 1, 2 }, { 0, 2, 3 } };
  const std::vector<Triangle> along13 = { { 0, 1, 3 }, { 1, 2, 3 } };
  const Cell quad = { 0, 1, 2, 3 };
  // A tie goes to the first point's diagonal; else the shorter one is cut.
  CHECK(readPolygon(square, quad).triangles == along02);
  CHECK(
    readPolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 } }, quad).triangles == along13);
  CHECK(
    readPolygon({ { 0, 0, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 1, 0 } }, quad).triangles == along13);
  CHECK(
    readPolygon({ { 1, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 0, 0, 0 } }, quad).triangles == along02);
  // Concave at each corner in turn: the shorter diagonal lies outside.
  const std::vector<Point3> arrow = { { 0, 0, 0 }, { 4, -1, 0 }, { 1, 0, 0 }, { 4, 1, 0 } };
  for (vtkIdType first = 0; first < 4; ++first)
  {
    const Cell turned = { first, (first + 1) % 4, (first + 2) % 4, (first + 3) % 4 };
    const std::array<double, 2> areas = areasOf(readPolygon(arrow, turned));
    CHECK_NEAR(areas[0], 2.0, 1e-15);
    CHECK_NEAR(areas[1], 2.0, 1e-15); // no triangle outside
  }
  // A corner on a straight line: no triangle without area, though that diagonal is shorter.
  const TriangleSoup flat =
    readPolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 1, 5, 0 } }, quad);
  CHECK(flat.triangles == along13);
}

void testLargePolygons()
{
  for (int n = 5; n < 40; n += 7)
  {
    std::vector<Point3> convex;
    std::vector<Point3> star;
    Cell cell;
    for (int i = 0; i < 2 * n; ++i)
    {
      const double angle = test::pi * i / n;
      const Point3 onCircle(std::cos(angle), std::sin(angle), 0.0);
      convex.push_back(onCircle);
      star.emplace_back(onCircle * (i % 2 == 0 ? 1.0 : 0.4));
      cell.push_back(i);
    }
    const double full = 2.0 * n * std::sin(test::pi / n);
    const TriangleSoup fromConvex = readPolygon(convex, cell);
    CHECK_EQUAL(fromConvex.triangles.size(), static_cast<std::size_t>(2 * n - 2));
    CHECK_NEAR(areasOf(fromConvex)[0], full, 1e-13);
    const TriangleSoup fromStar = readPolygon(star, cell);
    CHECK_NEAR(areasOf(fromStar)[0], 0.4 * full, 1e-13);
    CHECK_NEAR(areasOf(fromStar)[1], 0.4 * full, 1e-13); // no overlaps
    for (const double scale : { 1e-40, 1e-12, 1e-7, 1e40 })
    {
      std::vector<Point3> scaled = star;
      for (Point3& point : scaled)
      {
        point *= scale;
      }
      const auto areas = areasOf(readPolygon(scaled, cell));
      CHECK_NEAR(areas[0] / (scale * scale), 0.4 * full, 1e-13);
      CHECK_NEAR(areas[1] / (scale * scale), 0.4 * full, 1e-13);
    }
  }
  // vtkPolygon gives up on a polygon without area: still n - 2 triangles, for the intake to count.
  const std::vector<Point3> line = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 },
    { 4, 0, 0 } };
  CHECK_EQUAL(readPolygon(line, { 0, 1, 2, 3, 4 }).triangles.size(), std::size_t(3));
  // Coordinates that are not finite are the intake's to refuse; here they do no harm.
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, 1e300 })
  {
    std::vector<Point3> points = line;
    points[2][1] = bad;
    CHECK_EQUAL(readPolygon(points, { 0, 1, 2, 3, 4 }).triangles.size(), std::size_t(3));
    CHECK_EQUAL(readPolygon(points, { 0, 1, 2, 3 }).triangles.size(), std::size_t(2));
  }
}

void testRepeatedAndMissingPoints()
{
  CHECK(
    readPolygon(square, { 0, 0, 1, 2, 2, 0 }).triangles == std::vector<Triangle>({ { 0, 1, 2 } }));
  CHECK(readPolygon(square, { 3, 0, 1, 2, 3, 3 }).triangles.size() == 2);
  // Polygons of two points, one and none, among others: no cell id slips.
  const TriangleSoup soup =
    read(polyData(square, { {}, {}, { { 0, 1 }, {}, { 2, 2, 2, 2 }, { 0, 1, 2 } }, {} }));
  CHECK(soup.inputCells == std::vector<Offset>({ 0, 2, 3 }));
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(test::takeIn(soup, mesh, report).ok());
  CHECK_EQUAL(report.droppedDegenerate, 2);
  CHECK_EQUAL(mesh.numberOfFacets(), 1);
  CHECK_EQUAL(mesh.facetInputCells[0], 3);
  CHECK_EQUAL(mesh.numberOfPoints(), 3); // point 3 is not used
}

/** Cubes as quads, as triangles, as strips and mixed are one surface. */
void testMixedCube()
{
  const TriangleSoup cube = test::cube();
  std::vector<Cell> triangles;
  for (const auto& [a, b, c] : cube.triangles)
  {
    triangles.push_back({ a, b, c });
  }
  const std::vector<Cell> quads = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  const std::vector<Cell> strips = { { 0, 1, 4, 5, 6, 7, 2, 3, 0, 1 }, { 4, 6, 0, 2 },
    { 1, 3, 5, 7 } };
  const std::vector<Cell> halfQuads(quads.begin(), quads.begin() + 4);
  const std::vector<Cell> halfStrips = { { 4, 6, 0, 2 }, { 1, 3, 5, 7 } };
  Cells mixed = { {}, {}, halfQuads, halfStrips };
  for (std::size_t t = 0; t < 2; ++t)
  {
    // One quad as its two triangles instead.
    mixed.polys.push_back({ triangles[t][0], triangles[t][1], triangles[t][2] });
  }
  mixed.polys.erase(mixed.polys.begin());
  for (const Cells& cells : { Cells{ {}, {}, triangles, {} }, Cells{ {}, {}, quads, {} },
         Cells{ { { 0 } }, {}, {}, strips }, mixed })
  {
    SurfaceMesh mesh;
    IntakeReport report;
    CHECK(test::takeIn(read(polyData(cube.points, cells)), mesh, report).ok());
    CHECK_EQUAL(mesh.numberOfFacets(), 12);
    CHECK_EQUAL(report.flippedFacets, 0);
    CHECK_EQUAL(report.boundaryEdges + report.nonManifoldEdges, 0);
    CHECK_NEAR(test::enclosedVolume(mesh), 1.0, 1e-15);
  }
}

void checkRefused(vtkPolyData* data, StatusCode code, const std::string& part)
{
  TriangleSoup soup = test::cube();
  const Status status = readTriangleSoup(data, soup);
  CHECK(status.code == code);
  CHECK(status.message.find(part) != std::string::npos);
  CHECK(soup.triangles.empty() && soup.points.empty() && soup.inputCells.empty());
}

void testRefusals()
{
  checkRefused(nullptr, StatusCode::InvalidInput, "no input");
  vtkNew<vtkPolyData> nothing;
  checkRefused(nothing, StatusCode::EmptyInput, "no points and no cells");
  checkRefused(polyData({}, {}), StatusCode::EmptyInput, "no points and no cells");
  checkRefused(polyData(square, {}), StatusCode::InvalidInput, "no polygons");
  checkRefused(polyData(square, { { { 0 } }, { { 0, 1 }, { 1, 2 } }, {}, {} }),
    StatusCode::InvalidInput, "2 lines");

  const Cells badTriangle = { { { 0 } }, {}, { { 0, 1, 2 }, { 0, 1, 4 } }, {} };
  checkRefused(polyData(square, badTriangle), StatusCode::InvalidInput, "Cell 2 refers to point 4");
  const Cells badQuad = { {}, {}, { { 0, 1, 2 }, { 0, 1, 2, -1 } }, {} };
  checkRefused(polyData(square, badQuad), StatusCode::InvalidInput, "Cell 1 refers to point -1");
  const Cells badStrip = { {}, {}, { { 0, 1, 2 } }, { { 0, 1, 2, 99 } } };
  checkRefused(polyData(square, badStrip), StatusCode::InvalidInput, "Cell 1 refers to point 99");
  vtkNew<vtkPolyData> noPoints;
  noPoints->SetPolys(cellArray({ { 0, 1, 2 } }));
  checkRefused(noPoints, StatusCode::InvalidInput, "Cell 0 refers to point 0");
}
}

int TestSurfaceIntake(int, char*[])
{
  testTriangles();
  testPointTypes();
  testCellIds();
  testStrips();
  testQuadrilaterals();
  testLargePolygons();
  testRepeatedAndMissingPoints();
  testMixedCube();
  testRefusals();
  return test::result();
}
