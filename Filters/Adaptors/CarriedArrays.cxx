#include "Adaptors/CarriedArrays.h"

#include "Adaptors/BlockNames.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkLookupTable.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace remesh
{
namespace
{
std::string nameOf(vtkAbstractArray* array)
{
  return array->GetName() ? array->GetName() : "";
}

/** All that the array is active as: it may be scalars and vectors at once. */
std::vector<int> attributesOf(vtkDataSetAttributes* data, int array)
{
  int indices[vtkDataSetAttributes::NUM_ATTRIBUTES];
  data->GetAttributeIndices(indices);
  std::vector<int> attributes;
  for (int attribute = 0; attribute < vtkDataSetAttributes::NUM_ATTRIBUTES; ++attribute)
  {
    if (indices[attribute] == array)
    {
      attributes.push_back(attribute);
    }
  }
  return attributes;
}

bool contains(const std::vector<int>& attributes, int attribute)
{
  return std::find(attributes.begin(), attributes.end(), attribute) != attributes.end();
}

std::string join(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "\"" : ", \"") + name + "\"";
  }
  return text;
}
}

vtkSmartPointer<vtkAbstractArray> makeLike(vtkAbstractArray* source, Offset tuples)
{
  // Only the plain layout can be written to for certain.
  vtkAbstractArray* made = source->HasStandardMemoryLayout()
    ? source->NewInstance()
    : vtkAbstractArray::CreateArray(source->GetDataType());
  auto target = vtk::TakeSmartPointer(made);
  target->SetName(source->GetName());
  target->SetNumberOfComponents(source->GetNumberOfComponents());
  target->CopyComponentNames(source);
  target->SetNumberOfTuples(tuples);
  if (source->HasInformation())
  {
    target->CopyInformation(source->GetInformation(), 1);
  }
  auto* from = vtkDataArray::SafeDownCast(source);
  auto* to = vtkDataArray::SafeDownCast(target);
  if (from && to && from->GetLookupTable())
  {
    to->SetLookupTable(from->GetLookupTable());
  }
  return target;
}

std::string LostArrays::describe() const
{
  std::string text;
  if (!this->taken.empty() && !this->inputIsMesh)
  {
    text = "named like arrays of the mesh's own: " + join(this->taken);
  }
  if (!this->unfit.empty())
  {
    text += (text.empty() ? "" : "; ") + std::string("without one tuple for each point or cell: ") +
      join(this->unfit);
  }
  return text.empty() ? text : "Arrays of the input are not carried over, " + text + ".";
}

bool CarriedArray::is(int attribute) const
{
  return contains(this->attributes, attribute);
}

namespace
{
/** Adds them, active as they were where nothing else is. */
void addTargets(const std::vector<CarriedArray>& arrays, vtkDataSetAttributes* output)
{
  for (const CarriedArray& array : arrays)
  {
    const int index = output->AddArray(array.target);
    for (const int attribute : array.attributes)
    {
      if (!output->GetAbstractAttribute(attribute))
      {
        output->SetActiveAttribute(index, attribute);
      }
    }
  }
}
}

std::vector<CarriedArray> makeCarriedArrays(vtkDataSetAttributes* input, Offset inputTuples,
  const OwnArrays& own, Offset tuples, vtkDataSetAttributes* output, LostArrays& lost)
{
  std::vector<CarriedArray> carried;
  for (int k = 0; k < input->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = input->GetAbstractArray(k);
    const std::string name = plainName(nameOf(array));
    std::vector<int> attributes = attributesOf(input, k);
    if (isHidden(name) || name == vtkDataSetAttributes::GhostArrayName() ||
      contains(attributes, vtkDataSetAttributes::GLOBALIDS))
    {
      continue;
    }
    if (array->GetNumberOfTuples() != inputTuples)
    {
      lost.unfit.push_back(name);
    }
    else if (isReserved(own.names, name))
    {
      // The normals of the mesh stand for those of the input, used or not.
      if (name != "Normals" &&
        std::find(own.replaced.begin(), own.replaced.end(), nameOf(array)) == own.replaced.end())
      {
        lost.taken.push_back(name);
      }
    }
    else
    {
      carried.push_back({ array, makeLike(array, tuples), std::move(attributes) });
    }
  }
  addTargets(carried, output);
  return carried;
}

void carryFieldData(vtkPolyData* input, vtkPolyData* output, LostArrays& lost)
{
  vtkFieldData* from = input->GetFieldData();
  vtkFieldData* to = output->GetFieldData();
  for (int k = 0; k < from->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = from->GetAbstractArray(k);
    const std::string name = nameOf(array);
    if (isReserved(meshFactNames, name))
    {
      if (!isReserved(metricFactNames, name))
      {
        lost.taken.push_back(name);
      }
    }
    else if (name.empty() || !to->HasArray(name.c_str())) // the pipeline may have passed it already
    {
      to->AddArray(array);
    }
  }
}
}
