/**
 * pipeline INPUT.ply OUTPUT.vtp [POINTS]: reads a surface, remeshes it, tells how good the mesh is,
 * and writes it.
 */
#include <vtkAnisotropicRemesher.h>
#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSurfaceMeshComparison.h>
#include <vtkTable.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <iostream>

namespace
{
void showProgress(vtkObject* caller, unsigned long, void*, void*)
{
  auto* remesher = vtkAnisotropicRemesher::SafeDownCast(caller);
  std::cerr << "\r" << static_cast<int>(100.0 * remesher->GetProgress()) << " %" << std::flush;
}
}

int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::cerr << "pipeline INPUT.ply OUTPUT.vtp [POINTS]\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(argv[1]);

  vtkNew<vtkAnisotropicRemesher> remesher;
  remesher->SetInputConnection(reader->GetOutputPort());
  remesher->SetNumberOfPoints(argc > 3 ? std::atoi(argv[3]) : 2000);
  remesher->SetAnisotropy(0.05);

  vtkNew<vtkCallbackCommand> progress;
  progress->SetCallback(showProgress);
  remesher->AddObserver(vtkCommand::ProgressEvent, progress);

  // How many threads all filters may use in what follows: 0 stands for all.
  const vtkSMPTools::Config threads{ 0, "STDThread", false };
  vtkSMPTools::LocalScope(threads, [&] { remesher->Update(); });
  if (remesher->GetOutput()->GetNumberOfPolys() == 0)
  {
    return EXIT_FAILURE; // why was told
  }

  vtkNew<vtkSurfaceMeshComparison> comparison;
  comparison->SetInputConnection(remesher->GetOutputPort());
  comparison->SetReferenceConnection(reader->GetOutputPort());
  comparison->Update();
  std::cout << "\n"
            << remesher->GetOutput()->GetNumberOfPoints() << " points, RMS distance "
            << comparison->GetSummaryOutput()->GetValueByName(0, "RMSDistance").ToDouble()
            << ", with " << remesher->GetNumberOfUsedThreads() << " threads\n";

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(remesher->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
