// What becomes of the arrays of a mesh and its reference in the comparison.

#include "TestHelpers.h"

#include "vtkSurfaceMeshComparison.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"

using namespace remesh;
using namespace remesh::test;

namespace
{
vtkSmartPointer<vtkSurfaceMeshComparison> compare(vtkPolyData* mesh, vtkPolyData* reference)
{
  auto filter = vtkSmartPointer<vtkSurfaceMeshComparison>::New();
  filter->SetInputData(mesh);
  if (reference)
  {
    filter->SetReferenceData(reference);
  }
  filter->SetNumberOfSamples(1000);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty() && messages.warnings().empty());
  return filter;
}

/** 100, 101 and so on. */
vtkSmartPointer<vtkIdTypeArray> count(const char* name, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName(name);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    array->InsertNextValue(100 + i);
  }
  return array;
}

/** Results of another comparison are not those of this one, and the input keeps them. */
void testEarlierResults()
{
  const auto first = compare(polyDataOf(icosphere(2)), polyDataOf(icosphere(3)));
  vtkPolyData* mesh = first->GetOutput();
  CHECK(mesh->GetCellData()->HasArray("Flipped") && mesh->GetPointData()->HasArray("Distance"));
  mesh->GetCellData()->AddArray(count("Mine", mesh->GetNumberOfCells()));
  const int numberOfArrays = mesh->GetCellData()->GetNumberOfArrays();
  const auto alone = compare(mesh, nullptr);
  vtkCellData* cells = alone->GetOutput()->GetCellData();
  vtkPointData* points = alone->GetOutput()->GetPointData();
  CHECK(!cells->HasArray("NormalDeviation") && !cells->HasArray("Flipped"));
  CHECK(!points->HasArray("Distance") && !points->HasArray("SignedDistance"));
  CHECK(cells->HasArray("Quality") && cells->HasArray("Mine"));
  CHECK_EQUAL(mesh->GetCellData()->GetNumberOfArrays(), numberOfArrays);
  CHECK(mesh->GetPointData()->HasArray("SignedDistance"));

  // Against a mesh with a triangle turned over there are no signs.
  TriangleSoup turned = icosphere(3);
  flip(turned, 7);
  const auto unsided = compare(mesh, polyDataOf(turned));
  CHECK(!unsided->GetOutput()->GetPointData()->HasArray("SignedDistance"));
  const auto asReference = compare(polyDataOf(turned), mesh);
  CHECK(asReference->GetReferenceOutput()->GetPointData()->HasArray("Distance"));
  CHECK(!asReference->GetReferenceOutput()->GetPointData()->HasArray("SignedDistance"));
}
}

int TestComparisonArrays(int, char*[])
{
  testEarlierResults();
  return result();
}
