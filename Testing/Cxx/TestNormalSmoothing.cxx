// Over which distance estimated normals are smoothed: farther where cells would fall apart, not at
// all where that flattens bends along one direction alone, and the same for other filters that are
// told. Needles are left out.

#include "TestMeasures.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkRestrictedVoronoiDiagram.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"

#include <algorithm>
#include <cmath>

using namespace remesh;
using namespace remesh::test;

namespace
{
constexpr vtkIdType points = 1500;

double usualRadius(vtkPolyData* surface, vtkIdType number)
{
  return 1.5 * std::sqrt(areaOf(surface) / static_cast<double>(number));
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

/** The radius in the mesh's field data, -1 if there is none. */
double radiusOf(vtkAnisotropicRemesher* remesher)
{
  remesher->Update();
  vtkDataArray* radius = remesher->GetOutput()->GetFieldData()->GetArray("NormalSmoothingRadius");
  return radius ? radius->GetComponent(0, 0) : -1.0;
}

void checkSamePoints(vtkPolyData* mesh, vtkPolyData* expected)
{
  CHECK_EQUAL(mesh->GetNumberOfPoints(), expected->GetNumberOfPoints());
  for (vtkIdType k = 0; k < std::min(mesh->GetNumberOfPoints(), expected->GetNumberOfPoints()); ++k)
  {
    CHECK(pointOf(mesh, k) == pointOf(expected, k));
  }
}

/** Twice and four times as far; no farther than needed, nor where it is not asked for. */
void testWidening(vtkPolyData* surface)
{
  const double usual = usualRadius(surface, points);
  CHECK_NEAR(radiusOf(remesherOf(surface, 0.04)), usual, 1e-6 * usual);
  const auto twice = remesherOf(surface, 0.5);
  CHECK_NEAR(radiusOf(twice), 2.0 * usual, 1e-6 * usual);
  CHECK_NEAR(radiusOf(remesherOf(surface, 1.0)), 4.0 * usual, 1e-6 * usual);

  const auto noIterations = remesherOf(surface, 0.5);
  noIterations->SetNumberOfLloydIterations(0);
  noIterations->SetNumberOfNewtonIterations(0);
  CHECK_NEAR(radiusOf(noIterations), usual, 1e-6 * usual);
  const auto goesOn = remesherOf(surface, 0.5);
  goesOn->SetInitialSitesData(twice->GetSitesOutput());
  const vtkIdType given = twice->GetSitesOutput()->GetNumberOfPoints();
  CHECK_NEAR(radiusOf(goesOn), usualRadius(surface, given), 1e-6 * usual);
  const auto passes = remesherOf(surface, 0.5);
  passes->SetNormalSmoothingPasses(3);
  CHECK_EQUAL(radiusOf(passes), -1.0);
}

/** The same run with the radius given, and the same diagram of its sites. */
void testGivenRadius(vtkPolyData* surface)
{
  const auto remesher = remesherOf(surface, 0.5);
  remesher->PreserveFeaturesOff();
  const double radius = radiusOf(remesher);
  CHECK(radius > 0.0);
  const auto given = remesherOf(surface, 0.5);
  given->PreserveFeaturesOff();
  given->SetNormalSmoothingRadius(radius);
  CHECK_EQUAL(radiusOf(given), radius);
  checkSamePoints(given->GetOutput(), remesher->GetOutput());
  CHECK(given->GetNumberOfEvaluations() < remesher->GetNumberOfEvaluations());

  vtkNew<vtkRestrictedVoronoiDiagram> diagram;
  diagram->SetInputData(surface);
  diagram->SetInputData(1, remesher->GetSitesOutput());
  diagram->SetAnisotropy(0.5);
  diagram->SetNormalSmoothingRadius(radius);
  diagram->Update();
  CHECK_NEAR(diagram->GetEnergy(), remesher->GetEnergy(), 1e-12 * remesher->GetEnergy());
}

/** Far too few points: no radius helps. All are tried, and the best mesh is kept. */
void testHopeless()
{
  const auto surface = bumpyPlate(60, 0.08, 40.0);
  const auto wide = remesherOf(surface, 1.0);
  wide->SetNumberOfPoints(500);
  const double radius = radiusOf(wide);
  CHECK(radius > 1.5 * usualRadius(surface, 500));
  const auto given = remesherOf(surface, 1.0);
  given->SetNumberOfPoints(500);
  given->SetNormalSmoothingRadius(radius);
  CHECK_EQUAL(radiusOf(given), radius);
  checkSamePoints(given->GetOutput(), wide->GetOutput());

  vtkNew<vtkIntArray> squares; // of 10 x 10 each: borders between them need all the points
  squares->SetName("Square");
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    squares->InsertNextValue(static_cast<int>(cell / 1200 * 6 + cell / 2 % 60 / 10));
  }
  surface->GetCellData()->AddArray(squares);
  const auto usual = remesherOf(surface, 1.0);
  usual->SetFeatureLabelArray("Square");
  usual->SetNumberOfPoints(220);
  CHECK_NEAR(radiusOf(usual), usualRadius(surface, 220), 1e-6);
  given->SetFeatureLabelArray("Square");
  given->SetNumberOfPoints(220);
  int alone = 0; // evaluations of the runs that are compared, without those that only try
  for (const double widening : { 1.0, 2.0 })
  {
    given->SetNormalSmoothingRadius(widening * usualRadius(surface, 220));
    given->Update();
    alone += given->GetNumberOfEvaluations();
  }
  CHECK(usual->GetNumberOfEvaluations() > alone);
}

/** Waves too high for the points: as soon as cells fall apart, the normals are smoothed after all.
 */
void testSmoothedAfterAll()
{
  const auto waves = wavyPlate(120, 0.0, 0.0);
  const auto meshOf = [&](double radius)
  {
    const auto remesher = remesherOf(waves, 0.5);
    remesher->SetNumberOfPoints(200);
    remesher->SetNormalSmoothingRadius(radius);
    remesher->Update();
    return remesher;
  };
  const auto chosen = meshOf(-1.0);
  const double radius = radiusOf(chosen);
  CHECK_NEAR(radius, usualRadius(waves, 200), 1e-6);
  const auto smoothed = meshOf(radius);
  checkSamePoints(chosen->GetOutput(), smoothed->GetOutput());
  const int before = chosen->GetNumberOfEvaluations() - smoothed->GetNumberOfEvaluations();
  CHECK(before > 0);
  CHECK(before < meshOf(0.0)->GetNumberOfEvaluations()); // of a finished mesh
}

/** Waves are kept that smoothing would flatten, and the mesh is closer for it. */
void testSharp()
{
  const auto meshOf = [&](vtkPolyData* surface, double radius)
  {
    const auto remesher = remesherOf(surface, 0.1);
    remesher->SetNumberOfPoints(600);
    remesher->MeasureDistanceOn();
    remesher->SetNormalSmoothingRadius(radius);
    return remesher;
  };
  const auto distanceOf = [](vtkAnisotropicRemesher* remesher)
  {
    remesher->Update();
    return remesher->GetOutput()->GetFieldData()->GetArray("RMSDistance")->GetComponent(0, 0);
  };
  // However the triangles lie to them.
  for (const auto& [angle, most] :
    { std::pair(0.0, 0.7), std::pair(0.4, 0.8), std::pair(0.8, 0.8) })
  {
    const auto waves = wavyPlate(120, angle, 0.0);
    const auto sharp = meshOf(waves, -1.0);
    CHECK_EQUAL(radiusOf(sharp), 0.0);
    const auto given = meshOf(waves, 0.0);
    CHECK_EQUAL(radiusOf(given), 0.0);
    checkSamePoints(given->GetOutput(), sharp->GetOutput());
    CHECK(distanceOf(sharp) < most * distanceOf(meshOf(waves, usualRadius(waves, 600))));
  }
  const auto rippled = wavyPlate(120, 0.0, 0.004);
  const double smoothed = usualRadius(rippled, 600);
  CHECK_NEAR(radiusOf(meshOf(rippled, -1.0)), smoothed, 1e-6 * smoothed);
}

/** A needle's normal is not among the estimated ones, but where no features are looked for. */
void testNeedle()
{
  const auto minNormal = [](bool preserveFeatures)
  {
    const auto remesher = remesherOf(polyDataOf(patchWithFlap()), 0.02);
    remesher->SetNumberOfPoints(100);
    remesher->SetNormalSmoothingPasses(0);
    remesher->SetPreserveFeatures(preserveFeatures);
    remesher->Update();
    vtkDataArray* normals = remesher->GetOutput()->GetPointData()->GetNormals();
    double least = 1.0;
    for (vtkIdType k = 0; k < normals->GetNumberOfTuples(); ++k)
    {
      least = std::min(least, normals->GetComponent(k, 2));
    }
    return least;
  };
  CHECK(minNormal(true) > 0.999);
  CHECK(minNormal(false) < 0.99);
}
}

int TestNormalSmoothing(int, char*[])
{
  // Wide enough to survive the usual smoothing, at high anisotropy too many for the cells.
  const auto surface = bumpyPlate(100, 0.08, 20.0);
  testWidening(surface);
  testGivenRadius(surface);
  testHopeless();
  testSharp();
  testSmoothedAfterAll();
  testNeedle();
  return result();
}
