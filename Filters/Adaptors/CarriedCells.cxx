/**
 * @file CarriedCells.cxx
 *
 * For each triangle:
 * 1. The input's cells under the pieces of its three cells; where an array has one value on all of
 *    them, that is it.
 * 2. Else the area of each such cell under the triangle, and for each array the sum of the areas
 *    with equal values, in the order of the cells' ids.
 * All that is kept is, for each array and triangle, a cell that has the value.
 */
#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/CarriedArrays.h"
#include "Adaptors/CellOrder.h"
#include "Delaunay/TriangleCover.h"

#include "vtkCellData.h"
#include "vtkIdList.h"

namespace remesh
{
namespace
{
struct CellShare
{
  vtkIdType cell;
  double area;
};

/** The value with the largest area, as the lowest cell that has it. */
vtkIdType chooseCell(
  const std::vector<CellShare>& shares, const CellOrder& order, std::vector<CellShare>& scratch)
{
  constexpr double equal = 1.0 - 1e-9; // shares that differ by rounding alone
  scratch = shares;
  std::stable_sort(scratch.begin(), scratch.end(),
    [&](const CellShare& a, const CellShare& b) { return order(a.cell, b.cell) < 0; });
  std::size_t groups = 0;
  double largest = 0.0;
  for (std::size_t k = 0; k < scratch.size(); ++k)
  {
    if (groups > 0 && order(scratch[groups - 1].cell, scratch[k].cell) == 0)
    {
      scratch[groups - 1].area += scratch[k].area;
    }
    else
    {
      scratch[groups++] = scratch[k];
    }
    largest = std::max(largest, scratch[groups - 1].area);
  }
  vtkIdType best = -1;
  for (std::size_t k = 0; k < groups; ++k)
  {
    if (scratch[k].area >= equal * largest && (best < 0 || scratch[k].cell < best))
    {
      best = scratch[k].cell;
    }
  }
  return best;
}

/** Finds the cells whose values the triangles of one block take; one per block. */
class CellChooser
{
public:
  CellChooser(const DiagramSource& source, const std::vector<CellOrder>& orders)
    : Source(source)
    , Orders(orders)
    , Cover{ source.prepared.mesh, source.result.components,
      { source.surface(), source.result.sites, source.result.diagram } }
  {
  }

  /** Calls `choose(array, cell)` for each array; with a block, only its cells count. */
  template <class Choose>
  void Run(const Triple& triangle, const int* block, const Choose& choose)
  {
    this->FindCells(triangle);
    this->KeepBlock(block, this->Cells, [](vtkIdType cell) { return cell; });
    bool measured = false;
    for (std::size_t array = 0; array < this->Orders.size(); ++array)
    {
      const CellOrder& order = this->Orders[array];
      const vtkIdType first = this->Cells.front();
      const bool isUniform = std::all_of(this->Cells.begin(), this->Cells.end(),
        [&](vtkIdType cell) { return order(first, cell) == 0; });
      if (!isUniform && !measured)
      {
        this->Measure(triangle);
        this->KeepBlock(block, this->Shares, [](const CellShare& share) { return share.cell; });
        measured = true;
      }
      choose(array, isUniform ? first : chooseCell(this->Shares, order, this->Scratch));
    }
  }

private:
  vtkIdType CellOf(Index facet) const { return this->Source.prepared.mesh.facetInputCells[facet]; }

  /** The input's cells that the three cells reach, ascending; at least one. */
  void FindCells(const Triple& triangle)
  {
    this->Cells.clear();
    this->Cover.forEachPiece(triangle,
      [&](Index piece)
      { this->Cells.push_back(this->CellOf(this->Source.result.diagram.facets[piece])); });
    if (this->Cells.empty())
    {
      this->Cells.push_back(this->CellOf(this->Source.result.locations[triangle[0]].facet));
    }
    std::sort(this->Cells.begin(), this->Cells.end());
    this->Cells.erase(std::unique(this->Cells.begin(), this->Cells.end()), this->Cells.end());
  }

  template <class Items, class CellOfItem>
  void KeepBlock(const int* block, Items& items, const CellOfItem& cellOf) const
  {
    if (block)
    {
      items.erase(
        std::remove_if(items.begin(), items.end(),
          [&](const auto& item) { return this->Source.cellBlocks[cellOf(item)] != *block; }),
        items.end());
    }
  }

  void Measure(const Triple& triangle)
  {
    std::array<Point3, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = this->Source.result.placement.positions[triangle[k]];
    }
    this->Cover.measure(triangle, corners, this->Parts);
    this->Shares.clear();
    for (const CoverPart& part : this->Parts)
    {
      this->Shares.push_back({ this->CellOf(part.facet), part.area });
    }
    std::stable_sort(this->Shares.begin(), this->Shares.end(),
      [](const CellShare& a, const CellShare& b) { return a.cell < b.cell; });
  }

  const DiagramSource& Source;
  const std::vector<CellOrder>& Orders;
  TriangleCover Cover;
  std::vector<vtkIdType> Cells;
  std::vector<CoverPart> Parts;
  std::vector<CellShare> Shares; ///< by cell, which may come several times
  std::vector<CellShare> Scratch;
};
}

void carryCellArrays(const DiagramSource& source, const std::vector<int>& blocks,
  vtkPolyData* output, LostArrays& lost)
{
  const std::vector<Triple>& triangles = source.result.dual.triangles;
  const auto count = static_cast<Offset>(triangles.size());
  const std::vector<CarriedArray> arrays = makeCarriedArrays(source.input->GetCellData(),
    source.input->GetNumberOfCells(), OwnArrays{}, count, output->GetCellData(), lost);
  if (arrays.empty() || count == 0)
  {
    return;
  }
  std::vector<CellOrder> orders;
  std::vector<vtkNew<vtkIdList>> cells(arrays.size());
  std::vector<vtkIdType*> chosen;
  for (std::size_t k = 0; k < arrays.size(); ++k)
  {
    orders.push_back(orderOf(arrays[k].source));
    cells[k]->SetNumberOfIds(count);
    chosen.push_back(cells[k]->GetPointer(0));
  }
  const bool done = forEachRange(Blocks::cut(count, 256, 4096), source.control,
    [&](Offset begin, Offset end)
    {
      CellChooser chooser(source, orders);
      for (Offset t = begin; t < end; ++t)
      {
        chooser.Run(triangles[t], blocks.empty() ? nullptr : &blocks[t],
          [&](std::size_t array, vtkIdType cell) { chosen[array][t] = cell; });
      }
    });
  for (std::size_t k = 0; done && k < arrays.size(); ++k)
  {
    arrays[k].source->GetTuples(cells[k], arrays[k].target);
  }
}

std::vector<int> findTriangleBlocks(const DiagramSource& source)
{
  const std::vector<Triple>& triangles = source.result.dual.triangles;
  const int* cellBlocks = source.cellBlocks;
  const std::vector<CellOrder> orders{ [cellBlocks](vtkIdType a, vtkIdType b)
    { return cellBlocks[a] - cellBlocks[b]; } };
  std::vector<int> blocks(triangles.size(), 0);
  static_cast<void>(
    forEachRange(Blocks::cut(static_cast<Offset>(triangles.size()), 256, 4096), source.control,
      [&](Offset begin, Offset end)
      {
        CellChooser chooser(source, orders);
        for (Offset t = begin; t < end; ++t)
        {
          chooser.Run(triangles[t], nullptr,
            [&](std::size_t, vtkIdType cell) { blocks[t] = cellBlocks[cell]; });
        }
      }));
  return blocks;
}
}
