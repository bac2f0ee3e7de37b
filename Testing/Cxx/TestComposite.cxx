// Composite input is one surface: no gaps between blocks, points counted once, and outputs in the
// structure of the input with the arrays of its blocks.

#include "TestBlocks.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolygon.h"
#include "vtkRestrictedVoronoiAlgorithm.h"
#include "vtkStringArray.h"

using namespace remesh;
using namespace remesh::test;

namespace
{
constexpr int meshPoints = 400;

void setQuick(vtkAnisotropicRemesher* remesher)
{
  remesher->SetNumberOfPoints(meshPoints);
  remesher->SetNumberOfLloydIterations(2);
  remesher->SetNumberOfNewtonIterations(5);
}

/** Length of the mesh's border edges on x = 0.5, by their extent along y. */
double lengthOnSeam(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  auto each = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (each->GoToFirstCell(); !each->IsDoneWithTraversal(); each->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    each->GetCurrentCell(size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      ++edges[std::minmax(ids[k], ids[(k + 1) % size])];
    }
  }
  double length = 0.0;
  for (const auto& [ends, count] : edges)
  {
    const Point3 a = pointOf(mesh, ends.first);
    const Point3 b = pointOf(mesh, ends.second);
    if (count == 1 && std::abs(a[0] - 0.5) < 1e-9 && std::abs(b[0] - 0.5) < 1e-9)
    {
      length += std::abs(a[1] - b[1]);
    }
  }
  return length;
}

void checkOnePlate(vtkDataObject* output, const std::string& where)
{
  const MeshTopology topology = topologyOf(output);
  check(topology.components == 1 && topology.boundaryLoops == 1 && topology.nonManifoldEdges == 0 &&
      topology.eulerCharacteristic == 1 && topology.oriented,
    __FILE__, __LINE__, where + ": a gap");
}

void testNoGaps()
{
  const Halves halves(24);
  for (const double anisotropy : { 0.0, 0.04, 0.2 })
  {
    const std::string where = "anisotropy " + std::to_string(anisotropy);
    vtkNew<vtkAnisotropicRemesher> remesher;
    setQuick(remesher);
    remesher->SetAnisotropy(anisotropy);
    remesher->SetInputDataObject(blocksOf({ halves.left, halves.right }));
    const Messages messages(remesher);
    remesher->Update();
    CHECK(messages.errors().empty());
    CHECK(remesher->GetOutput() == nullptr);
    vtkDataObject* output = remesher->GetOutputDataObject(0);
    checkOnePlate(output, where);
    const MeshTopology topology = topologyOf(output);
    check(topology.points == meshPoints, __FILE__, __LINE__,
      where + ": " + std::to_string(topology.points) + " points");
    const auto leaves = leavesOf(output);
    CHECK_EQUAL(leaves.size(), 2u);
    for (vtkPolyData* leaf : leaves)
    {
      CHECK_NEAR(lengthOnSeam(leaf), 1.0, 1e-9);
      CHECK_EQUAL(arrayOf(leaf->GetFieldData(), "TopologyPreserved")->GetTuple1(0), 1.0);
      CHECK(!leaf->GetCellData()->HasArray("InputCellId"));
    }
    CHECK_EQUAL(arrayOf(output->GetFieldData(), "TopologyPreserved")->GetTuple1(0), 1.0);
  }
}

/** Without features a border may be cut off, but not open. */
void testWithoutFeatures()
{
  const Halves halves(24);
  vtkNew<vtkAnisotropicRemesher> remesher;
  setQuick(remesher);
  remesher->SetNumberOfPoints(100); // triangles larger than the input's
  remesher->PreserveFeaturesOff();
  vtkNew<vtkIntArray> numbers; // all different: what is not there would be the largest share
  numbers->SetName("OnlyLeft");
  for (vtkIdType k = 1; k <= halves.left->GetNumberOfCells(); ++k)
  {
    numbers->InsertNextValue(static_cast<int>(k));
  }
  halves.left->GetCellData()->AddArray(numbers);
  addConstant<vtkDoubleArray>(
    halves.left->GetPointData(), "T", halves.left->GetNumberOfPoints(), 1.0);
  addConstant<vtkDoubleArray>(
    halves.right->GetPointData(), "T", halves.right->GetNumberOfPoints(), 2.0);
  remesher->SetInputDataObject(blocksOf({ halves.left, halves.right }));
  remesher->Update();
  vtkDataObject* output = remesher->GetOutputDataObject(0);
  checkOnePlate(output, "without features");
  CHECK_EQUAL(topologyOf(output).points, 100);
  const auto leaves = leavesOf(output);
  for (vtkIdType k = 0; k < leaves[0]->GetNumberOfCells(); ++k)
  {
    CHECK(arrayOf(leaves[0]->GetCellData(), "OnlyLeft")->GetTuple1(k) > 0.0);
  }
  CHECK(!leaves[1]->GetCellData()->HasArray("OnlyLeft"));
  for (int side : { 0, 1 })
  {
    for (vtkIdType k = 0; k < leaves[side]->GetNumberOfPoints(); ++k)
    {
      CHECK_EQUAL(arrayOf(leaves[side]->GetPointData(), "T")->GetTuple1(k), side + 1.0);
    }
  }
}

/** At a sharp border, too, the values of each block are those of its side. */
void testFold()
{
  const TriangleSoup soup = gridPatch(10, 10);
  TriangleSoup upright = soup;
  for (Point3& p : upright.points)
  {
    p = Point3(1.0, p[1], p[0]); // touches at x = 1
  }
  vtkNew<vtkAnisotropicRemesher> remesher;
  setQuick(remesher);
  remesher->SetInputDataObject(blocksOf({ polyDataOf(soup), polyDataOf(upright) }));
  remesher->Update();
  const auto leaves = leavesOf(remesher->GetOutputDataObject(0));
  CHECK_EQUAL(leaves.size(), 2u);
  for (int side : { 0, 1 })
  {
    const vtkSmartPointer<vtkDataArray> normals = arrayOf(leaves[side]->GetPointData(), "Normals");
    CHECK(leaves[side]->GetPointData()->GetNormals() == normals);
    for (vtkIdType k = 0; k < normals->GetNumberOfTuples(); ++k)
    {
      CHECK_NEAR(std::abs(normals->GetComponent(k, side == 0 ? 2 : 0)), 1.0, 1e-9);
    }
  }
  CHECK_EQUAL(topologyOf(remesher->GetOutputDataObject(0)).points, meshPoints);
}

/** The area of the pieces of each input cell is that of the cell: its id is the one in its block.
 */
void checkCellIds(vtkPolyData* pieces, vtkDataSet* input)
{
  std::vector<double> areas(static_cast<std::size_t>(input->GetNumberOfCells()), 0.0);
  vtkDataArray* ids = arrayOf(pieces->GetCellData(), "InputCellId");
  for (vtkIdType k = 0; k < pieces->GetNumberOfCells(); ++k)
  {
    double normal[3];
    vtkCell* piece = pieces->GetCell(k);
    areas.at(static_cast<std::size_t>(ids->GetTuple1(k))) +=
      vtkPolygon::ComputeArea(piece->GetPoints(), piece->GetNumberOfPoints(), nullptr, normal);
  }
  for (vtkIdType k = 0; k < input->GetNumberOfCells(); ++k)
  {
    double normal[3];
    vtkCell* cell = input->GetCell(k);
    const double area = cell->GetCellDimension() < 2
      ? 0.0
      : vtkPolygon::ComputeArea(cell->GetPoints(), cell->GetNumberOfPoints(), nullptr, normal);
    CHECK_NEAR(areas[k], area, 1e-12);
  }
}

/** The right half as a grid whose first cell is a vertex. */
vtkSmartPointer<vtkUnstructuredGrid> gridWithVertex(vtkPolyData* surface)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(surface->GetPoints());
  const vtkIdType first = 0;
  grid->InsertNextCell(VTK_VERTEX, 1, &first);
  const auto all = gridOf(surface);
  for (vtkIdType cell = 0; cell < all->GetNumberOfCells(); ++cell)
  {
    grid->InsertNextCell(VTK_TRIANGLE, all->GetCell(cell)->GetPointIds());
  }
  return grid;
}

/** Blocks within blocks, null, empty and of other classes, with names and keys. */
struct Nested
{
  vtkNew<vtkMultiBlockDataSet> root;
  vtkSmartPointer<vtkPolyData> left;
  vtkSmartPointer<vtkUnstructuredGrid> right;

  Nested()
  {
    const Halves halves(24);
    this->left = halves.left;
    this->right = gridWithVertex(halves.right);
    addConstant<vtkDoubleArray>(
      this->left->GetPointData(), "OnlyLeft", this->left->GetNumberOfPoints(), 7.0);
    addConstant<vtkDoubleArray>(
      this->left->GetPointData(), "Kind", this->left->GetNumberOfPoints(), 0.5);
    addConstant<vtkIntArray>(
      this->right->GetPointData(), "Kind", this->right->GetNumberOfPoints(), 4);
    addConstant<vtkIntArray>(this->left->GetCellData(), "Part", this->left->GetNumberOfCells(), 1);
    addConstant<vtkIntArray>(
      this->right->GetCellData(), "Part", this->right->GetNumberOfCells(), 2);
    this->left->GetPointData()->SetActiveScalars("OnlyLeft");
    vtkNew<vtkStringArray> note;
    note->SetName("Note");
    note->InsertNextValue("left");
    this->left->GetFieldData()->AddArray(note);
    vtkNew<vtkMultiBlockDataSet> inner;
    putBlock(inner, 0, this->left, "left");
    putBlock(inner, 1, nullptr, "nothing");
    vtkNew<vtkPolyData> empty;
    putBlock(this->root, 0, inner, "halves");
    putBlock(this->root, 1, empty, "empty");
    putBlock(this->root, 2, this->right, "right");
  }
};

std::string nameOf(vtkMultiBlockDataSet* blocks, unsigned int index)
{
  return blocks && index < blocks->GetNumberOfBlocks() && blocks->HasMetaData(index) &&
      blocks->GetMetaData(index)->Has(vtkCompositeDataSet::NAME())
    ? blocks->GetMetaData(index)->Get(vtkCompositeDataSet::NAME())
    : "";
}

/** The leaves at left and right, after the structure was checked. */
std::pair<vtkPolyData*, vtkPolyData*> checkStructure(vtkDataObject* data)
{
  auto* root = vtkMultiBlockDataSet::SafeDownCast(data);
  CHECK(root && root->GetNumberOfBlocks() == 3);
  auto* inner = root ? vtkMultiBlockDataSet::SafeDownCast(root->GetBlock(0)) : nullptr;
  CHECK(inner && inner->GetNumberOfBlocks() == 2);
  if (!inner)
  {
    return { nullptr, nullptr };
  }
  CHECK(nameOf(root, 0) == "halves" && nameOf(root, 1) == "empty" && nameOf(root, 2) == "right");
  CHECK(nameOf(inner, 0) == "left" && nameOf(inner, 1) == "nothing");
  CHECK(inner->GetBlock(1) == nullptr);
  auto* empty = vtkPolyData::SafeDownCast(root->GetBlock(1));
  CHECK(empty && empty->GetNumberOfPoints() == 0);
  return { vtkPolyData::SafeDownCast(inner->GetBlock(0)),
    vtkPolyData::SafeDownCast(root->GetBlock(2)) };
}

void checkArrays(vtkPolyData* left, vtkPolyData* right)
{
  CHECK(!right->GetPointData()->HasArray("OnlyLeft"));
  CHECK(left->GetPointData()->GetScalars() == left->GetPointData()->GetArray("OnlyLeft"));
  CHECK(arrayOf(left->GetPointData(), "Kind")->GetDataType() == VTK_DOUBLE);
  CHECK(arrayOf(right->GetPointData(), "Kind")->GetDataType() == VTK_INT);
  for (vtkIdType k = 0; k < left->GetNumberOfPoints(); ++k)
  {
    CHECK_EQUAL(arrayOf(left->GetPointData(), "OnlyLeft")->GetTuple1(k), 7.0);
    CHECK_EQUAL(arrayOf(left->GetPointData(), "Kind")->GetTuple1(k), 0.5);
  }
  for (vtkIdType k = 0; k < right->GetNumberOfPoints(); ++k)
  {
    CHECK_EQUAL(arrayOf(right->GetPointData(), "Kind")->GetTuple1(k), 4.0);
  }
  for (vtkPolyData* leaf : { left, right })
  {
    for (int k = 0; k < leaf->GetPointData()->GetNumberOfArrays(); ++k)
    {
      const std::string name = leaf->GetPointData()->GetArrayName(k);
      CHECK(name.find("vtkWhole") == std::string::npos && name.find('\x1f') == std::string::npos);
    }
    for (vtkIdType k = 0; k < leaf->GetNumberOfCells(); ++k)
    {
      CHECK_EQUAL(arrayOf(leaf->GetCellData(), "Part")->GetTuple1(k), leaf == left ? 1.0 : 2.0);
    }
  }
  CHECK(left->GetFieldData()->HasArray("Note") && !right->GetFieldData()->HasArray("Note"));
}

/** Each site is in one block, and lines on the seam are in both. */
void checkSitesAndEdges(vtkAlgorithm* remesher)
{
  using Ports = vtkRestrictedVoronoiAlgorithm;
  const auto [left, right] = checkStructure(remesher->GetOutputDataObject(Ports::SITES));
  std::set<vtkIdType> sites;
  vtkIdType count = 0;
  for (vtkPolyData* leaf : { left, right })
  {
    CHECK_EQUAL(leaf->GetNumberOfVerts(), leaf->GetNumberOfPoints());
    for (vtkIdType k = 0; k < leaf->GetNumberOfPoints(); ++k, ++count)
    {
      sites.insert(static_cast<vtkIdType>(arrayOf(leaf->GetPointData(), "SiteId")->GetTuple1(k)));
      CHECK(leaf == left ? pointOf(leaf, k)[0] < 0.5 + 1e-9 : pointOf(leaf, k)[0] > 0.5 - 1e-9);
    }
  }
  CHECK_EQUAL(static_cast<vtkIdType>(sites.size()), count);
  CHECK_EQUAL(*sites.rbegin(), count - 1);
  const auto [leftEdges, rightEdges] = checkStructure(remesher->GetOutputDataObject(Ports::EDGES));
  for (vtkPolyData* leaf : { leftEdges, rightEdges })
  {
    double length = 0.0;
    for (vtkIdType k = 0; k < leaf->GetNumberOfCells(); ++k)
    {
      const Point3 a = pointOf(leaf, leaf->GetCell(k)->GetPointId(0));
      const Point3 b = pointOf(leaf, leaf->GetCell(k)->GetPointId(1));
      const bool isFeature = arrayOf(leaf->GetCellData(), "EdgeType")->GetTuple1(k) == 1.0;
      length += isFeature && a[0] == 0.5 && b[0] == 0.5 ? std::abs(a[1] - b[1]) : 0.0;
    }
    CHECK_NEAR(length, 1.0, 1e-9);
  }
}

void testStructure()
{
  const Nested input;
  vtkNew<vtkAnisotropicRemesher> remesher;
  setQuick(remesher);
  remesher->SetInputDataObject(input.root);
  const Messages messages(remesher);
  remesher->Update();
  CHECK(messages.errors().empty() && messages.warnings().empty());
  const auto [left, right] = checkStructure(remesher->GetOutputDataObject(0));
  CHECK(left && right);
  if (left && right)
  {
    checkArrays(left, right);
    checkOnePlate(remesher->GetOutputDataObject(0), "nested");
    CHECK_EQUAL(topologyOf(remesher->GetOutputDataObject(0)).points, meshPoints);
    const auto [leftCells, rightCells] = checkStructure(remesher->GetOutputDataObject(1));
    checkCellIds(leftCells, input.left);
    checkCellIds(rightCells, input.right);
    checkSitesAndEdges(remesher);
  }
  CHECK(remesher->GetConvergenceOutput() != nullptr);
}

/** A surface that is all in one block gives what it gives alone. */
void testOneBlock()
{
  const vtkSmartPointer<vtkPolyData> surface = polyDataOf(ellipsoid(3));
  addPointArray<vtkDoubleArray>(surface, "T", 1, [](const Point3& p, int) { return p[0] + p[2]; });
  addConstant<vtkIntArray>(surface->GetCellData(), "C", surface->GetNumberOfCells(), 1);
  vtkNew<vtkAnisotropicRemesher> remesher;
  setQuick(remesher);
  remesher->SetInputDataObject(surface);
  remesher->Update();
  const std::vector<Content> expected = contentsOf(remesher);
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, surface);
  const vtkSmartPointer<vtkMultiBlockDataSet> blocks = blocksOf({ surface });
  for (vtkDataObject* input :
    std::initializer_list<vtkDataObject*>{ collection.Get(), blocks.Get() })
  {
    remesher->SetInputDataObject(input);
    remesher->Update();
    for (int port : { 0, 1, 2, 4 })
    {
      CHECK(
        std::string(remesher->GetOutputDataObject(port)->GetClassName()) == input->GetClassName());
      const auto leaves = leavesOf(remesher->GetOutputDataObject(port));
      CHECK_EQUAL(leaves.size(), 1u);
      checkSame(contentOf(leaves.at(0)), expected[port], "port " + std::to_string(port));
    }
    checkSame(contentOf(remesher->GetConvergenceOutput()), expected[3], "port 3");
  }
  // And back: the outputs change their class with the input.
  remesher->SetInputDataObject(surface);
  remesher->Update();
  checkSame(contentsOf(remesher), expected, "again");
}

/** Between partitions of one data set is no feature; between those of two there is. */
void testPartitions()
{
  const Halves halves(24);
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, halves.left);
  partitions->SetPartition(1, halves.right);
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, halves.left);
  collection->SetPartition(1, 0, halves.right);
  collection->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "right");
  vtkNew<vtkAnisotropicRemesher> remesher;
  setQuick(remesher);
  remesher->SetInputDataObject(partitions);
  remesher->Update();
  vtkDataObject* output = remesher->GetOutputDataObject(0);
  CHECK(std::string(output->GetClassName()) == "vtkPartitionedDataSet");
  CHECK_EQUAL(leavesOf(output).size(), 2u);
  checkOnePlate(output, "partitions");
  CHECK_EQUAL(topologyOf(output).points, meshPoints);
  CHECK(lengthOnSeam(leavesOf(output).at(0)) < 0.5);
  remesher->SetInputDataObject(collection);
  remesher->Update();
  output = remesher->GetOutputDataObject(0);
  CHECK(std::string(output->GetClassName()) == "vtkPartitionedDataSetCollection");
  checkOnePlate(output, "collection");
  CHECK_NEAR(lengthOnSeam(leavesOf(output).at(0)), 1.0, 1e-9);
  auto* made = vtkPartitionedDataSetCollection::SafeDownCast(output);
  CHECK(made && made->HasMetaData(1u) &&
    std::string(made->GetMetaData(1u)->Get(vtkCompositeDataSet::NAME())) == "right");
}

/** Labels of the cells and blocks are features together. */
void testLabels()
{
  const Halves halves(24);
  for (vtkPolyData* half : { halves.left.Get(), halves.right.Get() })
  {
    vtkNew<vtkIntArray> labels;
    labels->SetName("Label");
    for (vtkIdType cell = 0; cell < half->GetNumberOfCells(); ++cell)
    {
      vtkCell* triangle = half->GetCell(cell);
      double y = 0.0;
      for (vtkIdType k = 0; k < 3; ++k)
      {
        y += pointOf(half, triangle->GetPointId(k))[1] / 3.0;
      }
      labels->InsertNextValue(y < 0.5 ? 0 : 1);
    }
    half->GetCellData()->AddArray(labels);
  }
  vtkNew<vtkAnisotropicRemesher> remesher;
  setQuick(remesher);
  remesher->SetFeatureLabelArray("Label");
  remesher->SetInputDataObject(blocksOf({ halves.left, halves.right }));
  remesher->Update();
  for (vtkPolyData* leaf : leavesOf(remesher->GetOutputDataObject(0)))
  {
    CHECK_NEAR(lengthOnSeam(leaf), 1.0, 1e-9);
    int onLine = 0;
    for (vtkIdType k = 0; k < leaf->GetNumberOfPoints(); ++k)
    {
      onLine += std::abs(pointOf(leaf, k)[1] - 0.5) < 1e-9 ? 1 : 0;
    }
    CHECK(onLine > 5);
  }
  halves.right->GetCellData()->RemoveArray("Label");
  remesher->SetInputDataObject(blocksOf({ halves.left, halves.right }));
  const Messages messages(remesher);
  remesher->Update();
  CHECK(messages.errors().size() == 1 &&
    messages.errors()[0].find("Not all blocks of the input have the cell array \"Label\"") !=
      std::string::npos);
  CHECK_EQUAL(leavesOf(remesher->GetOutputDataObject(0)).size(), 2u);
}

/** Nothing in it is no error. */
void testEmpty()
{
  vtkNew<vtkAnisotropicRemesher> remesher;
  const Messages messages(remesher);
  vtkNew<vtkPolyData> empty;
  for (const auto& blocks : { blocksOf({}), blocksOf({ nullptr, nullptr }), blocksOf({ empty }) })
  {
    remesher->SetInputDataObject(blocks);
    remesher->Update();
    auto* output = vtkMultiBlockDataSet::SafeDownCast(remesher->GetOutputDataObject(0));
    CHECK(output && output->GetNumberOfBlocks() == blocks->GetNumberOfBlocks());
    CHECK_EQUAL(output->GetNumberOfPoints(), 0);
  }
  CHECK(messages.errors().empty() && messages.warnings().empty());
}
}

int TestComposite(int, char*[])
{
  testNoGaps();
  testWithoutFeatures();
  testFold();
  testStructure();
  testOneBlock();
  testPartitions();
  testLabels();
  testEmpty();
  return result();
}
