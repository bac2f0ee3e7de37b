// What only a picture shows: the mesh on the left, its Voronoi cells on the right.

#include "TestMeasures.h"

#include "vtkActor.h"
#include "vtkAnisotropicRemesher.h"
#include "vtkCamera.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

using namespace remesh::test;

namespace
{
/** One of a few light colours for each site. */
void colourBySite(vtkPolyData* cells)
{
  const unsigned char palette[7][3] = { { 228, 150, 140 }, { 150, 190, 230 }, { 170, 220, 160 },
    { 235, 215, 140 }, { 200, 170, 220 }, { 240, 180, 110 }, { 160, 215, 215 } };
  const auto sites = arrayOf(cells->GetCellData(), "SiteId");
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    colours->InsertNextTypedTuple(palette[static_cast<int>(sites->GetComponent(cell, 0)) % 7]);
  }
  cells->GetCellData()->SetScalars(colours);
}

vtkSmartPointer<vtkActor> makeActor(vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.4);
  actor->GetProperty()->SetDiffuse(0.6);
  return actor;
}
}

int TestRemesherImage(int argc, char* argv[])
{
  remesh::TriangleSoup soup = torus(1.0, 0.4, 120, 60);
  for (remesh::Point3& point : soup.points)
  {
    point[2] *= 1.5;
  }
  vtkNew<vtkAnisotropicRemesher> remesher;
  remesher->SetInputData(polyDataOf(soup));
  remesher->SetNumberOfPoints(500);
  remesher->SetAnisotropy(0.1);
  remesher->SetNumberOfLloydIterations(20);
  remesher->SetNumberOfNewtonIterations(20);
  remesher->Update();
  CHECK(isClosedManifold(remesher->GetOutput()));

  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(remesher->GetOutput());
  mesh->GetPointData()->SetNormals(nullptr); // flat triangles
  const auto meshActor = makeActor(mesh);
  meshActor->GetProperty()->SetColor(0.75, 0.82, 0.9);
  meshActor->GetProperty()->EdgeVisibilityOn();
  meshActor->GetProperty()->SetEdgeColor(0.1, 0.1, 0.3);

  vtkNew<vtkPolyData> cells;
  cells->ShallowCopy(remesher->GetVoronoiCellsOutput());
  colourBySite(cells);
  const auto cellActor = makeActor(cells);
  const auto edgeActor = makeActor(remesher->GetEdgesOutput());
  edgeActor->GetMapper()->ScalarVisibilityOff();
  edgeActor->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -20.0);
  edgeActor->GetProperty()->SetColor(0.1, 0.1, 0.3);
  edgeActor->GetProperty()->LightingOff();

  vtkNew<vtkRenderer> left;
  left->SetViewport(0.0, 0.0, 0.5, 1.0);
  left->AddActor(meshActor);
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  right->AddActor(cellActor);
  right->AddActor(edgeActor);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(480, 240);
  window->SetMultiSamples(0);
  for (vtkRenderer* renderer : { left.Get(), right.Get() })
  {
    renderer->SetBackground(1.0, 1.0, 1.0);
    window->AddRenderer(renderer);
    renderer->GetActiveCamera()->SetPosition(0.0, -4.0, 3.5);
    renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
    renderer->ResetCamera();
    renderer->GetActiveCamera()->Zoom(1.35);
  }
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  window->Render();

  const int compared = vtkRegressionTestImageThreshold(window, 25.0);
  if (compared == vtkRegressionTester::DO_INTERACTOR)
  {
    interactor->Start();
  }
  CHECK(compared != vtkRegressionTester::FAILED);
  return result();
}
