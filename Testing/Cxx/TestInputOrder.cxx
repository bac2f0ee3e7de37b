// The outputs of a surface that could come in pieces are those of the surface: neither the order of
// points and cells counts, nor with which corner a cell starts, nor whether points are there twice.

#include "TestBytes.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkBoundingBox.h"
#include "vtkCell.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPassThrough.h"
#include "vtkPolyDataNormals.h"
#include "vtkRestrictedVoronoiDiagram.h"

#include <array>
#include <numeric>
#include <random>

using namespace remesh;
using namespace remesh::test;

namespace
{
std::vector<vtkIdType> shuffled(vtkIdType count, std::mt19937& random)
{
  std::vector<vtkIdType> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), vtkIdType(0));
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

/** The same surface; with `doubled`, each cell uses a point or another one in its place. */
vtkSmartPointer<vtkPolyData> shuffle(vtkPolyData* input, bool doubled, unsigned int seed)
{
  std::mt19937 random(seed);
  const vtkIdType count = input->GetNumberOfPoints();
  auto output = vtkSmartPointer<vtkPolyData>::New();
  const std::vector<vtkIdType> order = shuffled((doubled ? 2 : 1) * count, random);
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(static_cast<vtkIdType>(order.size()));
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(input->GetPointData());
  std::vector<vtkIdType> place(order.size()); // of each input point, once or twice
  for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k)
  {
    points->SetPoint(k, input->GetPoint(order[k] % count));
    output->GetPointData()->CopyData(input->GetPointData(), order[k] % count, k);
    place[order[k]] = k;
  }
  vtkNew<vtkCellArray> cells;
  output->GetCellData()->CopyAllocate(input->GetCellData());
  for (const vtkIdType cell : shuffled(input->GetNumberOfCells(), random))
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    input->GetPolys()->GetCellAtId(cell, size, ids);
    std::vector<vtkIdType> corners;
    for (vtkIdType k = 0; k < size; ++k)
    {
      corners.push_back(place[ids[k] + (doubled && random() % 2 == 0 ? count : 0)]);
    }
    std::rotate(corners.begin(), corners.begin() + random() % size, corners.end());
    const vtkIdType to = cells->InsertNextCell(size, corners.data());
    output->GetCellData()->CopyData(input->GetCellData(), cell, to);
  }
  output->SetPoints(points);
  output->SetPolys(cells);
  return output;
}

/** Labels, colours, measures and normals, among them zeros and ties. */
void addArrays(vtkPolyData* data)
{
  addPointArray<vtkDoubleArray>(
    data, "Height", 1, [](const Point3& p, int) { return std::floor(4.0 * p[2]); });
  addPointArray<vtkIntArray>(
    data, "Region", 1, [](const Point3& p, int) { return p[0] > 0.1 ? 1 : 2; });
  vtkNew<vtkIntArray> labels;
  labels->SetName("Labels");
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    labels->InsertNextValue(static_cast<int>(cell * 7 / data->GetNumberOfCells()) % 3);
  }
  data->GetCellData()->AddArray(labels);
}

vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData* data)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(data);
  normals->SetFeatureAngle(30.0);
  normals->SplittingOn();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

/** A source that gives pieces, of which there is one here. */
class PieceSource : public vtkPolyDataAlgorithm
{
public:
  static PieceSource* New() { VTK_STANDARD_NEW_BODY(PieceSource); }
  vtkTypeMacro(PieceSource, vtkPolyDataAlgorithm);

  vtkSmartPointer<vtkPolyData> Surface;

protected:
  PieceSource() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkPolyData::GetData(outputs)->ShallowCopy(this->Surface);
    return 1;
  }
};

struct Case
{
  const char* name;
  vtkSmartPointer<vtkPolyData> surface;
  const char* labels;
};

std::vector<Case> makeCases()
{
  TriangleSoup boxes = cube();
  append(boxes, cube(), Point3(1, 1, 0)); // share an edge
  std::vector<Case> cases = { { "sphere", polyDataOf(icosphere(3)), nullptr },
    { "boxes", polyDataOf(boxes), nullptr }, { "plate", bumpyPlate(20, 0.1, 7.0), nullptr },
    { "labels", polyDataOf(icosphere(3)), "Labels" } };
  for (Case& each : cases)
  {
    addArrays(each.surface);
  }
  cases.push_back({ "normals", withNormals(polyDataOf(boxes)), nullptr });
  return cases;
}

/** All but the numbers that cells of the input have. */
std::vector<Content> outputsOf(vtkAlgorithm* filter)
{
  std::vector<Content> contents = contentsOf(filter);
  const bool hasIds = contents[1].erase("cell InputCellId") == 1;
  CHECK(hasIds);
  return contents;
}

void testRemesher(const Case& each)
{
  vtkNew<PieceSource> source;
  vtkNew<vtkPassThrough> between;
  between->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkAnisotropicRemesher> remesher;
  remesher->SetNumberOfPoints(150);
  remesher->SetNumberOfNewtonIterations(5);
  remesher->SetFeatureLabelArray(each.labels);
  remesher->GenerateVoronoiCellsOn();
  remesher->GenerateEdgesOn();
  remesher->SetInputConnection(between->GetOutputPort());
  source->Surface = each.surface;
  remesher->Update();
  const std::vector<Content> expected = outputsOf(remesher);
  CHECK(remesher->GetOutput()->GetNumberOfCells() > 0);
  for (const unsigned int seed : { 1u, 2u, 3u })
  {
    source->Surface = shuffle(each.surface, seed == 3, seed);
    source->Modified();
    remesher->Update();
    checkSame(outputsOf(remesher), expected, std::string(each.name) + std::to_string(seed));
  }
}

/** InputCellId still names the cell of the input: each piece lies in its triangle. */
void testIds(bool givesPieces)
{
  vtkNew<PieceSource> source;
  source->Surface = shuffle(polyDataOf(icosphere(2)), false, 1);
  vtkNew<vtkRestrictedVoronoiDiagram> diagram;
  diagram->SetSitesData(source->Surface);
  givesPieces ? diagram->SetInputConnection(source->GetOutputPort())
              : diagram->SetInputData(source->Surface);
  diagram->Update();
  vtkPolyData* cells = diagram->GetVoronoiCellsOutput();
  vtkDataArray* ids = cells->GetCellData()->GetArray("InputCellId");
  CHECK(cells->GetNumberOfCells() >= source->Surface->GetNumberOfCells());
  for (vtkIdType k = 0; k < cells->GetNumberOfCells(); ++k)
  {
    vtkCell* triangle = source->Surface->GetCell(static_cast<vtkIdType>(ids->GetTuple1(k)));
    double bounds[6];
    cells->GetCellBounds(k, bounds);
    vtkBoundingBox box(triangle->GetBounds());
    box.Inflate(1e-9);
    CHECK(box.Contains(vtkBoundingBox(bounds)));
  }
}

/** Blocks are put in that order, too. */
void testBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const TriangleSoup sphere = icosphere(2);
  blocks->SetBlock(0, polyDataOf(sphere));
  TriangleSoup moved;
  append(moved, sphere, Point3(3, 0, 0));
  blocks->SetBlock(1, polyDataOf(moved));
  vtkNew<vtkAnisotropicRemesher> remesher;
  remesher->SetNumberOfPoints(100);
  remesher->SetInputDataObject(blocks);
  const auto contentOfBlock = [&](unsigned int k)
  {
    remesher->Update();
    auto* output = vtkMultiBlockDataSet::SafeDownCast(remesher->GetOutputDataObject(0));
    CHECK(vtkPolyData::SafeDownCast(output->GetBlock(k))->GetNumberOfCells() > 0);
    return contentOf(output->GetBlock(k));
  };
  const std::array<Content, 2> expected = { contentOfBlock(0), contentOfBlock(1) };
  for (unsigned int k = 0; k < 2; ++k)
  {
    blocks->SetBlock(k, shuffle(vtkPolyData::SafeDownCast(blocks->GetBlock(k)), k == 1, k));
  }
  blocks->Modified();
  checkSame(contentOfBlock(0), expected[0], "first block");
  checkSame(contentOfBlock(1), expected[1], "second block");
}
}

int TestInputOrder(int, char*[])
{
  for (const Case& each : makeCases())
  {
    testRemesher(each);
  }
  testIds(true);
  testIds(false);
  testBlocks();
  return result();
}
