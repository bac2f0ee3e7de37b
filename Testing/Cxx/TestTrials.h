/**
 * @file TestTrials.h
 * @brief Makes a mesh and checks what every mesh must keep of its surface.
 */
#ifndef TestTrials_h
#define TestTrials_h

#include "TestHelpers.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkSurfaceMeshComparison.h"
#include "vtkTable.h"

#include <string>

namespace remesh::test
{
/** A mesh and how it compares with its surface. */
struct Trial
{
  vtkSmartPointer<vtkPolyData> mesh;
  vtkSmartPointer<vtkSurfaceMeshComparison> comparison;

  double value(const std::string& column) const
  {
    vtkDataArray* array = vtkDataArray::SafeDownCast(
      this->comparison->GetSummaryOutput()->GetColumnByName(column.c_str()));
    CHECK(array != nullptr);
    return array ? array->GetComponent(0, 0) : 0.0;
  }
};

/**
 * What every mesh must keep: topology, the number of points, and the side it faces.
 *
 * @param mayWarn of features that need more than half of the points.
 */
inline Trial keepingMesh(
  vtkPolyData* surface, vtkIdType points, double anisotropy, bool mayWarn = false)
{
  auto remesher = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  remesher->SetInputData(surface);
  remesher->SetNumberOfPoints(points);
  remesher->SetAnisotropy(anisotropy);
  Messages messages(remesher);
  remesher->Update();
  CHECK(messages.errors().empty() && (mayWarn || messages.warnings().empty()));
  Trial trial{ remesher->GetOutput(), vtkSmartPointer<vtkSurfaceMeshComparison>::New() };
  trial.comparison->SetInputData(trial.mesh);
  trial.comparison->SetReferenceData(surface);
  trial.comparison->SetNumberOfSamples(20000);
  trial.comparison->BoundMaximumDistanceOff();
  trial.comparison->Update();
  CHECK_EQUAL(trial.mesh->GetNumberOfPoints(), points);
  CHECK_EQUAL(trial.value("NumberOfFlippedTriangles"), 0.0);
  for (const char* kept : { "EulerCharacteristic", "NumberOfComponents", "NumberOfBoundaryLoops" })
  {
    CHECK_EQUAL(trial.value(kept), trial.value(std::string("Reference") + kept));
  }
  return trial;
}
}

#endif
