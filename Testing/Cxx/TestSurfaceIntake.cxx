// Adaptors/SurfaceIntake: every kind of cell and array that a vtkPolyData may hold.

#include "../Core/TestSupport.h"
#include "Adaptors/SurfaceIntake.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Geometry>

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
  for (const auto& [a, b, c] : soup.triangles)
  {
    CHECK_EQUAL((points[b] - points[a]).cross(points[c] - points[a])[2], 1.0);
  }
}

/** A warning counts what cannot be cut. */
void testCrossingPolygons()
{
  const std::vector<Point3> eight = { { 0, 0, 0 }, { 2, 2, 0 }, { 4, 0, 0 }, { 4, 2, 0 },
    { 2, 0.5, 0 }, { 0, 2, 0 } };
  TriangleSoup soup;
  std::string warning;
  CHECK(readTriangleSoup(
    polyData(eight, { {}, {}, { { 0, 1, 2, 3, 4, 5 }, { 0, 1, 2 }, { 1, 2, 3, 4, 5, 0 } }, {} }),
    soup, &warning)
          .ok());
  CHECK_EQUAL(soup.triangles.size(), std::size_t(9));
  CHECK_EQUAL(warning, "2 polygons cross themselves: their triangles overlap.");
}

/** Polygons of two points, one and none, among others: no cell id slips. */
void testDegeneratePolygons()
{
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
  testCrossingPolygons();
  testDegeneratePolygons();
  testMixedCube();
  testRefusals();
  return test::result();
}
