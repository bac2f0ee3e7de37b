// Adaptors/SurfaceIntake: every kind of cell and array that a vtkPolyData may hold.

#include "../Core/TestSupport.h"
#include "Adaptors/SurfaceIntake.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

#include <algorithm>
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
  const std::vector<Point3> arrow = { { 0, 0, 0 }, { 4, -1, 0 }, { 3, 0, 0 }, { 4, 1, 0 } };
  for (vtkIdType first = 0; first < 4; ++first)
  {
    const Cell turned = { first, (first + 1) % 4, (first + 2) % 4, (first + 3) % 4 };
    const std::array<double, 2> areas = areasOf(readPolygon(arrow, turned));
    CHECK_NEAR(areas[0], 6.0, 1e-15);
    CHECK_NEAR(areas[1], 6.0, 1e-15); // no triangle outside
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

/** The corners of a regular polygon around a place; against the clock if the radius is positive. */
std::vector<Point3> ring(int corners, double radius, const Point3& center)
{
  std::vector<Point3> points;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = (radius > 0.0 ? 2.0 : -2.0) * test::pi * i / corners;
    points.push_back(center + std::abs(radius) * Point3(std::cos(angle), std::sin(angle), 0.0));
  }
  return points;
}

/** Goes over to `hole` from a corner of the loop, around it from its corner `start`, and back. */
void addHole(std::vector<Point3>& loop, std::size_t corner, std::vector<Point3> hole, int start)
{
  std::rotate(hole.begin(), hole.begin() + start, hole.end());
  hole.push_back(hole.front());
  hole.push_back(loop[corner]);
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(corner) + 1, hole.begin(), hole.end());
}

/** n - 2 triangles that sum to the polygon's area and face as it does, in any position and size. */
void checkCut(const std::vector<Point3>& loop, const std::string& where)
{
  Point3 normal = Point3::Zero();
  Cell cell;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    normal += loop[i].cross(loop[(i + 1) % loop.size()]);
    cell.push_back(static_cast<vtkIdType>(i));
  }
  for (const double angle : { 0.0, 1.0 })
  {
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(angle, Point3(1, 2, 3).normalized()).toRotationMatrix();
    const Point3 shift = angle * Point3(9, -7, 5);
    for (const double scale : { 1.0, 1e-80, 1e80, -3.7e-7 })
    {
      std::vector<Point3> points;
      for (const Point3& point : loop)
      {
        points.push_back(scale * Point3(turn * point + shift));
      }
      TriangleSoup soup;
      std::string warning;
      const Status status =
        readTriangleSoup(polyData(points, { {}, {}, { cell }, {} }), soup, &warning);
      CHECK(status.ok());
      for (Point3& point : soup.points)
      {
        point = turn.transpose() * point / scale;
      }
      const auto areas = areasOf(soup);
      const auto isGood = [&](bool good)
      { test::check(good, __FILE__, __LINE__, where + ", scale " + std::to_string(scale)); };
      isGood(soup.triangles.size() == loop.size() - 2);
      isGood(std::abs(areas[0] - normal[2]) < 1e-12 * normal[2]);
      isGood(std::abs(areas[1] - normal[2]) < 1e-12 * normal[2]);
      isGood(warning.empty());
    }
  }
}

/** Polygons with holes, as loops with bridges that run twice; and concave ones. */
void testKeyholes()
{
  const std::vector<Point3> large = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 0, 3, 0 } };
  const std::vector<Point3> small = { { 1, 1, 0 }, { 1, 2, 0 }, { 2, 2, 0 }, { 2, 1, 0 } };
  for (int corner = 0; corner < 4; ++corner)
  {
    std::vector<Point3> loop = large;
    const int nearest[4] = { 0, 3, 2, 1 };
    addHole(loop, corner, small, nearest[corner]);
    for (std::size_t first = 0; first < loop.size(); ++first)
    {
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
      checkCut(loop, "a square with a hole, from corner " + std::to_string(first));
    }
  }
  for (const int corners : { 3, 4, 7, 40 })
  {
    std::vector<Point3> loop = ring(12, 2.0, Point3::Zero());
    addHole(loop, 6, ring(corners, -0.4, { -1, 0, 0 }), corners / 2);
    addHole(loop, 0, ring(corners, -0.4, { 1, 0, 0 }), 0);
    checkCut(loop, "two holes of " + std::to_string(corners) + " corners");
    // A third hole, on a bridge from the second one's.
    std::vector<Point3> chain = ring(5, 4.0, Point3::Zero());
    addHole(chain, 0, ring(corners, -0.5, { 2, 0, 0 }), 0);
    const std::size_t last = corners % 2 == 0 ? 2 + corners / 2 : 0;
    if (last > 0)
    {
      addHole(chain, last - 1, ring(6, -0.5, { 0, 0, 0 }), 0);
    }
    checkCut(chain, "a chain of holes of " + std::to_string(corners) + " corners");
  }
  // A bridge with corners on it, in both directions, and a hole that touches the border.
  checkCut({ { 0, 0, 0 }, { 6, 0, 0 }, { 6, 6, 0 }, { 0, 6, 0 }, { 0, 0, 0 }, { 1, 1, 0 },
             { 2, 2, 0 }, { 2, 4, 0 }, { 4, 4, 0 }, { 4, 2, 0 }, { 2, 2, 0 }, { 1, 1, 0 } },
    "corners on a bridge");
  checkCut(
    { { 0, 0, 0 }, { 6, 0, 0 }, { 6, 6, 0 }, { 0, 6, 0 }, { 0, 0, 0 }, { 2, 4, 0 }, { 4, 2, 0 } },
    "a hole from a corner");
  checkCut({ { 0, 0, 0 }, { 2, 0, 0 }, { 1, 0.2, 0 }, { 2, 2, 0 }, { 1, 1, 0 }, { 0, 2, 0 },
             { 0.4, 1, 0 } },
    "a concave polygon");
  // Where the shorter diagonal lies outside.
  checkCut({ { 0, 0, 0 }, { 4, -1, 0 }, { 3, 0, 0 }, { 4, 1, 0 } }, "an arrow");
  checkCut({ { 4, -1, 0 }, { 3, 0, 0 }, { 4, 1, 0 }, { 0, 0, 0 } }, "an arrow, turned");
  checkCut({ { 0, 0, 0 }, { 4, 1, 0 }, { 5, 5, 0 }, { 1, 0.5, 0 } }, "a concave quadrilateral");
}

/** What crosses itself cannot be cut, and is told. */
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
  testKeyholes();
  testCrossingPolygons();
  testRepeatedAndMissingPoints();
  testMixedCube();
  testRefusals();
  return test::result();
}
