#include "Adaptors/CellLabels.h"

#include "Adaptors/BlockNames.h"
#include "Adaptors/CellOrder.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <map>
#include <string>
#include <utility>

namespace remesh
{
Status readCellLabels(
  vtkAbstractArray* array, Offset numberOfCells, std::vector<Index>& labels)
{
  const std::string name =
    std::string("The cell array \"") + (array->GetName() ? array->GetName() : "") + "\"";
  if (array->GetNumberOfTuples() != numberOfCells)
  {
    return Status::invalid(name + " has " + std::to_string(array->GetNumberOfTuples()) +
      " tuples for " + std::to_string(numberOfCells) + " cells.");
  }
  if (!vtkDataArray::SafeDownCast(array) && !vtkStringArray::SafeDownCast(array))
  {
    return Status::invalid(name + " holds neither numbers nor strings: it cannot label the cells.");
  }
  // The distinct values get numbers in the order in which they come.
  const auto isBefore = [order = orderOf(array)](vtkIdType a, vtkIdType b)
  { return order(a, b) < 0; };
  std::map<vtkIdType, Index, decltype(isBefore)> numbers(isBefore);
  labels.clear();
  labels.reserve(static_cast<std::size_t>(numberOfCells));
  for (Offset cell = 0; cell < numberOfCells; ++cell)
  {
    labels.push_back(numbers.emplace(cell, static_cast<Index>(numbers.size())).first->second);
  }
  return Status::success();
}

void addRegions(vtkPolyData* input, std::vector<Index>& labels)
{
  vtkCellData* data = input->GetCellData();
  auto* regions = vtkIntArray::SafeDownCast(data->GetAbstractArray(regionName));
  if (!regions)
  {
    regions = vtkIntArray::SafeDownCast(data->GetAbstractArray(blockName));
  }
  if (!regions)
  {
    return;
  }
  labels.resize(static_cast<std::size_t>(input->GetNumberOfCells()), 0);
  std::map<std::pair<int, Index>, Index> numbers;
  for (std::size_t cell = 0; cell < labels.size(); ++cell)
  {
    const int region = regions->GetValue(static_cast<vtkIdType>(cell));
    const auto next = static_cast<Index>(numbers.size());
    labels[cell] = numbers.emplace(std::make_pair(region, labels[cell]), next).first->second;
  }
}
}
