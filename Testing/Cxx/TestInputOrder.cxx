// The outputs are those of the surface: neither the order of points and cells counts, nor with
// which corner a cell starts, nor whether points are there twice.

#include "TestBytes.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPolyDataNormals.h"
#include "vtkRestrictedVoronoiDiagram.h"

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

/** Squares that are not cut, whose diagonals are alike, over a wavy sheet. */
vtkSmartPointer<vtkPolyData> quads(int n)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int i = 0; i <= n; ++i)
  {
    for (int k = 0; k <= n; ++k)
    {
      points->InsertNextPoint(i, k, (i + k) % 3 - 1);
    }
  }
  for (vtkIdType i = 0; i < n; ++i)
  {
    for (vtkIdType k = 0; k < n; ++k)
    {
      const vtkIdType id = i * (n + 1) + k;
      cells->InsertNextCell({ id, id + n + 1, id + n + 2, id + 1 });
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

vtkSmartPointer<vtkPolyData> boxes(bool touch)
{
  TriangleSoup soup = cube();
  append(soup, cube(), touch ? Point3(1, 1, 1) : Point3(1, 1, 0)); // at a corner, or an edge
  return polyDataOf(soup);
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

struct Case
{
  const char* name;
  vtkSmartPointer<vtkPolyData> surface;
  const char* labels;
};

std::vector<Case> makeCases()
{
  TriangleSoup folded = patchWithFlap();
  TriangleSoup repeated = icosphere(2);
  for (std::size_t t = 0; t < 20; ++t)
  {
    auto [a, b, c] = repeated.triangles[3 * t];
    repeated.triangles.push_back(t % 2 == 0 ? std::array{ b, c, a } : std::array{ c, b, a });
  }
  std::vector<Case> cases = { { "sphere", polyDataOf(icosphere(3)), nullptr },
    { "boxes at an edge", boxes(false), nullptr }, { "boxes at a corner", boxes(true), nullptr },
    { "plate", bumpyPlate(20, 0.1, 7.0), nullptr }, { "quads", quads(12), nullptr },
    { "three sheets", polyDataOf(threeSheets()), nullptr }, { "flap", polyDataOf(folded), nullptr },
    { "strip", polyDataOf(moebiusStrip(30)), nullptr },
    { "repeated triangles", polyDataOf(repeated), nullptr },
    { "labels", polyDataOf(icosphere(3)), "Labels" } };
  for (Case& each : cases)
  {
    addArrays(each.surface);
  }
  cases.push_back({ "normals", withNormals(boxes(false)), nullptr });
  cases.push_back({ "labels and normals", withNormals(cases[0].surface), "Labels" });
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
  vtkNew<vtkAnisotropicRemesher> remesher;
  remesher->SetNumberOfPoints(150);
  remesher->SetNumberOfNewtonIterations(5);
  remesher->SetFeatureLabelArray(each.labels);
  remesher->GenerateVoronoiCellsOn();
  remesher->GenerateEdgesOn();
  remesher->SetInputData(each.surface);
  remesher->Update();
  const std::vector<Content> expected = outputsOf(remesher);
  CHECK(remesher->GetOutput()->GetNumberOfCells() > 0);
  for (const unsigned int seed : { 1u, 2u, 3u })
  {
    remesher->SetInputData(shuffle(each.surface, seed == 3, seed));
    remesher->Update();
    checkSame(outputsOf(remesher), expected, std::string(each.name) + std::to_string(seed));
  }
}
}

int TestInputOrder(int, char*[])
{
  for (const Case& each : makeCases())
  {
    testRemesher(each);
  }
  return result();
}
