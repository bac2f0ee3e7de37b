/**
 * @file TestBlocks.h
 * @brief Surfaces cut into blocks, and what comes out of them put together again.
 */
#ifndef TestBlocks_h
#define TestBlocks_h

#include "TestBytes.h"

#include "Comparison/MeshTopology.h"
#include "Mesh/Weld.h"

#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnstructuredGrid.h"

#include <functional>

namespace remesh::test
{
/** The triangles for which `isIn(centroid)`, with points of their own. */
inline vtkSmartPointer<vtkPolyData> partOf(
  const TriangleSoup& soup, const std::function<bool(const Point3&)>& isIn)
{
  TriangleSoup part;
  std::map<Offset, Offset> numbers;
  for (auto triangle : soup.triangles)
  {
    const Point3 middle =
      (soup.points[triangle[0]] + soup.points[triangle[1]] + soup.points[triangle[2]]) / 3.0;
    if (!isIn(middle))
    {
      continue;
    }
    for (Offset& id : triangle)
    {
      const auto [found, isNew] = numbers.emplace(id, static_cast<Offset>(part.points.size()));
      if (isNew)
      {
        part.points.push_back(soup.points[id]);
      }
      id = found->second;
    }
    part.triangles.push_back(triangle);
  }
  return polyDataOf(part);
}

/** A wavy plate over the unit square. */
inline TriangleSoup wavySoup(int size)
{
  TriangleSoup soup = gridPatch(size, size);
  for (Point3& p : soup.points)
  {
    p[2] = 0.1 * std::sin(5.0 * p[0] + 1.0) * std::sin(4.0 * p[1]);
  }
  return soup;
}

/** Two halves that touch along x = 0.5, where the plate goes on smoothly. */
struct Halves
{
  TriangleSoup soup;
  vtkSmartPointer<vtkPolyData> left;
  vtkSmartPointer<vtkPolyData> right;

  explicit Halves(int size)
    : soup(wavySoup(size))
    , left(partOf(soup, [](const Point3& p) { return p[0] < 0.5; }))
    , right(partOf(soup, [](const Point3& p) { return p[0] >= 0.5; }))
  {
  }
};

template <class Array>
void addConstant(vtkFieldData* data, const char* name, vtkIdType tuples, double value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(tuples);
  array->Fill(value);
  data->AddArray(array);
}

/** A block with a name, or an unnamed one. */
inline void putBlock(vtkMultiBlockDataSet* blocks, unsigned int index, vtkDataObject* block,
  const char* name = nullptr)
{
  blocks->SetBlock(index, block);
  if (name)
  {
    blocks->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), name);
  }
}

inline vtkSmartPointer<vtkMultiBlockDataSet> blocksOf(const std::vector<vtkDataObject*>& leaves)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t k = 0; k < leaves.size(); ++k)
  {
    blocks->SetBlock(static_cast<unsigned int>(k), leaves[k]);
  }
  return blocks;
}

/** All leaves but null ones. */
inline std::vector<vtkPolyData*> leavesOf(vtkDataObject* data)
{
  std::vector<vtkPolyData*> leaves;
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  CHECK(composite != nullptr);
  if (composite)
  {
    auto each = vtk::TakeSmartPointer(composite->NewIterator());
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    {
      auto* leaf = vtkPolyData::SafeDownCast(each->GetCurrentDataObject());
      CHECK(leaf != nullptr);
      if (leaf)
      {
        leaves.push_back(leaf);
      }
    }
  }
  return leaves;
}

/** The polygons of all leaves, which are triangles, with points of equal coordinates merged. */
inline MeshTopology topologyOf(vtkDataObject* data)
{
  std::vector<Point3> points;
  std::vector<Triple> triangles;
  for (vtkPolyData* leaf : leavesOf(data))
  {
    const auto first = static_cast<Index>(points.size());
    for (vtkIdType k = 0; k < leaf->GetNumberOfPoints(); ++k)
    {
      points.push_back(pointOf(leaf, k));
    }
    auto each = vtk::TakeSmartPointer(leaf->GetPolys()->NewIterator());
    for (each->GoToFirstCell(); !each->IsDoneWithTraversal(); each->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      each->GetCurrentCell(size, ids);
      CHECK_EQUAL(size, 3);
      triangles.push_back({ first + static_cast<Index>(ids[0]), first + static_cast<Index>(ids[1]),
        first + static_cast<Index>(ids[2]) });
    }
  }
  const std::vector<Index> lowest = weldEqualPoints(points);
  for (Triple& triangle : triangles)
  {
    triangle = { lowest[triangle[0]], lowest[triangle[1]], lowest[triangle[2]] };
  }
  MeshTopology topology;
  CHECK(measureTopology({ points, triangles }, {}, topology).ok());
  return topology;
}

/** The same cells as an unstructured grid. */
inline vtkSmartPointer<vtkUnstructuredGrid> gridOf(vtkPolyData* surface)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(surface->GetPoints());
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    surface->GetCellPoints(cell, ids);
    grid->InsertNextCell(surface->GetCellType(cell), ids);
  }
  grid->GetPointData()->ShallowCopy(surface->GetPointData());
  grid->GetCellData()->ShallowCopy(surface->GetCellData());
  grid->GetFieldData()->ShallowCopy(surface->GetFieldData());
  return grid;
}
}

#endif
