// What is degraded or does not fit is told once, and does no harm.

#include "Pipeline/RunWarnings.h"
#include "TestComparisons.h"
#include "TestHelpers.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricKuen.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace remesh;
using namespace remesh::test;

namespace
{
vtkSmartPointer<vtkPolyData> sphere()
{
  return polyDataOf(icosphere(3));
}

/** Runs and expects one warning that contains `part`, or none if `part` is empty. */
void checkWarning(const std::string& what, vtkAnisotropicRemesher* filter, const std::string& part)
{
  Messages messages(filter);
  filter->Update();
  check(messages.errors().empty(), __FILE__, __LINE__, what + ": an error");
  const auto& warnings = messages.warnings();
  const bool right = part.empty()
    ? warnings.empty()
    : warnings.size() == 1 && warnings[0].find(part) != std::string::npos;
  check(right, __FILE__, __LINE__,
    what + ": " + std::to_string(warnings.size()) + " warnings" +
      (warnings.empty() ? "" : ", the first: " + warnings[0]));
}

vtkSmartPointer<vtkAnisotropicRemesher> remesherOf(vtkPolyData* input, vtkIdType points)
{
  auto filter = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  filter->SetInputData(input);
  filter->SetNumberOfPoints(points);
  return filter;
}

/** Two sheets so close that a cell reaches both: twice as many points. */
void testExtraPoints()
{
  TriangleSoup soup = gridPatch(8, 8);
  append(soup, gridPatch(8, 8), Point3(0, 0, 1e-6));
  const auto filter = remesherOf(polyDataOf(soup), 20);
  filter->SetAnisotropy(0.0);
  filter->PreserveFeaturesOff(); // which tell the sheets apart by their borders
  filter->MeasureDistanceOff();  // from borders that are not kept, by so few points
  checkWarning("two sheets", filter, "points more than asked for");
}

/** Two spheres, the inner one of this radius and turned inside out. */
TriangleSoup shellOf(double radius)
{
  TriangleSoup shell = icosphere(4);
  TriangleSoup inner = scaled(icosphere(4), radius);
  for (std::size_t t = 0; t < inner.triangles.size(); ++t)
  {
    flip(inner, t);
  }
  append(shell, inner, Point3::Zero());
  return shell;
}

vtkIdType factOf(vtkAnisotropicRemesher* filter, const char* name)
{
  const auto fact = arrayOf(filter->GetOutput()->GetFieldData(), name);
  return static_cast<vtkIdType>(fact->GetComponent(0, 0));
}

/** Sheets closer than the sagitta of their triangles, here and there or everywhere. */
void testStrays()
{
  for (const double radius : { 0.965, 0.99 })
  {
    const auto input = polyDataOf(shellOf(radius));
    const auto filter = remesherOf(input, 100);
    checkWarning("a thin shell", filter, "closer to another part");
    const vtkIdType strays = factOf(filter, "NumberOfStrayTriangles");
    const vtkIdType triangles = filter->GetOutput()->GetNumberOfPolys();
    CHECK(radius > 0.98 ? strays > triangles / 4 : strays > 0 && strays < triangles / 8);
    CHECK_EQUAL(factOf(filter, "NumberOfFlippedTriangles"), 0);
    // Triangles against the closest ones of the input: another way to count them.
    vtkNew<vtkSurfaceMeshComparison> comparison;
    comparison->SetInputData(filter->GetOutput());
    comparison->SetReferenceData(input);
    comparison->Update();
    CHECK_EQUAL(summaryOf(comparison, "NumberOfFlippedTriangles"), static_cast<double>(strays));
  }
}

/** Whether there are as many warnings as words, each beginning with its own. */
bool beginWith(const std::vector<std::string>& warnings, const std::vector<std::string>& words)
{
  return std::equal(warnings.begin(), warnings.end(), words.begin(), words.end(),
    [](const std::string& warning, const std::string& first)
    { return warning.compare(0, first.size(), first) == 0; });
}

/** Flipped triangles, strays and crossing pairs have a warning each, from one on. */
void testNumbersOfWrongTriangles()
{
  const auto warningsWith = [](Offset flipped, Offset strays, Offset crossings = 0)
  {
    RunOutcome outcome;
    outcome.result.dual.triangles.resize(1000); // of which few are wrong
    outcome.result.placement.edits.inverted = flipped;
    outcome.result.placement.strays = strays;
    outcome.result.placement.crossings = crossings;
    return warningsOf(RunRequest(), outcome);
  };
  CHECK(beginWith(warningsWith(0, 0), {}));
  CHECK(beginWith(warningsWith(12, 0), { "12 triangles face the surface the wrong way" }));
  CHECK(beginWith(warningsWith(0, 1),
    { "1 triangle is closer to another part of the surface than to its own, facing it" }));
  CHECK(beginWith(warningsWith(1, 3),
    { "1 triangle faces the surface the wrong way", "3 triangles are closer to another part" }));
  CHECK(beginWith(warningsWith(0, 0, 1), { "1 pair of triangles go through each other" }));
  CHECK(beginWith(warningsWith(0, 0, 50), { "50 pairs of triangles go through each other" }));
  CHECK(beginWith(warningsWith(0, 0, 51), { "At least 51 pairs of triangles" }));
  CHECK(beginWith(warningsWith(0, 2, 50), { "2 triangles are closer to another part" }));
}

/** A surface that goes through itself, between rims that all but touch; by too few points. */
void testFlipped()
{
  vtkNew<vtkParametricKuen> kuen;
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(kuen);
  source->SetUResolution(60);
  source->SetVResolution(60);
  source->Update();
  const auto input = vtkSmartPointer<vtkPolyData>::New();
  input->CopyStructure(source->GetOutput());
  const auto filter = remesherOf(input, 100);
  filter->SetAnisotropy(0.1);
  filter->MeasureDistanceOff();
  Messages messages(filter);
  filter->Update();
  const vtkIdType flipped = factOf(filter, "NumberOfFlippedTriangles");
  const vtkIdType strays = factOf(filter, "NumberOfStrayTriangles");
  CHECK(flipped > 0 && strays > 0);
  const auto& warnings = messages.warnings();
  const auto count = [&](vtkIdType number, const std::string& part)
  {
    return std::count_if(warnings.begin(), warnings.end(),
      [&](const std::string& warning)
      {
        return warning.find(std::to_string(number) + " triangle") != std::string::npos &&
          warning.find(part) != std::string::npos;
      });
  };
  CHECK_EQUAL(count(flipped, "the surface the wrong way. More points"), 1);
  CHECK_EQUAL(count(strays, "closer to another part of the surface"), 1);
}

/** A sphere with spikes that a few points cannot follow. */
TriangleSoup spikySphere()
{
  TriangleSoup spiky = icosphere(5);
  for (Point3& point : spiky.points)
  {
    const Point3 wave = (6.0 * point).array().sin();
    point *= 1.0 + 0.5 * wave.prod();
  }
  return spiky;
}

void testFarMesh()
{
  const auto filter = remesherOf(polyDataOf(spikySphere()), 20);
  filter->SetAnisotropy(0.0);
  checkWarning("a spiky sphere", filter, "Its 20 points are too few for the surface's bends");
  filter->MeasureDistanceOff();
  checkWarning("a spiky sphere, not measured", filter, "");
}

/** A surface with an embedding of its own, point by point. */
template <class Lift>
vtkSmartPointer<vtkAnisotropicRemesher> embeddedRemesher(
  const TriangleSoup& soup, vtkIdType points, const Lift& lift)
{
  vtkNew<vtkDoubleArray> embedding;
  embedding->SetName("Lifted");
  embedding->SetNumberOfComponents(3);
  for (const Point3& point : soup.points)
  {
    embedding->InsertNextTuple(Point3(lift(point)).data());
  }
  const auto input = polyDataOf(soup);
  input->GetPointData()->AddArray(embedding);
  const auto filter = remesherOf(input, points);
  filter->SetEmbeddingArray("Lifted");
  return filter;
}

/**
 * With an embedding that makes triangles 20 times as large on one side as on the other, or ten
 * times as long as wide, there is nothing to tell as long as the points do for the surface's bends.
 */
void testGivenEmbeddings()
{
  const auto invert = [](const Point3& point)
  {
    const Point3 way = point - Point3(0.0, 0.0, 1.25);
    return Point3(way / way.squaredNorm());
  };
  checkWarning("a graded sphere", embeddedRemesher(icosphere(5), 300, invert), "");
  const auto stretch = [](const Point3& point)
  { return Point3(point[0], point[1], 10.0 * point[2]); };
  checkWarning("a stretched sphere", embeddedRemesher(icosphere(5), 300, stretch), "");
  const auto same = [](const Point3& point) { return point; };
  checkWarning("a spiky sphere as it is", embeddedRemesher(spikySphere(), 20, same),
    "Its 20 points are too few where the given embedding is smallest");
}

/** Where features have most of the points, they are named. */
void testFarForFeatures()
{
  RunOutcome outcome;
  RemeshResult& mesh = outcome.result;
  mesh.placement.positions = { Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0), Point3(1, 1, 0) };
  mesh.dual.triangles = { { 0, 1, 2 }, { 1, 3, 2 } };
  mesh.components.sites = { 0, 1, 2, 3 };
  mesh.featureSites.points.resize(3);
  mesh.wantedVertices = 4;
  mesh.distance.emplace();
  const auto warningsAt = [&](double rms)
  {
    mesh.distance->forward.rms = rms;
    mesh.distance->backward.rms = rms;
    RunRequest request;
    request.options.numberOfSites = 4;
    return warningsOf(request, outcome);
  };
  CHECK(beginWith(warningsAt(0.06 * std::sqrt(2.0)), {}));
  const auto warnings = warningsAt(0.08 * std::sqrt(2.0));
  CHECK(
    beginWith(warnings, { "The mesh is far from the surface: the RMS distance is 0.11, 0.08" }));
  CHECK(!warnings.empty() && warnings[0].find("take 3 of its 4 points") != std::string::npos);
}

void testNothingToTell()
{
  checkWarning("a sphere", remesherOf(sphere(), 100), "");
}

/** Arrays of another length than the points, and ghost marks, are left out. */
void testUnfitArrays()
{
  const auto input = sphere();
  vtkNew<vtkDoubleArray> shortArray;
  shortArray->SetName("Short");
  shortArray->SetNumberOfValues(3);
  shortArray->Fill(1.0);
  input->GetPointData()->AddArray(shortArray);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(input->GetNumberOfPoints());
  ghosts->Fill(vtkDataSetAttributes::DUPLICATEPOINT);
  input->GetPointData()->AddArray(ghosts);
  const auto filter = remesherOf(input, 100);
  checkWarning("unfit arrays", filter, "for each point or cell: \"Short\".");
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 100);
  CHECK(!filter->GetOutput()->GetPointData()->HasArray("Short"));
  CHECK(!filter->GetOutput()->GetPointData()->HasArray(vtkDataSetAttributes::GhostArrayName()));
}

/** Sites embedded in another dimension are put on the surface, and that is told. */
void testSitesOfAnotherDimension()
{
  const auto six = remesherOf(sphere(), 50);
  six->Update();
  const auto three = remesherOf(sphere(), 50);
  three->SetEmbeddingMode(vtkAnisotropicRemesher::POSITION);
  three->SetInitialSitesData(six->GetSitesOutput());
  checkWarning("sites of another dimension", three, "has not the 3 components");
  CHECK_EQUAL(three->GetOutput()->GetNumberOfPoints(), 50);
}

/** Sites that are given are as many as they are, whatever the tolerance. */
void testToleranceWithSites()
{
  const auto first = remesherOf(sphere(), 50);
  first->Update();
  const auto filter = remesherOf(sphere(), 50);
  filter->SetInitialSitesData(first->GetSitesOutput());
  filter->SetDistanceTolerance(1e-3);
  checkWarning("a tolerance with sites", filter, "tolerance does not count");
}
}

int TestWarnings(int, char*[])
{
  testNothingToTell();
  testExtraPoints();
  testStrays();
  testNumbersOfWrongTriangles();
  testFlipped();
  testFarMesh();
  testGivenEmbeddings();
  testFarForFeatures();
  testUnfitArrays();
  testSitesOfAnotherDimension();
  testToleranceWithSites();
  return result();
}
