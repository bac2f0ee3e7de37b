/**
 * The shortest use of the library: a surface, the remesher, a file.
 */
#include <vtkAnisotropicRemesher.h>
#include <vtkNew.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricSuperEllipsoid.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  vtkNew<vtkParametricSuperEllipsoid> shape;
  shape->SetXRadius(3.0);
  shape->SetN1(0.6);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(shape);
  source->SetUResolution(150);
  source->SetVResolution(150);

  vtkNew<vtkAnisotropicRemesher> remesher;
  remesher->SetInputConnection(source->GetOutputPort());
  remesher->SetNumberOfPoints(2000);
  remesher->SetAnisotropy(0.05);

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(remesher->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : "remeshed.vtp");
  writer->SetDataModeToBinary();
  writer->Write(); // returns 1 even for a file that it cannot open
  if (writer->GetErrorCode() != 0 || remesher->GetOutput()->GetNumberOfPolys() == 0)
  {
    return EXIT_FAILURE;
  }
  std::cout << remesher->GetOutput()->GetNumberOfPoints() << " points, "
            << remesher->GetOutput()->GetNumberOfPolys() << " triangles\n";
  return EXIT_SUCCESS;
}
