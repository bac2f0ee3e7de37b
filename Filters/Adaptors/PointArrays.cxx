#include "Adaptors/PointArrays.h"

#include "Adaptors/CarriedArrays.h"
#include "Adaptors/MeshBlocks.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace remesh
{
std::optional<PointArray> lentArray(vtkDataArray* array)
{
  if (!array)
  {
    return std::nullopt;
  }
  PointArray lent;
  lent.name = array->GetName() ? array->GetName() : "";
  lent.count = array->GetNumberOfTuples();
  lent.dimension = array->GetNumberOfComponents();
  if (auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(array))
  {
    lent.doubles = doubles->GetPointer(0);
  }
  else if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(array))
  {
    lent.floats = floats->GetPointer(0);
  }
  lent.reader = [array](Offset row, double* values) { array->GetTuple(row, values); };
  return lent;
}

std::optional<GivenSites> givenSites(vtkPointSet* input)
{
  if (!input)
  {
    return std::nullopt;
  }
  GivenSites sites;
  if (vtkPoints* points = input->GetPoints())
  {
    sites.places = *lentArray(points->GetData());
  }
  sites.embedding = lentArray(input->GetPointData()->GetArray("Embedding"));
  return sites;
}

std::vector<PointArray> carriedPointArrays(vtkPolyData* input)
{
  std::vector<PointArray> carried;
  vtkPointData* data = input->GetPointData();
  for (int k = 0; k < data->GetNumberOfArrays() && !blocksOfCells(input); ++k)
  {
    vtkDataArray* array = data->GetArray(k);
    if (array && array->GetName() && hasMeans(array) &&
      array->GetNumberOfTuples() == input->GetNumberOfPoints() &&
      !isReserved(meshPointNames, array->GetName()) && array != data->GetNormals())
    {
      carried.push_back(*lentArray(array));
    }
  }
  return carried;
}
}
