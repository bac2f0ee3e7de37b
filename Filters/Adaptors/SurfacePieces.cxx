#include "Adaptors/SurfacePieces.h"

#include "vtkAppendFilter.h"
#include "vtkAppendPolyData.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace remesh
{
namespace
{
/** Marks all cells that no surface has as those that RemoveGhostCells() removes. */
template <class DataSet>
vtkSmartPointer<vtkDataObject> removeGhosts(DataSet* piece)
{
  vtkUnsignedCharArray* ghosts = piece->GetCellGhostArray();
  const bool isMarked = ghosts && ghosts->GetNumberOfTuples() == piece->GetNumberOfCells();
  if (!isMarked && !piece->GetPointGhostArray())
  {
    return piece;
  }
  auto rest = vtkSmartPointer<DataSet>::New();
  rest->ShallowCopy(piece);
  if (isMarked)
  {
    constexpr int left = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL |
      vtkDataSetAttributes::HIDDENCELL;
    vtkNew<vtkUnsignedCharArray> marks;
    marks->DeepCopy(ghosts);
    for (vtkIdType cell = 0; cell < marks->GetNumberOfTuples(); ++cell)
    {
      const bool isLeft = (marks->GetValue(cell) & left) != 0;
      marks->SetValue(cell, isLeft ? vtkDataSetAttributes::DUPLICATECELL : 0);
    }
    rest->GetCellData()->AddArray(marks);
    rest->RemoveGhostCells();
  }
  rest->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  rest->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  return rest;
}

/** The pieces one after the other, by one of VTK's filters for that. */
template <class Filter>
vtkSmartPointer<vtkDataObject> append(const std::vector<vtkDataObject*>& pieces)
{
  vtkNew<Filter> filter;
  for (vtkDataObject* piece : pieces)
  {
    filter->AddInputDataObject(piece);
  }
  filter->Update();
  vtkSmartPointer<vtkDataObject> joined;
  joined.TakeReference(filter->GetOutput()->NewInstance());
  joined->ShallowCopy(filter->GetOutput());
  return joined;
}

/** Copies the cells of a range, and names their points. */
class PartCutter
{
public:
  PartCutter(vtkPolyData* whole, vtkIdType begin, vtkIdType end)
    : Whole(whole)
    , Begin(begin)
    , End(end)
    , Numbers(static_cast<std::size_t>(whole->GetNumberOfPoints()), -1)
  {
  }

  vtkSmartPointer<vtkPolyData> Run()
  {
    auto part = vtkSmartPointer<vtkPolyData>::New();
    const std::array<vtkCellArray*, 4> kinds = { this->Whole->GetVerts(), this->Whole->GetLines(),
      this->Whole->GetPolys(), this->Whole->GetStrips() };
    this->ForEachCell(kinds,
      [&](int, vtkIdType size, const vtkIdType* ids)
      { std::for_each(ids, ids + size, [&](vtkIdType id) { this->Numbers[id] = 0; }); });
    this->CopyPoints(part);
    std::array<vtkNew<vtkCellArray>, 4> cells;
    std::vector<vtkIdType> own;
    this->ForEachCell(kinds,
      [&](int kind, vtkIdType size, const vtkIdType* ids)
      {
        own.resize(static_cast<std::size_t>(size));
        std::transform(
          ids, ids + size, own.begin(), [&](vtkIdType id) { return this->Numbers[id]; });
        cells[kind]->InsertNextCell(size, own.data());
      });
    part->SetVerts(cells[0]);
    part->SetLines(cells[1]);
    part->SetPolys(cells[2]);
    part->SetStrips(cells[3]);
    copyRows(this->Whole->GetCellData(), this->Begin, this->End, part->GetCellData());
    part->GetFieldData()->ShallowCopy(this->Whole->GetFieldData());
    return part;
  }

private:
  template <class Visit>
  void ForEachCell(const std::array<vtkCellArray*, 4>& kinds, const Visit& visit) const
  {
    vtkIdType first = 0;
    for (int kind = 0; kind < 4; ++kind)
    {
      const vtkIdType count = kinds[kind]->GetNumberOfCells();
      const vtkIdType end = std::min(this->End - first, count);
      for (vtkIdType cell = std::max<vtkIdType>(this->Begin - first, 0); cell < end; ++cell)
      {
        vtkIdType size = 0;
        const vtkIdType* ids = nullptr;
        kinds[kind]->GetCellAtId(cell, size, ids);
        visit(kind, size, ids);
      }
      first += count;
    }
  }

  static void copyRows(
    vtkDataSetAttributes* from, vtkIdType begin, vtkIdType end, vtkDataSetAttributes* to)
  {
    vtkNew<vtkIdList> ids;
    ids->SetNumberOfIds(end - begin);
    std::iota(ids->GetPointer(0), ids->GetPointer(0) + (end - begin), begin);
    copyRows(from, ids, to);
  }

  static void copyRows(vtkDataSetAttributes* from, vtkIdList* ids, vtkDataSetAttributes* to)
  {
    to->CopyAllOn();
    to->CopyAllocate(from, ids->GetNumberOfIds());
    to->SetNumberOfTuples(ids->GetNumberOfIds());
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      to->CopyData(from, ids->GetId(k), k);
    }
  }

  /** Those that are named, numbered in their order. */
  void CopyPoints(vtkPolyData* part)
  {
    vtkNew<vtkIdList> used;
    const bool takesPoints = this->Whole->GetNumberOfCells() == 0;
    for (vtkIdType id = 0; id < this->Whole->GetNumberOfPoints(); ++id)
    {
      const bool isTaken =
        takesPoints ? id >= this->Begin && id < this->End : this->Numbers[id] == 0;
      this->Numbers[id] = isTaken ? used->InsertNextId(id) : -1;
    }
    if (this->Whole->GetPoints())
    {
      vtkNew<vtkPoints> points;
      points->SetDataType(this->Whole->GetPoints()->GetDataType());
      points->SetNumberOfPoints(used->GetNumberOfIds());
      this->Whole->GetPoints()->GetData()->GetTuples(used, points->GetData());
      part->SetPoints(points);
    }
    copyRows(this->Whole->GetPointData(), used, part->GetPointData());
  }

  vtkPolyData* Whole;
  vtkIdType Begin;
  vtkIdType End;
  std::vector<vtkIdType> Numbers; ///< of the whole's points in the part; -1: not in it
};
}

vtkSmartPointer<vtkDataObject> withoutGhosts(vtkDataObject* piece)
{
  if (auto* surface = vtkPolyData::SafeDownCast(piece))
  {
    return removeGhosts(surface);
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(piece))
  {
    return removeGhosts(grid);
  }
  return piece;
}

void roundToZero(vtkDataObject* surface)
{
  constexpr double rounding = 1e-14; // of the diagonal
  vtkPoints* points = vtkPointSet::SafeDownCast(surface)->GetPoints();
  const double limit = rounding * vtkBoundingBox(points->GetBounds()).GetDiagonalLength();
  for (vtkIdType id = 0; id < points->GetNumberOfPoints(); ++id)
  {
    double place[3];
    points->GetPoint(id, place);
    for (double& coordinate : place)
    {
      coordinate = std::abs(coordinate) < limit ? 0.0 : coordinate;
    }
    points->SetPoint(id, place);
  }
}

vtkSmartPointer<vtkDataObject> joinPieces(const std::vector<vtkSmartPointer<vtkDataObject>>& pieces)
{
  std::vector<vtkDataObject*> filled;
  vtkDataObject* first = nullptr;
  bool areSurfaces = true;
  bool areGrids = true;
  for (const auto& piece : pieces)
  {
    first = first ? first : piece.Get();
    if (piece && piece->GetNumberOfElements(vtkDataObject::POINT) > 0)
    {
      filled.push_back(piece);
      areSurfaces = areSurfaces && vtkPolyData::SafeDownCast(piece);
      areGrids = areGrids && vtkUnstructuredGrid::SafeDownCast(piece);
    }
  }
  if (filled.size() < 2 || !(areSurfaces || areGrids))
  {
    return filled.empty() ? first : filled.front();
  }
  vtkSmartPointer<vtkDataObject> joined =
    areSurfaces ? append<vtkAppendPolyData>(filled) : append<vtkAppendFilter>(filled);
  roundToZero(joined);
  for (vtkDataObject* piece : filled)
  {
    vtkFieldData* from = piece->GetFieldData();
    for (int k = 0; k < from->GetNumberOfArrays(); ++k)
    {
      const char* name = from->GetAbstractArray(k)->GetName();
      if (name && !joined->GetFieldData()->HasArray(name))
      {
        joined->GetFieldData()->AddArray(from->GetAbstractArray(k));
      }
    }
  }
  return joined;
}

vtkSmartPointer<vtkPolyData> cutPart(vtkPolyData* whole, int part, int numberOfParts)
{
  const vtkIdType cells = whole->GetNumberOfCells();
  const vtkIdType count = cells > 0 ? cells : whole->GetNumberOfPoints();
  return PartCutter(whole, count * part / numberOfParts, count * (part + 1) / numberOfParts).Run();
}
}
