#include "vtkAnisotropicRemesher.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);

  vtkNew<vtkAnisotropicRemesher> remesher;
  remesher->SetInputConnection(sphere->GetOutputPort());
  remesher->SetNumberOfPoints(200);
  remesher->SetNumberOfLloydIterations(5);
  remesher->Update();

  // 200 points on a sphere: V - E + F = 2 and 3 F = 2 E.
  const vtkIdType points = remesher->GetOutput()->GetNumberOfPoints();
  const vtkIdType triangles = remesher->GetOutput()->GetNumberOfCells();
  std::cout << points << " points, " << triangles << " triangles" << std::endl;
  return points == 200 && triangles == 396 ? EXIT_SUCCESS : EXIT_FAILURE;
}
