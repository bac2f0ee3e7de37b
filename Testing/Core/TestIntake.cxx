// Mesh/Intake: what is dropped, refused and counted, and in which order it comes out.

#include "Mesh/FacetGeometry.h"
#include "Support/Hilbert.h"
#include "Support/KeyOrder.h"
#include "Support/Random.h"
#include "TestSupport.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <set>

using namespace remesh;

namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

struct Expected
{
  TriangleSoup soup;
  Index points;
  Index facets;
  Index euler;
  Index boundaryEdges;
  Index nonManifoldEdges;
  Index components;
  double area;
};

void testCounts()
{
  const double root3 = std::sqrt(3.0);
  TriangleSoup twoPatches = test::gridPatch(3, 2);
  test::append(twoPatches, test::gridPatch(4, 4), { 0.0, 0.0, 5.0 });
  TriangleSoup twoTetrahedra = test::tetrahedron(); // on one common point
  test::append(twoTetrahedra, test::tetrahedron(), { 0.0, 0.0, 1.0 });
  const double tetrahedronArea = 1.5 + 0.5 * root3;
  const double icosahedronArea = 20.0 * root3 / (0.5 * (5.0 + std::sqrt(5.0)));
  const std::vector<Expected> cases = {
    { test::tetrahedron(), 4, 4, 2, 0, 0, 1, tetrahedronArea },
    { test::cube(), 8, 12, 2, 0, 0, 1, 6.0 },
    { test::gridPatch(7, 5), 48, 70, 1, 24, 0, 1, 1.0 },
    { test::icosphere(0), 12, 20, 2, 0, 0, 1, icosahedronArea },
    { test::icosphere(3), 642, 1280, 2, 0, 0, 1, 0.0 },
    { test::torus(2.0, 0.5, 24, 12), 288, 576, 0, 0, 0, 1, 0.0 },
    { test::moebiusStrip(20), 40, 40, 0, 40, 0, 1, 0.0 },
    { test::threeSheets(), 8, 6, 1, 9, 1, 1, 3.0 },
    { twoPatches, 37, 44, 2, 26, 0, 2, 2.0 },
    { twoTetrahedra, 7, 8, 3, 0, 0, 1, 2.0 * tetrahedronArea },
  };
  for (const Expected& expected : cases)
  {
    SurfaceMesh mesh;
    IntakeReport report;
    CHECK(test::takeIn(expected.soup, mesh, report).ok());
    CHECK_EQUAL(mesh.numberOfPoints(), expected.points);
    CHECK_EQUAL(mesh.numberOfFacets(), expected.facets);
    CHECK_EQUAL(mesh.numberOfCorners(), expected.points);
    CHECK_EQUAL(test::eulerCharacteristic(mesh), expected.euler);
    CHECK_EQUAL(report.boundaryEdges, expected.boundaryEdges);
    CHECK_EQUAL(report.nonManifoldEdges, expected.nonManifoldEdges);
    CHECK_EQUAL(report.components, expected.components);
    CHECK_EQUAL(report.dropped(), 0);
    if (expected.area > 0.0)
    {
      CHECK_NEAR(test::surfaceArea(mesh), expected.area, 1e-13 * expected.area);
    }
  }
  // Inscribed triangulations converge to the smooth areas with the square of the edge length.
  const double sphere = test::surfaceArea(test::meshOf(test::icosphere(4)));
  CHECK(sphere < 4.0 * test::pi && sphere > 0.995 * 4.0 * test::pi);
}

/** The same coordinates and ids as the soup, corner by corner, whatever the order. */
void testProvenance()
{
  const TriangleSoup soup = test::torus(2.0, 0.5, 30, 20);
  const SurfaceMesh mesh = test::meshOf(soup);
  std::vector<char> seen(soup.triangles.size(), 0);
  Index highestPoint = noIndex;
  bool firstUseOrder = true;
  for (Index f = 0; f < mesh.numberOfFacets(); ++f)
  {
    const Offset cell = mesh.facetInputCells[f];
    ++seen[cell];
    CHECK(mesh.facetInputPoints[f] == soup.triangles[cell]); // no rotation, no turn
    for (int k = 0; k < 3; ++k)
    {
      const Index point = mesh.facetPoints[f][k];
      CHECK(mesh.points[point] == soup.points[mesh.facetInputPoints[f][k]]);
      firstUseOrder = firstUseOrder && point <= highestPoint + 1;
      highestPoint = std::max(highestPoint, point);
    }
  }
  CHECK(std::all_of(seen.begin(), seen.end(), [](char times) { return times == 1; }));
  CHECK(firstUseOrder);
  CHECK(mesh.facetCorners == mesh.facetPoints);
  for (Index corner = 0; corner < mesh.numberOfCorners(); ++corner)
  {
    CHECK_EQUAL(mesh.cornerPoints[corner], corner);
  }
}

void testDegenerate()
{
  TriangleSoup soup = test::gridPatch(4, 4, { 1e6, -1e6, 1e6 });
  const auto count = static_cast<Index>(soup.triangles.size());
  const std::vector<std::array<Offset, 3>> bad = { { 0, 0, 1 }, { 3, 4, 3 }, { 5, 5, 5 },
    { 0, 1, 2 }, { 0, 6, 12 }, { 4, 2, 0 } }; // the last three: points on a line
  soup.triangles.insert(soup.triangles.begin() + 7, bad.begin(), bad.end());
  soup.inputCells.assign(soup.triangles.size(), 0);
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(test::takeIn(soup, mesh, report).ok());
  CHECK_EQUAL(report.droppedDegenerate, 6);
  CHECK_EQUAL(report.droppedDuplicate, 0);
  CHECK_EQUAL(mesh.numberOfFacets(), count);
  CHECK_NEAR(test::surfaceArea(mesh), 1.0, 1e-9); // the corners are rounded at 1e6

  // Slivers with any width have area, at any scale; points on a line do not, however rounded.
  for (const double scale : { 1.0, 1e-45, 1e45 })
  {
    const auto at = [scale](double x, double y) { return Point3(scale * x, scale * y, 0.0); };
    CHECK(hasArea(at(0, 0), at(1, 0), at(0.5, 1e-14)));
    CHECK(hasArea(at(0, 0), at(1, 0), at(1, 1e-25)));
    CHECK(hasArea(at(1, 0), at(1, std::numeric_limits<double>::epsilon()), at(0, 0)));
    CHECK(!hasArea(at(0, 0), at(1, 0), at(0.5, 1e-17)));
    CHECK(!hasArea(at(0, 0), at(0.1, 0.3), at(0.7 * 0.1, 0.7 * 0.3)));
    CHECK(!hasArea(at(1, 1), at(1, 1), at(2, 3)));
  }
}

void testDuplicates()
{
  TriangleSoup soup = test::tetrahedron();
  soup.triangles.push_back({ 2, 1, 0 }); // as the first, rotated
  soup.triangles.push_back({ 0, 3, 1 }); // against the second
  soup.triangles.push_back({ 1, 2, 3 }); // as the third
  soup.triangles.push_back({ 3, 2, 1 }); // against it
  soup.inputCells = { 10, 11, 12, 13, 14, 15, 16, 17 };
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(test::takeIn(soup, mesh, report).ok());
  CHECK_EQUAL(report.droppedDuplicate, 4);
  CHECK_EQUAL(report.flippedFacets, 0);
  CHECK_EQUAL(report.boundaryEdges + report.nonManifoldEdges, 0);
  CHECK_NEAR(test::enclosedVolume(mesh), 1.0 / 6.0, 1e-15);
  const std::set<Offset> cells(mesh.facetInputCells.begin(), mesh.facetInputCells.end());
  CHECK(cells == std::set<Offset>({ 10, 11, 12, 13 }));
}

/** Two triangles on the same points, back to back, that hang on an edge: both go. */
void testFlaps()
{
  TriangleSoup soup = test::icosphere(2);
  const std::size_t count = soup.triangles.size();
  for (const std::size_t at : { std::size_t(3), count / 2 })
  {
    const auto [a, b, c] = soup.triangles[at];
    const auto tip = static_cast<Offset>(soup.points.size());
    soup.points.push_back(1.2 * soup.points[a]);
    soup.points.push_back(1.3 * soup.points[a]);
    // A flap of two pairs, the second behind the first.
    for (const auto& facet : { std::array{ a, b, tip }, std::array{ b, tip, tip + 1 } })
    {
      soup.triangles.push_back(facet);
      soup.triangles.push_back({ facet[1], facet[0], facet[2] });
    }
  }
  soup.inputCells.resize(soup.triangles.size());
  std::iota(soup.inputCells.begin(), soup.inputCells.end(), Offset(0));
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(test::takeIn(soup, mesh, report).ok());
  CHECK_EQUAL(report.droppedDuplicate, 4);
  CHECK_EQUAL(report.droppedFlaps, 4);
  CHECK_EQUAL(static_cast<std::size_t>(mesh.numberOfFacets()), count);
  CHECK_EQUAL(report.boundaryEdges + report.nonManifoldEdges, 0);
}

/** A sheet that is there twice, facing both ways, becomes one; and so does a border's second half.
 */
void testDoubledSheets()
{
  TriangleSoup soup = test::gridPatch(4, 4);
  const std::size_t count = soup.triangles.size();
  for (const bool whole : { true, false })
  {
    TriangleSoup doubled = soup;
    for (std::size_t t = whole ? 0 : count / 2; t < count; ++t)
    {
      const auto [a, b, c] = soup.triangles[t];
      doubled.triangles.push_back({ b, a, c });
    }
    doubled.inputCells.resize(doubled.triangles.size(), 0);
    SurfaceMesh mesh;
    IntakeReport report;
    CHECK(test::takeIn(doubled, mesh, report).ok());
    CHECK_EQUAL(static_cast<std::size_t>(mesh.numberOfFacets()), count);
    CHECK_EQUAL(report.droppedFlaps, 0);
    CHECK_EQUAL(report.nonManifoldEdges, 0);
    CHECK_EQUAL(report.boundaryEdges, 16);
  }
}

void testRefusals()
{
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(test::takeIn(TriangleSoup(), mesh, report).code == StatusCode::EmptyInput);
  CHECK(
    test::takeIn(test::makeSoup({ { 0, 0, 0 } }, {}), mesh, report).code == StatusCode::EmptyInput);
  CHECK(test::takeIn(test::makeSoup({ { 1, 2, 3 } }, { { 0, 0, 0 } }), mesh, report).code ==
    StatusCode::EmptyInput);
  CHECK_EQUAL(report.droppedDegenerate, 1);
  CHECK(mesh.facetPoints.empty() && mesh.points.empty());

  for (const double bad : { notANumber, infinity, -infinity, 1e60 })
  {
    TriangleSoup soup = test::cube();
    soup.points.insert(soup.points.begin(), Point3(bad, bad, bad)); // unused: no harm
    for (auto& triangle : soup.triangles)
    {
      triangle = { triangle[0] + 1, triangle[1] + 1, triangle[2] + 1 };
    }
    CHECK(test::takeIn(soup, mesh, report).ok());
    CHECK_EQUAL(mesh.numberOfPoints(), 8);
    soup.points[6][1] = bad;
    soup.points[8][2] = bad;
    const Status status = test::takeIn(soup, mesh, report);
    CHECK(status.code == StatusCode::InvalidInput);
    CHECK(status.message.find("Point 6 ") != std::string::npos); // the first bad one
    CHECK(mesh.points.empty());
  }
  for (const Offset bad : { Offset(-1), Offset(8), std::numeric_limits<Offset>::max() })
  {
    TriangleSoup soup = test::cube();
    soup.triangles[5][2] = bad;
    const Status status = test::takeIn(soup, mesh, report);
    CHECK(status.code == StatusCode::InvalidInput);
    CHECK(status.message.find("Cell 5 ") != std::string::npos);
  }
  TriangleSoup tiny = test::cube();
  for (Point3& point : tiny.points)
  {
    point *= 1e-60;
  }
  CHECK(test::takeIn(tiny, mesh, report).code == StatusCode::InvalidInput);
  TriangleSoup shortOfCells = test::cube();
  shortOfCells.inputCells.pop_back();
  CHECK(test::takeIn(shortOfCells, mesh, report).code == StatusCode::InvalidInput);
}

void testControl()
{
  double last = 0.0;
  bool rising = true;
  const RunControl control(
    [&](double fraction, const char*)
    {
      rising = rising && fraction >= last;
      last = fraction;
    },
    {});
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(buildSurfaceMesh(test::icosphere(2), IntakeOptions(), control, mesh, report).ok());
  CHECK(rising);
  CHECK_EQUAL(last, 1.0);

  // Cancelled at any question: says so, and leaves no half of a mesh.
  for (int allowed = 0; allowed < 20; ++allowed)
  {
    int asked = 0;
    const RunControl stop({}, [&]() { return ++asked > allowed; });
    const Status status = buildSurfaceMesh(test::icosphere(2), { 1e-3 }, stop, mesh, report);
    CHECK(status.code == (asked > allowed ? StatusCode::Cancelled : StatusCode::Ok));
    CHECK(status.ok() == !mesh.points.empty());
  }
}

/** A Hilbert curve visits each cell once, and its next cell is a neighbour. */
void testHilbert()
{
  constexpr std::uint32_t side = 16;
  std::vector<std::array<std::uint32_t, 3>> path(side * side * side);
  for (std::uint32_t i = 0; i < path.size(); ++i)
  {
    // The coarse cells of the full grid: their keys differ in the leading 12 bits.
    const std::array<std::uint32_t, 3> cell = { i % side, i / side % side, i / side / side };
    const std::uint64_t key =
      hilbertKey({ cell[0] << 17, cell[1] << 17, cell[2] << 17 }) >> (63 - 12);
    CHECK(key < path.size());
    path[key] = cell;
  }
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    int steps = 0;
    for (int k = 0; k < 3; ++k)
    {
      steps += std::abs(static_cast<int>(path[i][k]) - static_cast<int>(path[i + 1][k]));
    }
    CHECK_EQUAL(steps, 1);
  }
  CHECK_EQUAL(hilbertKey(Point3(-1, -9, -0.0), Point3::Zero(), 1.0),
    hilbertKey(Point3(0, 0, notANumber), Point3::Zero(), 1.0));
  CHECK_EQUAL(hilbertKey(Point3(1, 1, 1), Point3::Zero(), 1.0),
    hilbertKey(Point3(7, infinity, 1e300), Point3::Zero(), 1.0));
}

void testKeyOrder()
{
  for (const std::uint64_t mask : { ~std::uint64_t(0), std::uint64_t(0xF0), std::uint64_t(0) })
  {
    std::vector<std::uint64_t> keys(5000);
    std::vector<Index> expected(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      keys[i] = mixBits(i) & mask;
      expected[i] = static_cast<Index>(i);
    }
    std::stable_sort(
      expected.begin(), expected.end(), [&](Index a, Index b) { return keys[a] < keys[b]; });
    CHECK(orderByKey(keys) == expected);
  }
  CHECK(orderByKey({}).empty());
}
}

int TestIntake(int, char*[])
{
  testCounts();
  testProvenance();
  testDegenerate();
  testDuplicates();
  testFlaps();
  testDoubledSheets();
  testRefusals();
  testControl();
  testHilbert();
  testKeyOrder();
  return test::result();
}
