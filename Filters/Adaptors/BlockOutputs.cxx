/**
 * @file BlockOutputs.cxx
 *
 * Parting is counting, scanning and filling:
 * 1. Each point gets an owner: the block of the point array, or of the first cell that has it.
 *    Blocks that share it beside that are pairs (point, block), sorted; there are few.
 * 2. Items by block, in order: the points (owned ones and pairs), and the cells.
 * 3. For each block its points, cells and arrays, copied by those lists of ids.
 */
#include "Adaptors/BlockOutputs.h"

#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/BlockNames.h"
#include "Adaptors/CarriedArrays.h"

#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace remesh
{
namespace
{
constexpr int noBlock = -1;

const int* numbersOf(vtkFieldData* data)
{
  auto* array = vtkIntArray::SafeDownCast(data->GetAbstractArray(blockName));
  return array ? array->GetPointer(0) : nullptr;
}

/** Items 0 to n - 1 in lists, each in ascending order. */
struct Lists
{
  std::vector<vtkIdType> begin; ///< count + 1
  std::vector<vtkIdType> items;

  /** Calls `visit(add)`, which calls `add(item, list)` for all, twice in the same order. */
  template <class Visit>
  Lists(int count, const Visit& visit)
    : begin(static_cast<std::size_t>(count) + 1, 0)
  {
    visit([this](vtkIdType, int list) { ++this->begin[list + 1]; });
    std::partial_sum(this->begin.begin(), this->begin.end(), this->begin.begin());
    this->items.resize(static_cast<std::size_t>(this->begin.back()));
    std::vector<vtkIdType> next(this->begin.begin(), this->begin.end() - 1);
    visit([&](vtkIdType item, int list) { this->items[next[list]++] = item; });
  }

  vtkIdType size(int list) const { return this->begin[list + 1] - this->begin[list]; }

  vtkSmartPointer<vtkIdList> idsOf(int list) const
  {
    auto ids = vtkSmartPointer<vtkIdList>::New();
    ids->SetNumberOfIds(this->size(list));
    std::copy(this->items.begin() + this->begin[list], this->items.begin() + this->begin[list + 1],
      ids->GetPointer(0));
    return ids;
  }
};

class Parting
{
public:
  Parting(vtkPolyData* whole, int count)
    : Whole(whole)
    , Count(count)
    , CellBlocks(numbersOf(whole->GetCellData()))
  {
    this->FindOwners();
    this->NumberPoints();
  }

  std::vector<vtkSmartPointer<vtkPolyData>> Run()
  {
    std::vector<vtkSmartPointer<vtkPolyData>> parts;
    for (int block = 0; block < this->Count; ++block)
    {
      parts.push_back(vtkSmartPointer<vtkPolyData>::New());
    }
    this->PartPoints(parts);
    const Lists cells(this->Count,
      [this](const auto& add)
      {
        for (vtkIdType cell = 0; this->CellBlocks && cell < this->Whole->GetNumberOfCells(); ++cell)
        {
          add(cell, this->CellBlocks[cell]);
        }
      });
    for (int block = 0; block < this->Count; ++block)
    {
      copyArrays(this->Whole->GetCellData(), cells.idsOf(block), parts[block]->GetCellData());
    }
    vtkIdType first = 0;
    const auto part = [&](vtkCellArray* from, const auto& put)
    {
      const auto arrays = this->PartCells(from, first);
      for (int block = 0; block < this->Count; ++block)
      {
        put(parts[block], arrays[block]);
      }
      first += from->GetNumberOfCells();
    };
    part(
      this->Whole->GetVerts(), [](vtkPolyData* to, vtkCellArray* cells) { to->SetVerts(cells); });
    part(
      this->Whole->GetLines(), [](vtkPolyData* to, vtkCellArray* cells) { to->SetLines(cells); });
    part(
      this->Whole->GetPolys(), [](vtkPolyData* to, vtkCellArray* cells) { to->SetPolys(cells); });
    return parts;
  }

private:
  using Shared = std::pair<vtkIdType, int>; ///< a point, and a block that does not own it

  /** Calls `visit(cell, points, ids)` for the cells of an array, whose first has the id `cell`. */
  template <class Visit>
  static void ForEachCell(vtkCellArray* cells, vtkIdType cell, const Visit& visit)
  {
    auto each = vtk::TakeSmartPointer(cells->NewIterator());
    for (each->GoToFirstCell(); !each->IsDoneWithTraversal(); each->GoToNextCell(), ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      each->GetCurrentCell(size, ids);
      visit(cell, size, ids);
    }
  }

  void FindOwners()
  {
    const vtkIdType count = this->Whole->GetNumberOfPoints();
    this->Owners.assign(static_cast<std::size_t>(count), noBlock);
    if (const int* given = numbersOf(this->Whole->GetPointData()))
    {
      std::copy_n(given, count, this->Owners.begin());
    }
    vtkIdType first = 0;
    for (vtkCellArray* cells :
      { this->Whole->GetVerts(), this->Whole->GetLines(), this->Whole->GetPolys() })
    {
      ForEachCell(cells, this->CellBlocks ? first : cells->GetNumberOfCells(),
        [this](vtkIdType cell, vtkIdType size, const vtkIdType* ids)
        {
          const int block = this->CellBlocks[cell];
          for (vtkIdType k = 0; k < size; ++k)
          {
            int& owner = this->Owners[ids[k]];
            owner = owner == noBlock ? block : owner;
            if (owner != block)
            {
              this->Extras.emplace_back(ids[k], block);
            }
          }
        });
      first += cells->GetNumberOfCells();
    }
    std::sort(this->Extras.begin(), this->Extras.end());
    this->Extras.erase(std::unique(this->Extras.begin(), this->Extras.end()), this->Extras.end());
  }

  /** Calls `visit(point, block, number of the pair or -1)` by point. */
  template <class Visit>
  void ForEachPoint(const Visit& visit) const
  {
    auto extra = this->Extras.begin();
    for (vtkIdType point = 0; point < static_cast<vtkIdType>(this->Owners.size()); ++point)
    {
      if (this->Owners[point] != noBlock)
      {
        visit(point, this->Owners[point], -1);
      }
      for (; extra != this->Extras.end() && extra->first == point; ++extra)
      {
        visit(point, extra->second, static_cast<vtkIdType>(extra - this->Extras.begin()));
      }
    }
  }

  void NumberPoints()
  {
    std::vector<vtkIdType> next(static_cast<std::size_t>(this->Count), 0);
    this->Numbers.resize(this->Owners.size());
    this->ExtraNumbers.resize(this->Extras.size());
    this->ForEachPoint([&](vtkIdType point, int block, vtkIdType extra)
      { (extra < 0 ? this->Numbers[point] : this->ExtraNumbers[extra]) = next[block]++; });
  }

  vtkIdType NumberOf(vtkIdType point, int block) const
  {
    if (this->Owners[point] == block)
    {
      return this->Numbers[point];
    }
    const auto found =
      std::lower_bound(this->Extras.begin(), this->Extras.end(), Shared(point, block));
    return this->ExtraNumbers[found - this->Extras.begin()];
  }

  void PartPoints(const std::vector<vtkSmartPointer<vtkPolyData>>& parts) const
  {
    const Lists points(this->Count,
      [this](const auto& add)
      { this->ForEachPoint([&](vtkIdType point, int block, vtkIdType) { add(point, block); }); });
    for (int block = 0; block < this->Count; ++block)
    {
      const vtkSmartPointer<vtkIdList> ids = points.idsOf(block);
      vtkNew<vtkPoints> places;
      if (this->Whole->GetPoints())
      {
        places->SetDataType(this->Whole->GetPoints()->GetDataType());
      }
      places->SetNumberOfPoints(ids->GetNumberOfIds());
      if (ids->GetNumberOfIds() > 0)
      {
        this->Whole->GetPoints()->GetData()->GetTuples(ids, places->GetData());
      }
      parts[block]->SetPoints(places);
      copyArrays(this->Whole->GetPointData(), ids, parts[block]->GetPointData());
    }
  }

  std::vector<vtkSmartPointer<vtkCellArray>> PartCells(vtkCellArray* from, vtkIdType first) const
  {
    std::vector<vtkSmartPointer<vtkCellArray>> arrays;
    for (int block = 0; block < this->Count; ++block)
    {
      arrays.push_back(vtkSmartPointer<vtkCellArray>::New());
    }
    std::vector<vtkIdType> numbers;
    ForEachCell(from, first,
      [&](vtkIdType cell, vtkIdType size, const vtkIdType* ids)
      {
        const int block = this->CellBlocks[cell];
        numbers.resize(static_cast<std::size_t>(size));
        std::transform(ids, ids + size, numbers.begin(),
          [&](vtkIdType point) { return this->NumberOf(point, block); });
        arrays[block]->InsertNextCell(size, numbers.data());
      });
    return arrays;
  }

  static void copyArrays(vtkDataSetAttributes* from, vtkIdList* ids, vtkDataSetAttributes* to)
  {
    for (int k = 0; k < from->GetNumberOfArrays(); ++k)
    {
      vtkAbstractArray* array = from->GetAbstractArray(k);
      if (isHidden(array->GetName() ? array->GetName() : ""))
      {
        continue;
      }
      const auto copy = makeLike(array, ids->GetNumberOfIds());
      if (ids->GetNumberOfIds() > 0)
      {
        array->GetTuples(ids, copy);
      }
      const int index = to->AddArray(copy);
      for (int attribute = 0; attribute < vtkDataSetAttributes::NUM_ATTRIBUTES; ++attribute)
      {
        if (from->GetAbstractAttribute(attribute) == array)
        {
          to->SetActiveAttribute(index, attribute);
        }
      }
    }
  }

  vtkPolyData* Whole;
  int Count;
  const int* CellBlocks;
  std::vector<int> Owners; ///< of the points; noBlock: it is dropped
  std::vector<Shared> Extras;
  std::vector<vtkIdType> Numbers; ///< of the points within the block that owns them
  std::vector<vtkIdType> ExtraNumbers;
};

/** Partial arrays under their names where the block's input has them, and not elsewhere. */
void restoreArrays(vtkDataSetAttributes* input, vtkDataSetAttributes* output)
{
  for (int k = output->GetNumberOfArrays() - 1; k >= 0; --k)
  {
    const vtkSmartPointer<vtkAbstractArray> array = output->GetAbstractArray(k);
    const std::string name = array->GetName() ? array->GetName() : "";
    if (!isPartial(name))
    {
      continue;
    }
    const std::string plain = plainName(name);
    vtkAbstractArray* own = input->GetAbstractArray(plain.c_str());
    const bool isOwn = own && own->GetDataType() == array->GetDataType() &&
      own->GetNumberOfComponents() == array->GetNumberOfComponents() &&
      !output->HasArray(plain.c_str());
    output->RemoveArray(k);
    if (isOwn)
    {
      array->SetName(plain.c_str());
      output->AddArray(array);
    }
  }
  for (int attribute = 0; attribute < vtkDataSetAttributes::NUM_ATTRIBUTES; ++attribute)
  {
    vtkAbstractArray* active = input->GetAbstractAttribute(attribute);
    if (active && active->GetName() && !output->GetAbstractAttribute(attribute) &&
      output->HasArray(active->GetName()))
    {
      output->SetActiveAttribute(active->GetName(), attribute);
    }
  }
}

/** Which arrays of the points the result has got, and which it has lost. */
struct Changes
{
  std::vector<vtkAbstractArray*> added;
  std::vector<std::string> removed;

  Changes(vtkDataSetAttributes* before, vtkDataSetAttributes* after)
  {
    const auto contains = [](vtkDataSetAttributes* data, vtkAbstractArray* array)
    {
      for (int k = 0; k < data->GetNumberOfArrays(); ++k)
      {
        if (data->GetAbstractArray(k) == array)
        {
          return true;
        }
      }
      return false;
    };
    for (int k = 0; k < after->GetNumberOfArrays(); ++k)
    {
      if (!contains(before, after->GetAbstractArray(k)))
      {
        this->added.push_back(after->GetAbstractArray(k));
      }
    }
    for (int k = 0; k < before->GetNumberOfArrays(); ++k)
    {
      const char* name = before->GetAbstractArray(k)->GetName();
      if (name && !contains(after, before->GetAbstractArray(k)))
      {
        this->removed.push_back(plainName(name));
      }
    }
  }
};

/** The leaf with the changes; `ids`: its points among the whole's, nullptr: all. */
void passChanges(vtkDataObject* leaf, const Changes& changes, vtkIdList* ids, vtkDataObject* output)
{
  output->ShallowCopy(leaf);
  vtkPointData* data = vtkDataSet::SafeDownCast(output)->GetPointData();
  for (const std::string& name : changes.removed)
  {
    data->RemoveArray(name.c_str());
  }
  for (vtkAbstractArray* array : changes.added)
  {
    if (!ids)
    {
      data->AddArray(array);
      continue;
    }
    const auto copy = makeLike(array, ids->GetNumberOfIds());
    array->GetTuples(ids, copy);
    data->AddArray(copy);
  }
}
}

std::vector<vtkSmartPointer<vtkPolyData>> partByBlock(vtkPolyData* whole, int count)
{
  return Parting(whole, count).Run();
}

void finishBlock(vtkPolyData* whole, vtkDataObject* input, vtkPolyData* block)
{
  auto* leaf = vtkDataSet::SafeDownCast(input);
  vtkFieldData* facts = whole->GetFieldData();
  vtkFieldData* output = block->GetFieldData();
  if (leaf)
  {
    restoreArrays(leaf->GetPointData(), block->GetPointData());
    restoreArrays(leaf->GetCellData(), block->GetCellData());
    output->PassData(leaf->GetFieldData());
    removeReserved(meshFactNames, output);
  }
  for (const char* name : meshFactNames)
  {
    if (vtkAbstractArray* fact = facts->GetAbstractArray(name))
    {
      output->AddArray(fact);
    }
  }
}

std::vector<vtkSmartPointer<vtkDataObject>> passBlocks(
  const std::vector<SurfaceBlock>& blocks, vtkPolyData* wholeInput, vtkPolyData* whole)
{
  const int* numbers = numbersOf(wholeInput->GetPointData());
  const bool hasResult = whole->GetNumberOfPoints() > 0;
  const Lists points(static_cast<int>(blocks.size()),
    [&](const auto& add)
    {
      for (vtkIdType point = 0; hasResult && point < wholeInput->GetNumberOfPoints(); ++point)
      {
        add(point, numbers[point]);
      }
    });
  const Changes changes(wholeInput->GetPointData(), whole->GetPointData());
  std::vector<vtkSmartPointer<vtkDataObject>> outputs;
  for (std::size_t k = 0; k < blocks.size(); ++k)
  {
    vtkDataObject* leaf = blocks[k].input;
    outputs.push_back(leaf ? vtk::TakeSmartPointer(leaf->NewInstance()) : nullptr);
    if (leaf && hasResult)
    {
      passChanges(leaf, changes, points.idsOf(static_cast<int>(k)), outputs.back());
    }
  }
  return outputs;
}

void passLeaf(
  vtkDataObject* leaf, vtkPolyData* wholeInput, vtkPolyData* whole, vtkDataObject* output)
{
  if (whole->GetNumberOfPoints() > 0)
  {
    const Changes changes(wholeInput->GetPointData(), whole->GetPointData());
    passChanges(leaf, changes, nullptr, output);
  }
}
}
