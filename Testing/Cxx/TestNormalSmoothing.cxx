// Over which distance estimated normals are smoothed: farther where cells would fall apart, and the
// same for other filters that are told.

#include "TestMeasures.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkRestrictedVoronoiDiagram.h"

#include <cmath>

using namespace remesh;
using namespace remesh::test;

namespace
{
constexpr vtkIdType points = 1500;

/** Bumps wide enough to survive the usual smoothing, at high anisotropy too many for the cells. */
vtkSmartPointer<vtkPolyData> bumpyPlate()
{
  TriangleSoup soup = gridPatch(100, 100);
  for (Point3& p : soup.points)
  {
    p[2] = 0.08 * std::sin(20.0 * p[0]) * std::sin(20.0 * p[1]);
  }
  return polyDataOf(soup);
}

vtkSmartPointer<vtkAnisotropicRemesher> remesherOf(vtkPolyData* surface, double anisotropy)
{
  auto remesher = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  remesher->SetInputData(surface);
  remesher->SetNumberOfPoints(points);
  remesher->SetAnisotropy(anisotropy);
  remesher->SetNumberOfNewtonIterations(10);
  remesher->MeasureDistanceOff();
  return remesher;
}

/** The radius in the mesh's field data, over the usual one; 1 if there is none. */
double radiusOf(vtkAnisotropicRemesher* remesher, vtkPolyData* surface)
{
  remesher->Update();
  vtkDataArray* radius = remesher->GetOutput()->GetFieldData()->GetArray("NormalSmoothingRadius");
  const double usual = 1.5 * std::sqrt(areaOf(surface) / static_cast<double>(points));
  return radius ? radius->GetComponent(0, 0) / usual : 1.0;
}

/** Twice and four times as far; no farther than needed, nor where it is not asked for. */
void testWidening(vtkPolyData* surface)
{
  CHECK_EQUAL(radiusOf(remesherOf(surface, 0.04), surface), 1.0);
  const auto twice = remesherOf(surface, 0.5);
  CHECK_NEAR(radiusOf(twice, surface), 2.0, 1e-12);
  CHECK_NEAR(radiusOf(remesherOf(surface, 1.0), surface), 4.0, 1e-12);

  const auto noIterations = remesherOf(surface, 0.5);
  noIterations->SetNumberOfLloydIterations(0);
  noIterations->SetNumberOfNewtonIterations(0);
  CHECK_EQUAL(radiusOf(noIterations, surface), 1.0);
  const auto goesOn = remesherOf(surface, 0.5);
  goesOn->SetInitialSitesData(twice->GetSitesOutput());
  CHECK_EQUAL(radiusOf(goesOn, surface), 1.0);
  const auto passes = remesherOf(surface, 0.5);
  passes->SetNormalSmoothingPasses(3);
  CHECK_EQUAL(radiusOf(passes, surface), 1.0);
}

/** The same run with the radius given, and the same diagram of its sites. */
void testGivenRadius(vtkPolyData* surface)
{
  const auto remesher = remesherOf(surface, 0.5);
  remesher->PreserveFeaturesOff();
  CHECK(radiusOf(remesher, surface) > 1.5);
  const double radius =
    remesher->GetOutput()->GetFieldData()->GetArray("NormalSmoothingRadius")->GetComponent(0, 0);
  const auto given = remesherOf(surface, 0.5);
  given->PreserveFeaturesOff();
  given->SetNormalSmoothingRadius(radius);
  given->Update();
  const vtkIdType count = remesher->GetOutput()->GetNumberOfPoints();
  CHECK_EQUAL(given->GetOutput()->GetNumberOfPoints(), count);
  for (vtkIdType k = 0; k < count; ++k)
  {
    CHECK(pointOf(given->GetOutput(), k) == pointOf(remesher->GetOutput(), k));
  }
  CHECK(given->GetNumberOfEvaluations() < remesher->GetNumberOfEvaluations());

  vtkNew<vtkRestrictedVoronoiDiagram> diagram;
  diagram->SetInputData(surface);
  diagram->SetInputData(1, remesher->GetSitesOutput());
  diagram->SetAnisotropy(0.5);
  diagram->SetNormalSmoothingRadius(radius);
  diagram->Update();
  CHECK_NEAR(diagram->GetEnergy(), remesher->GetEnergy(), 1e-12 * remesher->GetEnergy());
}
}

int TestNormalSmoothing(int, char*[])
{
  const auto surface = bumpyPlate();
  testWidening(surface);
  testGivenRadius(surface);
  return result();
}
