// TopologyPreserved, NumberOfExtraPoints and the report: true, and as the surface allows.

#include "TestMeasures.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkRestrictedVoronoiDiagram.h"

#include <cmath>

using namespace remesh;
using namespace remesh::test;

namespace
{
double factOf(vtkRestrictedVoronoiAlgorithm* filter, const char* name)
{
  return arrayOf(filter->GetOutput()->GetFieldData(), name)->GetComponent(0, 0);
}

bool isPreserved(vtkRestrictedVoronoiAlgorithm* filter)
{
  const bool preserved = factOf(filter, "TopologyPreserved") == 1.0;
  CHECK_EQUAL(std::string(filter->GetTopologyReport()).empty(), preserved);
  return preserved;
}

/** Border edges of a mesh. */
int borderEdgesOf(vtkPolyData* mesh)
{
  const auto directed = directedEdgesOf(mesh);
  int count = 0;
  for (const auto& [ends, uses] : directed)
  {
    count += !directed.count({ ends.second, ends.first });
  }
  return count;
}

vtkSmartPointer<vtkAnisotropicRemesher> remesherOf(const TriangleSoup& soup, vtkIdType points)
{
  auto filter = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  filter->SetInputData(polyDataOf(soup));
  filter->SetNumberOfPoints(points);
  filter->SetNumberOfLloydIterations(3);
  filter->SetNumberOfNewtonIterations(8);
  return filter;
}

struct Expected
{
  vtkIdType euler;
  bool bordered;
};

/** Exactly as many points, proven, and as the surface is. */
void checkProven(const TriangleSoup& soup, vtkIdType points, const Expected& expected)
{
  const auto filter = remesherOf(soup, points);
  Messages messages(filter);
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  CHECK(messages.warnings().empty());
  CHECK(isPreserved(filter));
  CHECK_EQUAL(mesh->GetNumberOfPoints(), points);
  CHECK_EQUAL(factOf(filter, "NumberOfExtraPoints"), 0.0);
  CHECK_EQUAL(factOf(filter, "NumberOfNonManifoldEdges"), 0.0);
  CHECK_EQUAL(eulerCharacteristicOf(mesh), expected.euler);
  CHECK_EQUAL(borderEdgesOf(mesh) > 0, expected.bordered);
}

/** A box, thin enough for cells to reach both of its sides. */
TriangleSoup thinPlate()
{
  TriangleSoup soup = icosphere(4);
  for (Point3& point : soup.points)
  {
    point.z() *= 0.004;
  }
  return soup;
}

/** Limbs of 0.05 on a sphere. */
TriangleSoup spikySphere()
{
  TriangleSoup soup = icosphere(5);
  for (Point3& point : soup.points)
  {
    const double angle = std::acos(std::min(1.0, point.cwiseAbs().maxCoeff() / point.norm()));
    point *= 1.0 + 2.0 * std::exp(-std::pow(angle / 0.1, 2.0));
  }
  return soup;
}

/** Part of a torus: open at both ends. */
TriangleSoup tube()
{
  TriangleSoup soup = torus(1.0, 0.15, 40, 12);
  soup.triangles.resize(soup.triangles.size() / 2);
  soup.inputCells.resize(soup.triangles.size());
  return soup;
}

void testManifolds()
{
  checkProven(icosphere(4), 200, { 2, false });
  checkProven(torus(1.0, 0.4, 36, 18), 200, { 0, false });
  checkProven(thinPlate(), 300, { 2, false });
  checkProven(spikySphere(), 900, { 2, false });
  checkProven(tube(), 150, { 0, true });
  checkProven(gridPatch(10, 10), 100, { 1, true });
  checkProven(cube(), 150, { 2, false });
  TriangleSoup spheres = icosphere(4);
  append(spheres, icosphere(4), Point3(1.1, 0.0, 0.0)); // which cross, and share no point
  checkProven(spheres, 400, { 4, false });
}

/** One-sided: not orientable is what the warning says, and the topology is kept all the same. */
void testMoebiusStrip()
{
  const auto filter = remesherOf(moebiusStrip(100), 150);
  Messages messages(filter);
  filter->Update();
  CHECK_EQUAL(messages.warnings().size(), std::size_t(1));
  CHECK(isPreserved(filter));
  CHECK_EQUAL(eulerCharacteristicOf(filter->GetOutput()), 0);
}

/** What is no manifold is never proven, and the report says so; that is no reason for a warning. */
void testThreeSheets()
{
  const auto filter = remesherOf(threeSheets(), 90);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.warnings().empty());
  CHECK(!isPreserved(filter));
  CHECK_EQUAL(
    std::string(filter->GetTopologyReport()), "The surface is no manifold, at 1 edge, 2 points.");
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 90);
}

/** Four points are no torus: as many more as allowed. */
void testExtraPoints()
{
  const TriangleSoup soup = torus(1.0, 0.4, 36, 18);
  const vtkIdType onePercent = vtkAnisotropicRemesher::ONE_PERCENT;
  const vtkIdType unlimited = vtkAnisotropicRemesher::UNLIMITED;
  for (const vtkIdType most : { onePercent, unlimited, vtkIdType(0), vtkIdType(3), vtkIdType(200) })
  {
    const auto filter = remesherOf(soup, 4);
    filter->SetMaximumNumberOfExtraPoints(most);
    Messages messages(filter);
    filter->Update();
    const bool enough = most == unlimited || most == 200;
    const vtkIdType points = filter->GetOutput()->GetNumberOfPoints();
    CHECK_EQUAL(isPreserved(filter), enough);
    CHECK_EQUAL(messages.warnings().empty(), enough);
    CHECK_EQUAL(factOf(filter, "NumberOfExtraPoints"), static_cast<double>(points - 4));
    CHECK(points >= 4 && (most < 0 || points <= 4 + most));
    CHECK(!enough || (points >= 7 && points < 100)); // no torus has fewer
    CHECK(!enough || eulerCharacteristicOf(filter->GetOutput()) == 0);
    CHECK(most != onePercent || points == 4);
  }
}

/**
 * Spheres need four points each, so these some more than asked for. One percent allows three; more
 * than allowed are told.
 */
void testOnePercent()
{
  TriangleSoup soup;
  for (int k = 0; k < 100; ++k)
  {
    append(soup, icosphere(1), Point3(3.0 * (k % 10), 0.3 * (k - k % 10), 0.0));
  }
  constexpr vtkIdType onePercent = vtkAnisotropicRemesher::ONE_PERCENT;
  for (const auto& [most, extra] : { std::pair(onePercent, 2), std::pair(onePercent, 3),
         std::pair(onePercent, 4), std::pair(vtkIdType(1), 2), std::pair(vtkIdType(0), 2) })
  {
    const auto filter = remesherOf(soup, 400 - extra);
    filter->SetMaximumNumberOfExtraPoints(most);
    filter->MeasureDistanceOff(); // tetrahedra are far from spheres
    Messages messages(filter);
    filter->Update();
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 400);
    CHECK_EQUAL(factOf(filter, "NumberOfExtraPoints"), static_cast<double>(extra));
    CHECK(isPreserved(filter));
    const bool isAllowed = extra <= (most == onePercent ? 3 : most);
    CHECK_EQUAL(messages.warnings().size(), std::size_t(isAllowed ? 0 : 1));
    CHECK(
      isAllowed || messages.warnings()[0].find("points more than asked for") != std::string::npos);
  }
}

/** Parts that take four points each, more than asked for: extra points come on top of these. */
void testManyParts()
{
  TriangleSoup soup;
  for (int k = 0; k < 6; ++k)
  {
    append(soup, torus(1.0, 0.4, 24, 12), Point3(3.0 * k, 0.0, 0.0));
  }
  const auto filter = remesherOf(soup, 6);
  filter->SetMaximumNumberOfExtraPoints(vtkAnisotropicRemesher::UNLIMITED);
  filter->Update();
  CHECK(isPreserved(filter));
  CHECK_EQUAL(eulerCharacteristicOf(filter->GetOutput()), 0);
  CHECK(filter->GetOutput()->GetNumberOfPoints() < 600);
}

/** A sheet, rolled up in six turns. */
TriangleSoup roll()
{
  constexpr double pi = 3.14159265358979323846;
  TriangleSoup soup = gridPatch(200, 20);
  for (Point3& point : soup.points)
  {
    const double turns = 6.0 * point.x();
    const double radius = 0.1 + 0.1 * turns;
    point = { radius * std::cos(2.0 * pi * turns), radius * std::sin(2.0 * pi * turns), point.y() };
  }
  return soup;
}

/**
 * Where the points lie farther apart than the sheets, more cells come to reach several of them for
 * each that is taken away: what comes nearest to the number stays, or it is told.
 */
void testManySheets()
{
  for (const double anisotropy : { 0.0, 0.02, 0.05 })
  {
    const auto filter = remesherOf(roll(), 1000);
    filter->SetAnisotropy(anisotropy);
    Messages messages(filter);
    filter->Update();
    const vtkIdType points = filter->GetOutput()->GetNumberOfPoints();
    CHECK(points >= 990 && points <= 1010); // one percent
    CHECK_EQUAL(messages.warnings().empty(), points >= 1000);
    CHECK(isPreserved(filter));
  }
}

/** Given sites are told about as they are, and stay. */
void testGivenSites()
{
  const TriangleSoup ring = torus(1.0, 0.4, 36, 18);
  const auto many = remesherOf(ring, 200);
  many->Update();
  for (const bool enough : { true, false })
  {
    vtkNew<vtkRestrictedVoronoiDiagram> diagram;
    diagram->SetInputData(polyDataOf(ring));
    diagram->SetSitesData(enough
        ? many->GetSitesOutput()
        : pointsOnly({ { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 } }).Get());
    Messages messages(diagram);
    diagram->Update();
    CHECK(messages.warnings().empty());
    CHECK_EQUAL(isPreserved(diagram), enough);
    CHECK_EQUAL(diagram->GetSitesOutput()->GetNumberOfPoints(), enough ? 200 : 4);
  }
}
}

int TestTopology(int, char*[])
{
  testManifolds();
  testMoebiusStrip();
  testThreeSheets();
  testExtraPoints();
  testOnePercent();
  testManyParts();
  testManySheets();
  testGivenSites();
  return result();
}
