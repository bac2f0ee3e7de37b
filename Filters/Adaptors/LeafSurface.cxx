#include "Adaptors/LeafSurface.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace remesh
{
namespace
{
const std::string advice = " Take its surface first: with Extract Surface in ParaView, with "
                           "vtkDataSetSurfaceFilter in VTK.";

enum class CellKind
{
  Polygon,
  Pixel,
  Strip,
  Ignored,
  Other
};

CellKind kindOf(int type)
{
  switch (type)
  {
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_POLYGON:
      return CellKind::Polygon;
    case VTK_PIXEL:
      return CellKind::Pixel;
    case VTK_TRIANGLE_STRIP:
      return CellKind::Strip;
    case VTK_EMPTY_CELL:
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
    case VTK_LINE:
    case VTK_POLY_LINE:
      return CellKind::Ignored;
    default:
      return CellKind::Other;
  }
}

/** What is known of a grid's cells before any is read. */
struct GridCells
{
  bool arePolygons = true; ///< in the order of their points
  vtkIdType others = 0;
  vtkIdType firstOther = -1;

  explicit GridCells(vtkUnstructuredGrid* grid)
  {
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      const CellKind kind = kindOf(grid->GetCellType(cell));
      this->arePolygons = this->arePolygons && kind == CellKind::Polygon;
      if (kind == CellKind::Other)
      {
        this->firstOther = this->others == 0 ? cell : this->firstOther;
        ++this->others;
      }
    }
  }
};

std::string describeCell(int type)
{
  const auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
  return cell ? std::string("a ") + cell->GetClassName() : "of type " + std::to_string(type);
}

/** Polygons and strips cell by cell, with their ids. */
void copyCells(vtkUnstructuredGrid* grid, LeafSurface& result)
{
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkCellArray> strips;
  std::vector<vtkIdType> ids;
  std::vector<vtkIdType> stripIds;
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const CellKind kind = kindOf(grid->GetCellType(cell));
    if (kind == CellKind::Ignored)
    {
      continue;
    }
    grid->GetCellPoints(cell, points);
    if (kind == CellKind::Pixel && points->GetNumberOfIds() == 4)
    {
      const vtkIdType third = points->GetId(2); // row by row there, around here
      points->SetId(2, points->GetId(3));
      points->SetId(3, third);
    }
    (kind == CellKind::Strip ? strips : polygons)->InsertNextCell(points);
    (kind == CellKind::Strip ? stripIds : ids).push_back(cell);
  }
  result.surface->SetPolys(polygons);
  result.surface->SetStrips(strips);
  ids.insert(ids.end(), stripIds.begin(), stripIds.end());
  bool asTheyAre = static_cast<vtkIdType>(ids.size()) == grid->GetNumberOfCells();
  for (std::size_t k = 0; asTheyAre && k < ids.size(); ++k)
  {
    asTheyAre = ids[k] == static_cast<vtkIdType>(k);
  }
  if (!asTheyAre)
  {
    result.cellIds = vtkSmartPointer<vtkIdTypeArray>::New();
    result.cellIds->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
    std::copy(ids.begin(), ids.end(), result.cellIds->GetPointer(0));
  }
}

Status readGrid(vtkUnstructuredGrid* grid, const std::string& subject, LeafSurface& result)
{
  const GridCells cells(grid);
  if (cells.others > 0)
  {
    return Status::invalid(subject +
      " is an unstructured grid with cells that are no triangles, "
      "quadrilaterals or polygons: " +
      std::to_string(cells.others) + " of " + std::to_string(grid->GetNumberOfCells()) +
      ", the first, cell " + std::to_string(cells.firstOther) + ", is " +
      describeCell(grid->GetCellType(cells.firstOther)) + "." + advice);
  }
  result.surface->SetPoints(grid->GetPoints());
  result.surface->GetPointData()->ShallowCopy(grid->GetPointData());
  result.surface->GetFieldData()->ShallowCopy(grid->GetFieldData());
  result.cellData = grid->GetCellData();
  result.numberOfCells = grid->GetNumberOfCells();
  if (cells.arePolygons)
  {
    result.surface->SetPolys(grid->GetCells());
  }
  else
  {
    copyCells(grid, result);
  }
  return Status::success();
}

void readPolyData(vtkPolyData* leaf, LeafSurface& result)
{
  result.surface->SetPoints(leaf->GetPoints());
  result.surface->GetPointData()->ShallowCopy(leaf->GetPointData());
  result.surface->GetFieldData()->ShallowCopy(leaf->GetFieldData());
  result.surface->SetPolys(leaf->GetPolys());
  result.surface->SetStrips(leaf->GetStrips());
  result.cellData = leaf->GetCellData();
  result.numberOfCells = leaf->GetNumberOfCells();
  const vtkIdType first = leaf->GetNumberOfVerts() + leaf->GetNumberOfLines();
  if (first > 0)
  {
    result.cellIds = vtkSmartPointer<vtkIdTypeArray>::New();
    result.cellIds->SetNumberOfValues(leaf->GetNumberOfPolys() + leaf->GetNumberOfStrips());
    vtkIdType* ids = result.cellIds->GetPointer(0);
    std::iota(ids, ids + result.cellIds->GetNumberOfValues(), first);
  }
}
}

Status readLeaf(vtkDataObject* leaf, const std::string& subject, LeafSurface& result)
{
  result = { vtkSmartPointer<vtkPolyData>::New(), nullptr, 0, nullptr };
  if (auto* polyData = vtkPolyData::SafeDownCast(leaf))
  {
    readPolyData(polyData, result);
    return Status::success();
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(leaf))
  {
    return readGrid(grid, subject, result);
  }
  if (vtkTable::SafeDownCast(leaf))
  {
    return Status::invalid(subject +
      " is a table (vtkTable), which has no surface: a mesh of "
      "triangles or polygons is needed, as Extract Surface in ParaView or vtkDataSetSurfaceFilter "
      "in VTK makes of a volume.");
  }
  return Status::invalid(
    subject + " is a " + leaf->GetClassName() + ", no surface of polygons." + advice);
}
}
