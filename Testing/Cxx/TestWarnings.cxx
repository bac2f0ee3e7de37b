// What is degraded or does not fit is told once, and does no harm.

#include "TestHelpers.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricKuen.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

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
vtkSmartPointer<vtkPolyData> shellOf(double radius)
{
  TriangleSoup shell = icosphere(4);
  TriangleSoup inner = scaled(icosphere(4), radius);
  for (std::size_t t = 0; t < inner.triangles.size(); ++t)
  {
    flip(inner, t);
  }
  append(shell, inner, Point3::Zero());
  return polyDataOf(shell);
}

vtkIdType factOf(vtkAnisotropicRemesher* filter, const char* name)
{
  const auto fact = arrayOf(filter->GetOutput()->GetFieldData(), name);
  return static_cast<vtkIdType>(fact->GetComponent(0, 0));
}

/** Sheets closer to each other than the sagitta of their triangles, everywhere or here and there.
 */
void testStrays()
{
  for (const double radius : { 0.97, 0.99 })
  {
    const auto filter = remesherOf(shellOf(radius), 100);
    checkWarning("a thin shell", filter, "closer to another part");
    const vtkIdType strays = factOf(filter, "NumberOfStrayTriangles");
    const vtkIdType triangles = filter->GetOutput()->GetNumberOfPolys();
    CHECK(radius > 0.98 ? strays > triangles / 4 : strays > 0 && strays < triangles / 8);
    filter->Modified();
    checkWarning("again", filter, std::to_string(strays) + " triangles are closer");
  }
}

/** A surface that goes through itself, between rims that all but touch. */
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
  const auto filter = remesherOf(input, 2000);
  Messages messages(filter);
  filter->Update();
  const vtkIdType flipped = factOf(filter, "NumberOfFlippedTriangles");
  const vtkIdType strays = factOf(filter, "NumberOfStrayTriangles");
  CHECK(flipped > 0);
  CHECK_EQUAL(messages.warnings().size(), std::size_t(strays > 0 ? 2 : 1));
  CHECK(
    messages.warnings()[0].find(" " + std::to_string(flipped) + " triangle") != std::string::npos);
  CHECK(strays == 0 ||
    messages.warnings()[1].find(" " + std::to_string(strays) + " triangle") != std::string::npos);
}

/** A sphere with spikes that a few points cannot follow. */
void testFarMesh()
{
  TriangleSoup spiky = icosphere(5);
  for (Point3& point : spiky.points)
  {
    const Point3 wave = (6.0 * point).array().sin();
    point *= 1.0 + 0.5 * wave.prod();
  }
  const auto filter = remesherOf(polyDataOf(spiky), 30);
  filter->SetAnisotropy(0.0);
  checkWarning("a spiky sphere", filter, "The mesh is far from the surface");
  filter->MeasureDistanceOff();
  checkWarning("a spiky sphere, not measured", filter, "");
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
  testFlipped();
  testFarMesh();
  testUnfitArrays();
  testSitesOfAnotherDimension();
  testToleranceWithSites();
  return result();
}
