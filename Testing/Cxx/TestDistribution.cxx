// A filter that needs the whole surface says so where it is given a piece of it.

#include "TestHelpers.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkGaussMapEmbedding.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkRestrictedVoronoiDiagram.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSurfaceMeshComparison.h"

using namespace remesh;
using namespace remesh::test;

namespace
{
/** Asks for a piece; whether there is one warning, and that of a distributed surface. */
bool warnsOf(vtkAlgorithm* filter, int piece, int pieces, int port = 0)
{
  Messages messages(filter);
  vtkNew<vtkInformation> request;
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  request->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  request->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  request->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  vtkNew<vtkInformationVector> requests; // one for each port
  requests->SetNumberOfInformationObjects(port + 1);
  requests->SetInformationObject(port, request);
  filter->Update(port, requests);
  CHECK(messages.errors().empty() && messages.executiveErrors().empty());
  CHECK(messages.warnings().size() <= 1);
  const std::string text = messages.warnings().empty() ? "" : messages.warnings()[0];
  return text.find("distributed over " + std::to_string(pieces) + " processes") !=
    std::string::npos;
}

/** The input is a piece that a reader of many processes has read: not empty, whatever its number.
 */
void testPieces(vtkAlgorithm* filter)
{
  vtkNew<vtkPolyData> empty;
  filter->SetInputDataObject(0, polyDataOf(icosphere(2)));
  CHECK(!warnsOf(filter, 0, 1));
  CHECK(!warnsOf(filter, 0, 2)); // a serial reader puts all there
  CHECK(warnsOf(filter, 1, 2));
  CHECK(warnsOf(filter, 2, 3));
  CHECK(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT) > 0);
  for (int port = 1; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    filter->Modified();
    CHECK(warnsOf(filter, 1, 2, port));
  }
  filter->SetInputDataObject(0, empty);
  if (!vtkSurfaceMeshComparison::SafeDownCast(filter)) // its reference is a piece as well
  {
    CHECK(!warnsOf(filter, 1, 2));
  }
}
}

int TestDistribution(int, char*[])
{
  vtkNew<vtkAnisotropicRemesher> remesher;
  remesher->SetNumberOfPoints(50);
  testPieces(remesher);
  vtkNew<vtkRestrictedVoronoiDiagram> diagram;
  diagram->SetSitesData(polyDataOf(icosphere(1)));
  testPieces(diagram);
  vtkNew<vtkGaussMapEmbedding> embedding;
  testPieces(embedding);
  vtkNew<vtkSurfaceMeshComparison> comparison;
  comparison->SetReferenceData(polyDataOf(icosphere(3)));
  comparison->SetNumberOfSamples(1000);
  testPieces(comparison);
  vtkNew<vtkPolyData> empty; // the mesh is on one process, its reference is not
  comparison->SetInputData(empty);
  CHECK(!warnsOf(comparison, 0, 2));
  CHECK(warnsOf(comparison, 1, 2));
  return result();
}
