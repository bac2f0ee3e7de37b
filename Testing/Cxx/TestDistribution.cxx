// A filter that needs the whole surface says so where it is given a piece of it.

#include "TestHelpers.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkGaussMapEmbedding.h"
#include "vtkRestrictedVoronoiDiagram.h"
#include "vtkSurfaceMeshComparison.h"

using namespace remesh;
using namespace remesh::test;

namespace
{
/** Asks for a piece; whether there is one warning, and that of a distributed surface. */
bool warnsOf(vtkAlgorithm* filter, int piece, int pieces)
{
  Messages messages(filter);
  filter->UpdatePiece(piece, pieces, 0);
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
  filter->SetInputDataObject(0, empty);
  CHECK(!warnsOf(filter, 1, 2));
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
  return result();
}
