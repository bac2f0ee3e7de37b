// A surface in pieces: a filter that is given one of them, and no other process, says so; pieces
// are cut off, and put together again.

#include "TestBytes.h"

#include "Adaptors/SurfacePieces.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkGaussMapEmbedding.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkRestrictedVoronoiDiagram.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSurfaceMeshComparison.h"
#include "vtkUnsignedCharArray.h"

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

/** A sheet with the number of each point and cell. */
vtkSmartPointer<vtkPolyData> numberedSheet()
{
  vtkSmartPointer<vtkPolyData> sheet = bumpyPlate(7, 0.1, 5.0);
  addPointArray<vtkDoubleArray>(
    sheet, "Place", 3, [](const Point3& p, int component) { return p[component]; });
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (int cell = 0; cell < sheet->GetNumberOfCells(); ++cell)
  {
    numbers->InsertNextValue(cell);
  }
  sheet->GetCellData()->AddArray(numbers);
  return sheet;
}

/** The places of all corners, cell by cell, twice: as points, and by the array. */
std::vector<Point3> cornersOf(vtkPolyData* data)
{
  std::vector<Point3> corners;
  vtkDataArray* places = data->GetPointData()->GetArray("Place");
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    data->GetPolys()->GetCellAtId(cell, size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      corners.push_back(pointOf(data, ids[k]));
      corners.emplace_back(tupleOf(places, ids[k]));
    }
  }
  return corners;
}

/** The parts together have the cells of the whole in their order, even where some are empty. */
void testPartsAndPieces()
{
  const vtkSmartPointer<vtkPolyData> whole = numberedSheet();
  for (const int parts : { 1, 2, 3, 200 })
  {
    std::vector<vtkSmartPointer<vtkDataObject>> pieces;
    for (int part = 0; part < parts; ++part)
    {
      pieces.emplace_back(cutPart(whole, part, parts));
      CHECK(parts > 2 || pieces.back()->GetNumberOfElements(vtkDataObject::POINT) > 0);
    }
    const auto joined = joinPieces(pieces);
    auto* surface = vtkPolyData::SafeDownCast(joined);
    CHECK(surface && cornersOf(surface) == cornersOf(whole));
    CHECK(bytesOf(surface->GetCellData()->GetArray("Number")) ==
      bytesOf(whole->GetCellData()->GetArray("Number")));
  }
  const vtkSmartPointer<vtkPolyData> points = pointsOnly({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } });
  points->SetPolys(vtkNew<vtkCellArray>());
  CHECK_EQUAL(cutPart(points, 0, 2)->GetNumberOfPoints(), 1);
  CHECK_EQUAL(cutPart(points, 1, 2)->GetNumberOfPoints(), 2);
  CHECK(joinPieces({ whole, nullptr }).Get() == whole.Get()); // nothing is copied
  CHECK(joinPieces({ nullptr, nullptr }) == nullptr);
}

void testGhosts()
{
  const vtkSmartPointer<vtkPolyData> sheet = numberedSheet();
  CHECK(withoutGhosts(sheet).Get() == sheet.Get());
  vtkUnsignedCharArray* ghosts = sheet->AllocateCellGhostArray();
  ghosts->SetValue(0, vtkDataSetAttributes::DUPLICATECELL);
  ghosts->SetValue(5, vtkDataSetAttributes::HIDDENCELL);
  const auto rest = withoutGhosts(sheet);
  auto* surface = vtkPolyData::SafeDownCast(rest);
  CHECK_EQUAL(surface->GetNumberOfCells(), sheet->GetNumberOfCells() - 2);
  CHECK(!surface->GetCellGhostArray());
  CHECK_EQUAL(surface->GetCellData()->GetArray("Number")->GetComponent(0, 0), 1.0);
  CHECK_EQUAL(surface->GetCellData()->GetArray("Number")->GetComponent(4, 0), 6.0);
  CHECK_EQUAL(ghosts->GetValue(0), vtkDataSetAttributes::DUPLICATECELL); // the input's
}
}

int TestDistribution(int, char*[])
{
  testPartsAndPieces();
  testGhosts();
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
