/**
 * @file SurfaceIntake.cxx
 *
 * 1. Copy the points.
 * 2. Polygons: if all are triangles, copy the connectivity; else cut them one by one.
 * 3. Strips: every second triangle turns the other way round.
 * 4. Take the triangles of ghost cells out again.
 *
 * Point ids are checked cell by cell, before anything reads the points. After each cell there are
 * as many cell ids as triangles, and both are in the order of the cells. Cost: one pass over the
 * points, the cells and the triangles each, and what PolygonTriangulator takes.
 */
#include "Adaptors/SurfaceIntake.h"

#include "Adaptors/PolygonTriangulator.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <string>

namespace remesh
{
namespace
{
struct CopyPoints
{
  template <class ArrayType>
  void operator()(ArrayType* array, std::vector<Point3>& points) const
  {
    const auto tuples = vtk::DataArrayTupleRange<3>(array);
    auto point = points.begin();
    for (const auto tuple : tuples)
    {
      *point++ = Point3(static_cast<double>(tuple[0]), static_cast<double>(tuple[1]),
        static_cast<double>(tuple[2]));
    }
  }
};

void copyPoints(vtkPolyData* input, std::vector<Point3>& points)
{
  points.resize(input->GetNumberOfPoints());
  if (points.empty())
  {
    return;
  }
  vtkDataArray* array = input->GetPoints()->GetData();
  using Dispatcher = vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>;
  if (!Dispatcher::Execute(array, CopyPoints{}, points))
  {
    CopyPoints{}(array, points);
  }
}

Status checkArray(vtkCellArray* cells, const std::string& kind)
{
  return cells->IsValid()
    ? Status::success()
    : Status::invalid("The " + kind + "' offsets and connectivity contradict each other.");
}

Status checkIds(Offset cell, vtkIdType size, const vtkIdType* ids, Offset numberOfPoints)
{
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (ids[i] < 0 || ids[i] >= numberOfPoints)
    {
      return Status::invalid("Cell " + std::to_string(cell) + " refers to point " +
        std::to_string(ids[i]) + ", but the surface has " + std::to_string(numberOfPoints) +
        " points.");
    }
  }
  return Status::success();
}

/** Calls `append(size, ids)` for each cell, which adds its triangles to the soup. */
template <class Append>
Status readCells(vtkCellArray* cells, Offset firstCell, const Append& append, TriangleSoup& soup)
{
  const auto numberOfPoints = static_cast<Offset>(soup.points.size());
  Offset cell = firstCell;
  auto each = vtk::TakeSmartPointer(cells->NewIterator());
  for (each->GoToFirstCell(); !each->IsDoneWithTraversal(); each->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    each->GetCurrentCell(size, ids);
    if (Status status = checkIds(cell, size, ids, numberOfPoints); !status.ok())
    {
      return status;
    }
    append(size, ids);
    soup.inputCells.resize(soup.triangles.size(), cell);
  }
  return Status::success();
}

/** False if a point id is out of range; then nothing of use was copied. */
template <class ArrayType>
bool copyTriangles(ArrayType* connectivity, Offset count, Offset firstCell, TriangleSoup& soup)
{
  const auto numberOfPoints = static_cast<Offset>(soup.points.size());
  const auto ids = vtk::DataArrayValueRange<1>(connectivity);
  soup.triangles.resize(static_cast<std::size_t>(count));
  soup.inputCells.resize(static_cast<std::size_t>(count));
  auto id = ids.begin();
  for (Offset t = 0; t < count; ++t)
  {
    for (Offset& point : soup.triangles[t])
    {
      point = static_cast<Offset>(*id++);
      if (point < 0 || point >= numberOfPoints)
      {
        return false;
      }
    }
    soup.inputCells[t] = firstCell + t;
  }
  return true;
}

/** False if the polygons are not all triangles, or not all sound. */
bool copyTriangles(vtkCellArray* polygons, Offset firstCell, TriangleSoup& soup)
{
  if (polygons->IsHomogeneous() != 3)
  {
    return false;
  }
  const Offset count = polygons->GetNumberOfCells();
  vtkDataArray* connectivity = polygons->GetConnectivityArray();
  if (auto* ids64 = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(connectivity))
  {
    return copyTriangles(ids64, count, firstCell, soup);
  }
  auto* ids32 = vtkAOSDataArrayTemplate<vtkTypeInt32>::FastDownCast(connectivity);
  return ids32 != nullptr && copyTriangles(ids32, count, firstCell, soup);
}

/** @param crossing gets the number of polygons whose triangles overlap. */
Status readPolygons(vtkPolyData* input, TriangleSoup& soup, Offset& crossing)
{
  vtkCellArray* polygons = input->GetPolys();
  const Offset firstCell = input->GetNumberOfVerts() + input->GetNumberOfLines();
  crossing = 0;
  if (Status status = checkArray(polygons, "polygons"); !status.ok())
  {
    return status;
  }
  if (copyTriangles(polygons, firstCell, soup))
  {
    return Status::success();
  }
  soup.triangles.clear();
  soup.inputCells.clear();
  PolygonTriangulator triangulator(soup.points);
  const auto append = [&](vtkIdType size, const vtkIdType* ids)
  { crossing += triangulator.AppendTriangles(size, ids, soup.triangles) ? 0 : 1; };
  return readCells(polygons, firstCell, append, soup);
}

Status readStrips(vtkPolyData* input, TriangleSoup& soup)
{
  vtkCellArray* strips = input->GetStrips();
  const Offset firstCell =
    input->GetNumberOfVerts() + input->GetNumberOfLines() + input->GetNumberOfPolys();
  if (Status status = checkArray(strips, "strips"); !status.ok())
  {
    return status;
  }
  const auto append = [&](vtkIdType size, const vtkIdType* ids)
  {
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const vtkIdType odd = i % 2;
      soup.triangles.push_back({ ids[i], ids[i + 1 + odd], ids[i + 2 - odd] });
    }
  };
  return readCells(strips, firstCell, append, soup);
}

/**
 * Leaves out the triangles of ghost cells: what is hidden, and what another process has as its own
 * (as VTK's filters that measure or draw surfaces do).
 */
void removeGhosts(vtkPolyData* input, TriangleSoup& soup)
{
  vtkUnsignedCharArray* ghosts = input->GetCellGhostArray();
  if (!ghosts || ghosts->GetNumberOfTuples() != input->GetNumberOfCells() ||
    ghosts->GetNumberOfComponents() != 1)
  {
    return;
  }
  constexpr int left = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL |
    vtkDataSetAttributes::HIDDENCELL;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    if ((ghosts->GetValue(soup.inputCells[t]) & left) == 0)
    {
      soup.triangles[kept] = soup.triangles[t];
      soup.inputCells[kept++] = soup.inputCells[t];
    }
  }
  soup.triangles.resize(kept);
  soup.inputCells.resize(kept);
}
}

SurfaceSource sourceOf(vtkPolyData* input)
{
  const bool isSingle = input->GetPoints() && input->GetPoints()->GetDataType() == VTK_FLOAT;
  return { [input](TriangleSoup& soup, std::string& warning)
    { return readTriangleSoup(input, soup, &warning); },
    input->GetNumberOfPoints(), isSingle ? FLT_EPSILON : DBL_EPSILON };
}

Status checkForPolygons(vtkPolyData* input)
{
  if (input == nullptr)
  {
    return Status::invalid("There is no input surface.");
  }
  if (input->GetNumberOfPoints() == 0 && input->GetNumberOfCells() == 0)
  {
    return Status::empty("The surface has no points and no cells.");
  }
  if (input->GetNumberOfPolys() == 0 && input->GetNumberOfStrips() == 0)
  {
    return Status::invalid("The input has no polygons and no triangle strips, only " +
      std::to_string(input->GetNumberOfPoints()) + " points, " +
      std::to_string(input->GetNumberOfVerts()) + " vertices and " +
      std::to_string(input->GetNumberOfLines()) + " lines.");
  }
  return Status::success();
}

Status readTriangleSoup(vtkPolyData* input, TriangleSoup& soup, std::string* warning)
{
  soup = TriangleSoup();
  if (Status found = checkForPolygons(input); !found.ok())
  {
    return found;
  }
  copyPoints(input, soup.points);
  Offset crossing = 0;
  Status status =
    input->GetNumberOfPolys() > 0 ? readPolygons(input, soup, crossing) : Status::success();
  if (status.ok() && input->GetNumberOfStrips() > 0)
  {
    status = readStrips(input, soup);
  }
  if (!status.ok())
  {
    soup = TriangleSoup();
    return status;
  }
  if (warning && crossing > 0)
  {
    *warning = std::to_string(crossing) + " polygons cross themselves: their triangles overlap.";
  }
  removeGhosts(input, soup);
  return soup.triangles.empty() && input->GetCellGhostArray()
    ? Status::empty("All cells of the surface are ghosts.")
    : Status::success();
}
}
