/**
 * @file BlockJoining.cxx
 *
 * Cells come in the order of vtkPolyData: the polygons of all blocks, then their strips.
 *
 * Arrays of the same name, type and number of components are one array of the whole. One that all
 * blocks have keeps its name; others get a partial name, and zeros (empty strings) in the blocks
 * that lack them, which nothing ever reads: what is carried over to a block is read on that block.
 */
#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/BlockNames.h"
#include "Adaptors/CarriedArrays.h"
#include "Adaptors/SurfaceBlocks.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace remesh
{
namespace
{
/** Tuples that follow each other: those of one block within the whole. */
struct Run
{
  vtkIdType first; ///< of the whole
  vtkIdType count;
  vtkIdType source; ///< the first of the block's tuples, or of its `cellIds`
};

/** One block's part of the points or cells. */
struct Part
{
  vtkDataSetAttributes* data;
  vtkIdType tuples; ///< that its arrays have to have
  std::vector<Run> runs;
  vtkIdTypeArray* ids; ///< which tuples; nullptr: as `source` tells
  bool counts = true;  ///< whether an array that it lacks is partial

  bool empty() const
  {
    return std::all_of(
      this->runs.begin(), this->runs.end(), [](const Run& run) { return run.count == 0; });
  }
};

void copyTuples(const Part& part, vtkAbstractArray* source, vtkAbstractArray* target)
{
  for (const Run& run : part.runs)
  {
    if (!part.ids)
    {
      target->InsertTuples(run.first, run.count, run.source, source);
      continue;
    }
    vtkNew<vtkIdList> from;
    vtkNew<vtkIdList> to;
    from->SetNumberOfIds(run.count);
    to->SetNumberOfIds(run.count);
    const vtkIdType* ids = part.ids->GetPointer(run.source);
    std::copy(ids, ids + run.count, from->GetPointer(0));
    std::iota(to->GetPointer(0), to->GetPointer(0) + run.count, run.first);
    target->InsertTuples(to, from, source);
  }
}

/** Arrays that are one array of the whole. */
struct Variant
{
  std::string name;
  std::vector<std::pair<const Part*, vtkAbstractArray*>> arrays;
  std::size_t holders = 0; ///< of the parts that count
  bool isGlobalIds = false;
};

class ArrayJoin
{
public:
  ArrayJoin(const std::vector<Part>& parts, vtkIdType tuples, vtkDataSetAttributes* output)
    : Parts(parts)
    , Tuples(tuples)
    , Output(output)
  {
  }

  void Run(bool keepsPartial, JoinReport& report)
  {
    this->Collect(report);
    for (std::size_t k = 0; k < this->Variants.size(); ++k)
    {
      const Variant& variant = this->Variants[k];
      const bool isGhosts = variant.name == vtkDataSetAttributes::GhostArrayName();
      const bool isPartial = variant.holders < this->Holders && !isGhosts;
      if (!isPartial || (keepsPartial && !variant.isGlobalIds))
      {
        this->Join(
          variant, isPartial ? partialName(variant.name, static_cast<int>(k)) : variant.name);
      }
    }
    this->Activate(report);
  }

private:
  void Collect(JoinReport& report)
  {
    std::map<std::tuple<std::string, int, int>, std::size_t> numbers;
    for (const Part& part : this->Parts)
    {
      if (part.empty())
      {
        continue;
      }
      this->Holders += part.counts ? 1 : 0;
      for (int k = 0; k < part.data->GetNumberOfArrays(); ++k)
      {
        vtkAbstractArray* array = part.data->GetAbstractArray(k);
        const std::string name = array->GetName() ? array->GetName() : "";
        if (array->GetNumberOfTuples() != part.tuples)
        {
          report.unfitArrays.push_back(name);
          continue;
        }
        const auto [found, isNew] = numbers.emplace(
          std::make_tuple(name, array->GetDataType(), array->GetNumberOfComponents()),
          this->Variants.size());
        if (isNew)
        {
          this->Variants.push_back({ name, {}, 0, false });
        }
        Variant& variant = this->Variants[found->second];
        variant.arrays.emplace_back(&part, array);
        variant.holders += part.counts ? 1 : 0;
        variant.isGlobalIds = variant.isGlobalIds || array == part.data->GetGlobalIds();
      }
    }
  }

  void Join(const Variant& variant, const std::string& name)
  {
    const auto target = makeLike(variant.arrays.front().second, this->Tuples);
    target->SetName(name.c_str());
    if (auto* numbers = vtkDataArray::SafeDownCast(target);
        numbers && variant.arrays.size() < this->Parts.size())
    {
      numbers->Fill(0.0);
    }
    for (const auto& [part, array] : variant.arrays)
    {
      copyTuples(*part, array, target);
    }
    this->Output->AddArray(target);
  }

  /** An array is active where it is so in all blocks. */
  void Activate(JoinReport& report)
  {
    for (int attribute = 0; attribute < vtkDataSetAttributes::NUM_ATTRIBUTES; ++attribute)
    {
      std::size_t active = 0;
      std::string name;
      bool isSame = true;
      for (const Part& part : this->Parts)
      {
        vtkAbstractArray* array =
          part.empty() || !part.counts ? nullptr : part.data->GetAbstractAttribute(attribute);
        if (array && array->GetName())
        {
          isSame = isSame && (active == 0 || name == array->GetName());
          name = array->GetName();
          ++active;
        }
      }
      if (active == 0)
      {
        continue;
      }
      const bool isActive = isSame && active == this->Holders &&
        this->Output->SetActiveAttribute(name.c_str(), attribute) >= 0;
      report.lacksNormals =
        report.lacksNormals || (!isActive && attribute == vtkDataSetAttributes::NORMALS);
    }
  }

  const std::vector<Part>& Parts;
  vtkIdType Tuples;
  vtkDataSetAttributes* Output;
  std::vector<Variant> Variants;
  std::size_t Holders = 0; ///< parts that count
};

/** Where the points of a data set go, and those of the next. */
vtkSmartPointer<vtkPoints> appendPoints(
  const std::vector<vtkPointSet*>& sets, std::vector<Part>& parts, vtkIdType& total)
{
  total = 0;
  int precision = 0;
  for (vtkPointSet* set : sets)
  {
    const vtkIdType count = set->GetNumberOfPoints();
    parts.push_back({ set->GetPointData(), count, { { total, count, 0 } }, nullptr, count > 0 });
    total += count;
    if (count > 0)
    {
      const int own = set->GetPoints()->GetDataType();
      precision = precision == 0 || precision == own ? own : VTK_DOUBLE;
    }
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(precision == 0 ? VTK_DOUBLE : precision);
  points->SetNumberOfPoints(total);
  for (std::size_t k = 0; k < sets.size(); ++k)
  {
    if (parts[k].tuples > 0)
    {
      points->InsertPoints(parts[k].runs[0].first, parts[k].tuples, 0, sets[k]->GetPoints());
    }
  }
  return points;
}

/** The cells of all blocks in the order of the whole; fills `parts`, and returns their number. */
vtkIdType appendCells(const std::vector<LeafSurface>& leaves, const std::vector<Part>& pointParts,
  vtkPolyData* whole, std::vector<Part>& parts)
{
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkCellArray> strips;
  for (std::size_t k = 0; k < leaves.size(); ++k)
  {
    const LeafSurface& leaf = leaves[k];
    const vtkIdType offset = pointParts[k].runs[0].first;
    const vtkIdType count = leaf.surface->GetNumberOfPolys();
    parts.push_back({ leaf.cellData, leaf.numberOfCells, {}, leaf.cellIds });
    parts[k].runs.push_back({ polygons->GetNumberOfCells(), count, 0 });
    parts[k].runs.push_back(
      { strips->GetNumberOfCells(), leaf.surface->GetNumberOfStrips(), count });
    polygons->Append(leaf.surface->GetPolys(), offset);
    strips->Append(leaf.surface->GetStrips(), offset);
  }
  for (Part& part : parts)
  {
    part.runs[1].first += polygons->GetNumberOfCells();
  }
  whole->SetPolys(polygons);
  whole->SetStrips(strips);
  return polygons->GetNumberOfCells() + strips->GetNumberOfCells();
}

/** An array of a value for each block. */
template <class Value>
void addNumbers(const char* name, const std::vector<Part>& parts, vtkIdType tuples,
  const Value& value, vtkFieldData* data)
{
  const Columns columns{ data, tuples, {} };
  int* numbers = columns.addEmpty<vtkIntArray>(name, 1)->GetPointer(0);
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    for (const Run& run : parts[k].runs)
    {
      std::fill_n(numbers + run.first, run.count, value(k));
    }
  }
}

void addCellIds(const std::vector<Part>& parts, vtkIdType tuples, vtkFieldData* data)
{
  const Columns columns{ data, tuples, {} };
  vtkIdType* ids = columns.addEmpty<vtkIdTypeArray>(blockCellName, 1)->GetPointer(0);
  for (const Part& part : parts)
  {
    for (const Run& run : part.runs)
    {
      if (part.ids)
      {
        std::copy_n(part.ids->GetPointer(run.source), run.count, ids + run.first);
      }
      else
      {
        std::iota(ids + run.first, ids + run.first + run.count, run.source);
      }
    }
  }
}

/** Points, cells and arrays, with the cells' ids. */
void joinLeaves(const std::vector<LeafSurface>& leaves, vtkPolyData* whole,
  std::vector<Part>& points, std::vector<Part>& cells, JoinReport& report)
{
  whole->Initialize();
  std::vector<vtkPointSet*> sets;
  for (const LeafSurface& leaf : leaves)
  {
    sets.push_back(leaf.surface);
  }
  vtkIdType numberOfPoints = 0;
  whole->SetPoints(appendPoints(sets, points, numberOfPoints));
  const vtkIdType numberOfCells = appendCells(leaves, points, whole, cells);
  for (std::size_t k = 0; k < leaves.size(); ++k)
  {
    cells[k].counts = points[k].counts = !cells[k].empty();
  }
  ArrayJoin(points, numberOfPoints, whole->GetPointData()).Run(true, report);
  JoinReport ofCells; // normals of cells are not used
  ArrayJoin(cells, numberOfCells, whole->GetCellData()).Run(true, ofCells);
  report.unfitArrays.insert(
    report.unfitArrays.end(), ofCells.unfitArrays.begin(), ofCells.unfitArrays.end());
  addCellIds(cells, numberOfCells, whole->GetCellData());
}
}

Status joinBlocks(const std::vector<SurfaceBlock>& blocks, vtkPolyData* whole, JoinReport& report)
{
  std::vector<LeafSurface> leaves(blocks.size());
  bool hasPartitions = false;
  for (std::size_t k = 0; k < blocks.size(); ++k)
  {
    hasPartitions = hasPartitions || (k > 0 && blocks[k].region == blocks[k - 1].region);
    vtkNew<vtkPolyData> nothing;
    vtkDataObject* leaf = blocks[k].input ? blocks[k].input.Get() : nothing.Get();
    if (Status status = readLeaf(leaf, blocks[k].subject, leaves[k]); !status.ok())
    {
      return status;
    }
  }
  std::vector<Part> points;
  std::vector<Part> cells;
  joinLeaves(leaves, whole, points, cells, report);
  const auto number = [](std::size_t k) { return static_cast<int>(k); };
  const vtkIdType numberOfCells = whole->GetNumberOfCells();
  addNumbers(blockName, points, whole->GetNumberOfPoints(), number, whole->GetPointData());
  addNumbers(blockName, cells, numberOfCells, number, whole->GetCellData());
  if (hasPartitions)
  {
    addNumbers(
      regionName, cells, numberOfCells, [&](std::size_t k) { return blocks[k].region; },
      whole->GetCellData());
  }
  return Status::success();
}

Status joinPoints(const std::vector<SurfaceBlock>& blocks, vtkPolyData* whole)
{
  std::vector<vtkPointSet*> sets;
  for (const SurfaceBlock& block : blocks)
  {
    auto* set = vtkPointSet::SafeDownCast(block.input);
    if (block.input && !set)
    {
      return Status::invalid(block.subject + " is a " + block.input->GetClassName() +
        ", which has no points for sites.");
    }
    if (set)
    {
      sets.push_back(set);
    }
  }
  whole->Initialize();
  std::vector<Part> parts;
  vtkIdType count = 0;
  whole->SetPoints(appendPoints(sets, parts, count));
  JoinReport report; // what some blocks lack is no part of sites
  ArrayJoin(parts, count, whole->GetPointData()).Run(false, report);
  return Status::success();
}

void joinLeaf(const LeafSurface& leaf, vtkPolyData* whole, JoinReport& report)
{
  std::vector<Part> points;
  std::vector<Part> cells;
  joinLeaves({ leaf }, whole, points, cells, report);
}
}
