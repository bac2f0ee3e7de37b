// What is taken for a surface by all filters: grids of polygons and composite data; everything else
// is an error that tells what to do. And each step of a time series is as it is alone.

#include "TestBlocks.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkDataObjectAlgorithm.h"
#include "vtkGaussMapEmbedding.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkRestrictedVoronoiDiagram.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSurfaceMeshComparison.h"
#include "vtkTable.h"

using namespace remesh;
using namespace remesh::test;

namespace
{
void setQuick(vtkAnisotropicRemesher* remesher)
{
  remesher->SetNumberOfPoints(200);
  remesher->SetNumberOfLloydIterations(1);
  remesher->SetNumberOfNewtonIterations(2);
}

/** The first cells are squares, as polygons, the others triangles; with arrays. */
vtkSmartPointer<vtkPolyData> mixedSurface()
{
  const TriangleSoup soup = wavySoup(12);
  vtkSmartPointer<vtkPolyData> surface = polyDataOf(soup);
  vtkNew<vtkCellArray> polygons;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    const auto& [a, b, c] = soup.triangles[t];
    if (t < 100 && t % 2 == 0)
    {
      polygons->InsertNextCell({ a, b, c, soup.triangles[t + 1][2] });
    }
    else if (t >= 100)
    {
      polygons->InsertNextCell({ a, b, c });
    }
  }
  surface->SetPolys(polygons);
  addPointArray<vtkDoubleArray>(surface, "T", 1, [](const Point3& p, int) { return p[0]; });
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    numbers->InsertNextValue(static_cast<int>(cell / 7));
  }
  surface->GetCellData()->AddArray(numbers);
  addConstant<vtkDoubleArray>(surface->GetFieldData(), "Fact", 1, 3.0);
  return surface;
}

/** A grid with the same surface: squares as pixels, and lines and vertices among the cells. */
vtkSmartPointer<vtkUnstructuredGrid> gridWithRest(
  vtkPolyData* surface, std::vector<vtkIdType>& cellsOfGrid)
{
  const vtkSmartPointer<vtkUnstructuredGrid> all = gridOf(surface);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(surface->GetPoints());
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  const auto add = [&](int type, std::vector<vtkIdType> ids, int number)
  {
    numbers->InsertNextValue(number);
    return grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
  };
  for (vtkIdType cell = 0; cell < all->GetNumberOfCells(); ++cell)
  {
    vtkIdList* ids = all->GetCell(cell)->GetPointIds();
    std::vector<vtkIdType> points(ids->begin(), ids->end());
    if (cell % 10 == 0)
    {
      add(VTK_VERTEX, { points[0] }, -1);
      add(VTK_LINE, { points[0], points[1] }, -2);
    }
    const bool isSquare = points.size() == 4;
    if (isSquare)
    {
      std::swap(points[2], points[3]);
    }
    cellsOfGrid.push_back(
      add(isSquare ? VTK_PIXEL : VTK_TRIANGLE, points, static_cast<int>(cell / 7)));
  }
  grid->GetPointData()->ShallowCopy(surface->GetPointData());
  grid->GetFieldData()->ShallowCopy(surface->GetFieldData());
  grid->GetCellData()->AddArray(numbers);
  return grid;
}

void testGrids()
{
  const vtkSmartPointer<vtkPolyData> surface = mixedSurface();
  vtkNew<vtkAnisotropicRemesher> remesher;
  setQuick(remesher);
  remesher->SetInputDataObject(surface);
  remesher->Update();
  std::vector<Content> expected = contentsOf(remesher);
  remesher->SetInputDataObject(gridOf(surface));
  remesher->Update();
  checkSame(contentsOf(remesher), expected, "a grid of the same cells");

  std::vector<vtkIdType> cells;
  const vtkSmartPointer<vtkUnstructuredGrid> grid = gridWithRest(surface, cells);
  const vtkSmartPointer<vtkDataArray> ids =
    arrayOf(remesher->GetVoronoiCellsOutput()->GetCellData(), "InputCellId");
  remesher->SetInputDataObject(grid);
  remesher->Update();
  const vtkSmartPointer<vtkDataArray> gridIds =
    arrayOf(remesher->GetVoronoiCellsOutput()->GetCellData(), "InputCellId");
  CHECK_EQUAL(ids->GetNumberOfTuples(), gridIds->GetNumberOfTuples());
  for (vtkIdType k = 0; k < ids->GetNumberOfTuples(); ++k)
  {
    CHECK_EQUAL(cells[static_cast<std::size_t>(ids->GetTuple1(k))],
      static_cast<vtkIdType>(gridIds->GetTuple1(k)));
  }
  std::vector<Content> contents = contentsOf(remesher);
  contents[1].erase("cell InputCellId");
  expected[1].erase("cell InputCellId");
  checkSame(contents, expected, "a grid with lines and vertices");
}

/** The embedding of a grid is the grid with one more array, and that of blocks are the blocks. */
void testEmbedding()
{
  const vtkSmartPointer<vtkPolyData> surface = mixedSurface();
  vtkNew<vtkGaussMapEmbedding> filter;
  filter->SetInputDataObject(surface);
  filter->Update();
  const Content expected = contentOf(filter->GetOutputDataObject(0));
  std::vector<vtkIdType> cells;
  const vtkSmartPointer<vtkUnstructuredGrid> grid = gridWithRest(surface, cells);
  filter->SetInputDataObject(grid);
  filter->Update();
  auto* output = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  CHECK(output && output->GetNumberOfCells() == grid->GetNumberOfCells());
  CHECK(output &&
    bytesOf(output->GetPointData()->GetArray("Embedding")) == expected.at("point Embedding"));
  CHECK(output && output->GetCellData()->GetArray("Number") == grid->GetCellData()->GetArray(0));

  const Halves halves(12);
  filter->SetInputDataObject(polyDataOf(halves.soup));
  filter->Update();
  std::map<std::array<double, 3>, Eigen::VectorXd> places;
  vtkPolyData* whole = filter->GetOutput();
  for (vtkIdType k = 0; k < whole->GetNumberOfPoints(); ++k)
  {
    const Point3 p = pointOf(whole, k);
    places[{ p[0], p[1], p[2] }] = tupleOf(whole->GetPointData()->GetArray("Embedding"), k);
  }
  addConstant<vtkDoubleArray>(
    halves.left->GetPointData(), "Embedding", halves.left->GetNumberOfPoints(), 1.0);
  filter->SetInputDataObject(blocksOf({ halves.left, nullptr, gridOf(halves.right) }));
  filter->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  CHECK(blocks && blocks->GetNumberOfBlocks() == 3 && !blocks->GetBlock(1));
  CHECK(blocks && vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(2)));
  for (unsigned int k : { 0u, 2u })
  {
    auto* block = vtkPointSet::SafeDownCast(blocks->GetBlock(k));
    const vtkSmartPointer<vtkDataArray> embedding = arrayOf(block->GetPointData(), "Embedding");
    CHECK_EQUAL(block->GetPointData()->GetNumberOfArrays(), 1);
    for (vtkIdType i = 0; i < block->GetNumberOfPoints(); ++i)
    {
      double p[3];
      block->GetPoint(i, p);
      CHECK((tupleOf(embedding, i) - places.at({ p[0], p[1], p[2] })).norm() < 1e-12);
    }
  }
}

/** Two halves are compared as the plate that they are. */
void testComparison()
{
  const Halves halves(12);
  const vtkSmartPointer<vtkPolyData> plate = polyDataOf(wavySoup(17));
  vtkNew<vtkSurfaceMeshComparison> filter;
  filter->SetInputDataObject(polyDataOf(halves.soup));
  filter->SetReferenceData(plate);
  filter->Update();
  const auto cell = [](vtkTable* table, const char* name)
  { return table->GetValueByName(0, name).ToDouble(); };
  const double distance = cell(filter->GetSummaryOutput(), "MaximumDistance");
  addConstant<vtkDoubleArray>(
    halves.left->GetPointData(), "OnlyLeft", halves.left->GetNumberOfPoints(), 5.0);
  vtkNew<vtkPartitionedDataSet> reference;
  reference->SetPartition(0, plate);
  filter->SetInputDataObject(blocksOf({ halves.left, gridOf(halves.right) }));
  filter->SetReferenceData(reference);
  const Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty() && messages.warnings().empty());
  vtkTable* summary = filter->GetSummaryOutput();
  CHECK_NEAR(cell(summary, "MaximumDistance"), distance, 1e-6);
  CHECK_EQUAL(cell(summary, "NumberOfComponents"), 1.0);
  CHECK_EQUAL(cell(summary, "NumberOfBoundaryLoops"), 1.0);
  CHECK_EQUAL(cell(summary, "NumberOfPoints"), 169.0);
  CHECK_EQUAL(cell(summary, "NumberOfDuplicatePoints"), 0.0);
  const auto leaves = leavesOf(filter->GetOutputDataObject(0));
  CHECK_EQUAL(leaves.size(), 2u);
  CHECK_EQUAL(leaves[0]->GetNumberOfPoints(), halves.left->GetNumberOfPoints());
  CHECK_EQUAL(leaves[1]->GetNumberOfCells(), halves.right->GetNumberOfCells());
  CHECK(bytesOf(leaves[0]->GetPolys()->GetConnectivityArray()) ==
    bytesOf(halves.left->GetPolys()->GetConnectivityArray()));
  CHECK(leaves[0]->GetPointData()->HasArray("OnlyLeft"));
  CHECK(!leaves[1]->GetPointData()->HasArray("OnlyLeft"));
  for (vtkPolyData* leaf : leaves)
  {
    CHECK_EQUAL(
      arrayOf(leaf->GetPointData(), "Distance")->GetNumberOfTuples(), leaf->GetNumberOfPoints());
    CHECK_EQUAL(
      arrayOf(leaf->GetCellData(), "Quality")->GetNumberOfTuples(), leaf->GetNumberOfCells());
  }
  auto* made = vtkPartitionedDataSet::SafeDownCast(filter->GetOutputDataObject(1));
  CHECK(made && made->GetNumberOfPartitions() == 1);
  CHECK(made && made->GetPartition(0)->GetPointData()->HasArray("SignedDistance"));
  CHECK(filter->GetReferenceOutput() == nullptr);
}

/** Sites in blocks are those of all; the surface's outputs have its own structure. */
void testSites()
{
  const vtkSmartPointer<vtkPolyData> surface = polyDataOf(ellipsoid(3));
  const TriangleSoup sites = ellipsoid(1);
  const std::vector<Point3> first(sites.points.begin(), sites.points.begin() + 15);
  const std::vector<Point3> others(sites.points.begin() + 15, sites.points.end());
  vtkNew<vtkRestrictedVoronoiDiagram> filter;
  filter->SetInputDataObject(surface);
  filter->SetSitesData(pointsOnly(sites.points));
  filter->Update();
  const std::vector<Content> expected = contentsOf(filter);
  filter->SetSitesData(blocksOf({ pointsOnly(first), nullptr, pointsOnly(others) }));
  filter->Update();
  checkSame(contentsOf(filter), expected, "sites in blocks");
  const vtkSmartPointer<vtkPolyData> left =
    partOf(ellipsoid(3), [](const Point3& p) { return p[0] < ellipsoidCenter()[0]; });
  const vtkSmartPointer<vtkPolyData> right =
    partOf(ellipsoid(3), [](const Point3& p) { return p[0] >= ellipsoidCenter()[0]; });
  filter->SetInputDataObject(blocksOf({ left, right }));
  filter->Update();
  const MeshTopology topology = topologyOf(filter->GetOutputDataObject(0));
  CHECK_EQUAL(topology.eulerCharacteristic, 2);
  CHECK_EQUAL(topology.points, static_cast<Index>(sites.points.size()));
  const auto leaves = leavesOf(filter->GetOutputDataObject(2));
  CHECK_EQUAL(leaves[0]->GetNumberOfPoints() + leaves[1]->GetNumberOfPoints(),
    static_cast<vtkIdType>(sites.points.size()));
}

vtkSmartPointer<vtkUnstructuredGrid> tetrahedron()
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  for (const Point3& p : { Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0), Point3(0, 0, 1) })
  {
    points->InsertNextPoint(p.data());
  }
  grid->SetPoints(points);
  const vtkIdType ids[] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TRIANGLE, 3, ids);
  grid->InsertNextCell(VTK_TETRA, 4, ids);
  return grid;
}

void checkRefused(vtkAlgorithm* filter, vtkDataObject* input, const std::vector<std::string>& words)
{
  filter->SetInputDataObject(0, input);
  const Messages messages(filter);
  filter->Update();
  const std::string text = messages.errors().size() == 1 ? messages.errors()[0] : "";
  for (const std::string& word : words)
  {
    check(text.find(word) != std::string::npos, __FILE__, __LINE__,
      std::string(filter->GetClassName()) + ": \"" + word + "\" is not in: " + text);
  }
  CHECK_EQUAL(messages.executiveErrors().size(), 1u); // RequestData returned 0
  CHECK(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT) == 0);
}

void testRefused(vtkAlgorithm* filter)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  vtkNew<vtkTable> table;
  checkRefused(
    filter, image, { "The input is a vtkImageData", "Extract Surface", "vtkDataSetSurfaceFilter" });
  checkRefused(filter, table, { "The input is a table", "Extract Surface" });
  checkRefused(
    filter, tetrahedron(), { "1 of 2, the first, cell 1, is a vtkTetra", "Extract Surface" });
  const vtkSmartPointer<vtkMultiBlockDataSet> blocks = blocksOf({ polyDataOf(icosphere(1)) });
  putBlock(blocks, 1, image, "air");
  checkRefused(
    filter, blocks, { "Block \"air\" (1) of the input is a vtkImageData", "Extract Surface" });
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  CHECK(output && output->GetNumberOfBlocks() == 2 && output->GetNumberOfPoints() == 0);
  blocks->SetBlock(1, tetrahedron());
  checkRefused(filter, blocks, { "Block \"air\" (1) of the input is an unstructured grid" });
  blocks->SetBlock(1, table);
  checkRefused(filter, blocks, { "Block \"air\" (1) of the input is a table" });
  // And no harm to the next.
  filter->SetInputDataObject(0, polyDataOf(icosphere(2)));
  const Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty());
  CHECK(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT) > 0);
}

/** Normals of some blocks alone are not used, and that is told. */
void testNormalsOfSome()
{
  const Halves halves(12);
  vtkNew<vtkAnisotropicRemesher> remesher;
  setQuick(remesher);
  remesher->SetInputDataObject(blocksOf({ halves.left, halves.right }));
  remesher->Update();
  const MeshTopology expected = topologyOf(remesher->GetOutputDataObject(0));
  const auto normals = addPointArray<vtkDoubleArray>(
    halves.left, "N", 3, [](const Point3&, int c) { return c == 0 ? 1.0 : 0.0; });
  halves.left->GetPointData()->SetNormals(normals);
  remesher->SetInputDataObject(blocksOf({ halves.left, halves.right }));
  const Messages messages(remesher);
  remesher->Update();
  CHECK(messages.errors().empty());
  CHECK(messages.warnings().size() == 1 &&
    messages.warnings()[0].find("Some blocks have active point normals") != std::string::npos);
  CHECK_EQUAL(topologyOf(remesher->GetOutputDataObject(0)).edges, expected.edges);
}

/** The surface of a time between 0 and 2. */
vtkSmartPointer<vtkDataObject> surfaceAt(double time, bool inBlocks)
{
  Halves halves(12);
  for (vtkPolyData* half : { halves.left.Get(), halves.right.Get() })
  {
    for (vtkIdType k = 0; k < half->GetNumberOfPoints(); ++k)
    {
      const Point3 p = pointOf(half, k);
      half->GetPoints()->SetPoint(k, p[0], p[1], p[2] * (1.0 + time));
    }
  }
  return inBlocks ? vtkSmartPointer<vtkDataObject>(blocksOf({ halves.left, halves.right }))
                  : vtkSmartPointer<vtkDataObject>(halves.left);
}

class TimeSource : public vtkDataObjectAlgorithm
{
public:
  static TimeSource* New();
  vtkTypeMacro(TimeSource, vtkDataObjectAlgorithm);
  bool InBlocks = false;

protected:
  TimeSource() { this->SetNumberOfInputPorts(0); }

  int FillOutputPortInformation(int, vtkInformation* info) override
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
    return 1;
  }
  int RequestDataObject(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    const vtkSmartPointer<vtkDataObject> made = surfaceAt(0.0, this->InBlocks);
    const auto output = vtk::TakeSmartPointer(made->NewInstance());
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), output);
    return 1;
  }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    const double times[] = { 0.0, 1.0, 2.0 };
    const double range[] = { 0.0, 2.0 };
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    outputVector->GetInformationObject(0)->Set(Pipeline::TIME_STEPS(), times, 3);
    outputVector->GetInformationObject(0)->Set(Pipeline::TIME_RANGE(), range, 2);
    return 1;
  }
  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    vtkInformation* info = outputVector->GetInformationObject(0);
    const double time = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    vtkDataObject* output = info->Get(vtkDataObject::DATA_OBJECT());
    output->ShallowCopy(surfaceAt(time, this->InBlocks));
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }
};
vtkStandardNewMacro(TimeSource);

std::vector<Content> leafContents(vtkAlgorithm* filter, bool inBlocks)
{
  if (!inBlocks)
  {
    return contentsOf(filter);
  }
  std::vector<Content> contents;
  for (int port : { 0, 1, 2, 4 })
  {
    for (vtkPolyData* leaf : leavesOf(filter->GetOutputDataObject(port)))
    {
      contents.push_back(contentOf(leaf));
    }
  }
  return contents;
}

void testTime(bool inBlocks)
{
  vtkNew<TimeSource> source;
  source->InBlocks = inBlocks;
  vtkNew<vtkAnisotropicRemesher> series;
  setQuick(series);
  series->SetInputConnection(source->GetOutputPort());
  for (const double time : { 0.0, 2.0, 1.0, 0.0 })
  {
    series->UpdateTimeStep(time);
    vtkNew<vtkAnisotropicRemesher> alone;
    setQuick(alone);
    alone->SetInputDataObject(surfaceAt(time, inBlocks));
    alone->Update();
    checkSame(leafContents(series, inBlocks), leafContents(alone, inBlocks),
      "time " + std::to_string(time));
    CHECK_EQUAL(
      series->GetOutputDataObject(0)->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), time);
  }
}
}

int TestSurfaceInputs(int, char*[])
{
  testGrids();
  testEmbedding();
  testComparison();
  testSites();
  vtkNew<vtkAnisotropicRemesher> remesher;
  setQuick(remesher);
  vtkNew<vtkGaussMapEmbedding> embedding;
  vtkNew<vtkSurfaceMeshComparison> comparison;
  vtkNew<vtkRestrictedVoronoiDiagram> diagram;
  diagram->SetSitesData(pointsOnly(icosphere(1).points));
  for (vtkAlgorithm* filter :
    std::initializer_list<vtkAlgorithm*>{ remesher, embedding, comparison, diagram })
  {
    testRefused(filter);
  }
  testNormalsOfSome();
  testTime(false);
  testTime(true);
  return result();
}
