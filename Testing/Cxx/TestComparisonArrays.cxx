// What becomes of the arrays of a mesh and its reference in the comparison.

#include "TestHelpers.h"

#include "vtkSurfaceMeshComparison.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"

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

/** As many cells as triangles, and all polygons triangles, but a vertex and a strip of two. */
void testVertexAndStrip()
{
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(polyDataOf(gridPatch(3, 1))->GetPoints());
  vtkNew<vtkCellArray> vertices, polygons, strips;
  vertices->InsertNextCell({ 0 });
  polygons->InsertNextCell({ 0, 1, 5 });
  polygons->InsertNextCell({ 0, 5, 4 });
  strips->InsertNextCell({ 5, 1, 6, 2 });
  mesh->SetVerts(vertices);
  mesh->SetPolys(polygons);
  mesh->SetStrips(strips);
  mesh->GetCellData()->AddArray(count("Cell", 4));
  const auto filter = compare(mesh, nullptr);
  vtkPolyData* output = filter->GetOutput();
  CHECK_EQUAL(output->GetNumberOfVerts(), 0);
  CHECK_EQUAL(output->GetNumberOfStrips(), 0);
  CHECK_EQUAL(output->GetNumberOfPolys(), 4);
  const auto cells = arrayOf(output->GetCellData(), "Cell");
  const double expected[] = { 101.0, 102.0, 103.0, 103.0 };
  for (vtkIdType t = 0; t < 4; ++t)
  {
    CHECK_EQUAL(cells->GetComponent(t, 0), expected[t]);
  }
}

/** Cut cells: arrays that are too short or too long are left out, and ids that would repeat. */
void testCutCells()
{
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(polyDataOf(gridPatch(2, 1))->GetPoints());
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 4, 3 });
  polygons->InsertNextCell({ 1, 2, 5 });
  mesh->SetPolys(polygons);
  vtkCellData* data = mesh->GetCellData();
  for (const auto& [name, tuples] :
    { std::pair("Short", 1), std::pair("Long", 3), std::pair("Empty", 0), std::pair("Fit", 2) })
  {
    data->AddArray(count(name, tuples));
  }
  data->AddArray(count("Global", 2));
  data->SetActiveGlobalIds("Global");
  const auto filter = compare(mesh, nullptr);
  vtkCellData* cells = filter->GetOutput()->GetCellData();
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPolys(), 3);
  CHECK_EQUAL(arrayOf(cells, "Fit")->GetComponent(1, 0), 100.0);
  for (const char* name : { "Short", "Long", "Empty", "Global" })
  {
    check(!cells->HasArray(name), __FILE__, __LINE__, std::string("carried: ") + name);
  }
  CHECK(cells->GetGlobalIds() == nullptr);
  CHECK(data->GetGlobalIds() != nullptr && data->HasArray("Short"));

  // No cell is cut where only a line is left out: ids stay.
  vtkNew<vtkCellArray> triangle, lines;
  triangle->InsertNextCell({ 0, 1, 4 });
  lines->InsertNextCell({ 0, 1 });
  mesh->SetPolys(triangle);
  mesh->SetLines(lines);
  const auto uncut = compare(mesh, nullptr);
  vtkDataArray* ids = uncut->GetOutput()->GetCellData()->GetGlobalIds();
  CHECK(ids != nullptr && ids->GetComponent(0, 0) == 101.0);
}

/** Ghost cells are not on port 0; on port 1 they are as they came. */
void testGhosts()
{
  const auto surface = polyDataOf(gridPatch(2, 1));
  surface->AllocateCellGhostArray();
  surface->GetCellGhostArray()->SetValue(1, vtkDataSetAttributes::DUPLICATECELL);
  const auto filter = compare(surface, surface);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), surface->GetNumberOfCells() - 1);
  CHECK_EQUAL(filter->GetReferenceOutput()->GetNumberOfCells(), surface->GetNumberOfCells());
  CHECK(filter->GetReferenceOutput()->GetCellGhostArray() != nullptr);
}
}

int TestComparisonArrays(int, char*[])
{
  testEarlierResults();
  testVertexAndStrip();
  testCutCells();
  testGhosts();
  return result();
}
