#include "Adaptors/FacetLabels.h"

#include "vtkDataArray.h"
#include "vtkStringArray.h"

#include <cmath>
#include <map>
#include <string>

namespace remesh
{
namespace
{
/** Numbers the distinct values of the facets' cells in the order in which they come. */
template <class Value, class Read>
void numberValues(const SurfaceMesh& mesh, const Read& read, std::vector<Index>& labels)
{
  std::map<Value, Index> numbers;
  labels.clear();
  for (const Offset cell : mesh.facetInputCells)
  {
    labels.push_back(numbers.emplace(read(cell), static_cast<Index>(numbers.size())).first->second);
  }
}

/** A tuple that can be ordered: all that are no numbers count as one. */
std::vector<double> readTuple(vtkDataArray* array, Offset cell)
{
  std::vector<double> tuple(2 * static_cast<std::size_t>(array->GetNumberOfComponents()), 0.0);
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    const double value = array->GetComponent(cell, c);
    tuple[2 * c] = std::isnan(value) ? 0.0 : value;
    tuple[2 * c + 1] = std::isnan(value) ? 1.0 : 0.0;
  }
  return tuple;
}
}

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
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    numberValues<std::vector<double>>(
      mesh, [numbers](Offset cell) { return readTuple(numbers, cell); }, labels);
    return Status::success();
  }
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    const int size = strings->GetNumberOfComponents();
    numberValues<std::string>(
      mesh,
      [strings, size](Offset cell)
      {
        std::string joined;
        for (int c = 0; c < size; ++c)
        {
          joined += strings->GetValue(cell * size + c) + '\0';
        }
        return joined;
      },
      labels);
    return Status::success();
  }
  return Status::invalid(name + " holds neither numbers nor strings: it cannot label the cells.");
}
}
