/**
 * @file TestTrials.h
 * @brief Makes a mesh and checks what every mesh must keep of its surface.
 */
#ifndef TestTrials_h
#define TestTrials_h

#include "TestHelpers.h"
#include "TestIntersections.h"

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
 * @param warning words of the one warning that is right; nullptr: there is to be none.
 */
inline Trial keepingMesh(
  vtkPolyData* surface, vtkIdType points, double anisotropy, const char* warning = nullptr)
{
  auto remesher = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  remesher->SetInputData(surface);
  remesher->SetNumberOfPoints(points);
  remesher->SetAnisotropy(anisotropy);
  Messages messages(remesher);
  remesher->Update();
  CHECK(messages.errors().empty());
  const std::vector<std::string>& warnings = messages.warnings();
  CHECK_EQUAL(warnings.size(), warning ? std::size_t(1) : std::size_t(0));
  CHECK(!warning || warnings.empty() || warnings[0].find(warning) != std::string::npos);
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
  const double nonManifold = trial.value("NumberOfNonManifoldEdges");
  CHECK_EQUAL(nonManifold > 0.0, trial.value("ReferenceNumberOfNonManifoldEdges") > 0.0);
  const auto fact = [&](const char* name)
  { return arrayOf(trial.mesh->GetFieldData(), name)->GetComponent(0, 0); };
  CHECK_EQUAL(fact("NumberOfNonManifoldEdges"), nonManifold);
  CHECK_EQUAL(fact("NumberOfFlippedTriangles"), 0.0);
  CHECK_EQUAL(fact("NumberOfStrayTriangles"), 0.0);
  CHECK_EQUAL(fact("TopologyPreserved"), nonManifold > 0.0 ? 0.0 : 1.0);
  return trial;
}

/** One that does not go through itself, either. */
inline Trial checkedMesh(vtkPolyData* surface, vtkIdType points, double anisotropy)
{
  const Trial trial = keepingMesh(surface, points, anisotropy);
  CHECK_EQUAL(numberOfSelfIntersections(trial.mesh), 0);
  CHECK_EQUAL(
    arrayOf(trial.mesh->GetFieldData(), "NumberOfSelfIntersections")->GetComponent(0, 0), 0.0);
  return trial;
}
}

#endif
