#include "Adaptors/FacetLabels.h"

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
Status readFacetLabels(const SurfaceMesh& mesh, vtkAbstractArray* array, Offset numberOfInputCells,
  std::vector<Index>& labels)
{
  const std::string name =
    std::string("The cell array \"") + (array->GetName() ? array->GetName() : "") + "\"";
  if (array->GetNumberOfTuples() != numberOfInputCells)
  {
    return Status::invalid(name + " has " + std::to_string(array->GetNumberOfTuples()) +
      " tuples for " + std::to_string(numberOfInputCells) + " cells.");
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
  labels.reserve(mesh.facetInputCells.size());
  for (const Offset cell : mesh.facetInputCells)
  {
    labels.push_back(numbers.emplace(cell, static_cast<Index>(numbers.size())).first->second);
  }
  return Status::success();
}

void addRegions(const SurfaceMesh& mesh, vtkPolyData* input, std::vector<Index>& labels)
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
  labels.resize(mesh.facetInputCells.size(), 0);
  std::map<std::pair<int, Index>, Index> numbers;
  for (std::size_t facet = 0; facet < labels.size(); ++facet)
  {
    const int region = regions->GetValue(mesh.facetInputCells[facet]);
    const auto next = static_cast<Index>(numbers.size());
    labels[facet] = numbers.emplace(std::make_pair(region, labels[facet]), next).first->second;
  }
}
}
