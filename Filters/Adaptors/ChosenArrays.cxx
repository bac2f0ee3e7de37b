#include "Adaptors/ChosenArrays.h"

#include "Adaptors/BlockNames.h"
#include "Adaptors/PointArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

namespace remesh
{
namespace
{
/** The active attribute of a type, or -1 where the choice is by name, or nothing is chosen. */
int attributeOf(vtkInformation* choice)
{
  if (!choice || isChosenByName(choice) || !choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
  {
    return -1;
  }
  const int attribute = choice->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
  return attribute < vtkDataSetAttributes::NUM_ATTRIBUTES ? attribute : -1;
}

/** Whether some blocks of the input have an array of the name. */
bool isInSomeBlocks(vtkDataSetAttributes* data, const std::string& name)
{
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    const char* own = data->GetArrayName(k);
    if (own && isPartial(own) && plainName(own) == name)
    {
      return true;
    }
  }
  return false;
}

/** What is chosen among the points' or cells' arrays; fails where another kind of array is. */
Status findArray(vtkInformation* choice, vtkPolyData* input, int association, const char* role,
  vtkAbstractArray*& array)
{
  array = nullptr;
  const int attribute = attributeOf(choice);
  const std::string name =
    attribute < 0 && isChosenByName(choice) ? choice->Get(vtkDataObject::FIELD_NAME()) : "";
  if (attribute < 0 && name.empty())
  {
    return Status::success();
  }
  const bool ofPoints = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const std::string kind = ofPoints ? "point" : "cell";
  const std::string what = attribute < 0
    ? "array \"" + name + "\""
    : std::string("active array of ") + vtkDataSetAttributes::GetAttributeTypeAsString(attribute);
  const std::string chosen = std::string(", chosen as the ") + role;
  if (choice->Get(vtkDataObject::FIELD_ASSOCIATION()) != association)
  {
    return Status::invalid("The " + what + chosen + ", must be a " + kind + " array.");
  }
  vtkDataSetAttributes* data =
    ofPoints ? static_cast<vtkDataSetAttributes*>(input->GetPointData()) : input->GetCellData();
  array =
    attribute < 0 ? data->GetAbstractArray(name.c_str()) : data->GetAbstractAttribute(attribute);
  if ((array && (!ofPoints || vtkDataArray::SafeDownCast(array))) || name == "None")
  {
    return Status::success();
  }
  array = nullptr;
  const std::string numeric = ofPoints ? "numeric " : "";
  if (attribute < 0 && isInSomeBlocks(data, name))
  {
    return Status::invalid("Not all blocks of the input have the " + kind + " " + what + chosen +
      ", with the same type and number of components.");
  }
  return Status::invalid(attribute < 0
      ? "The input has no " + numeric + kind + " " + what + chosen + "."
      : "The input's " + kind + "s have no " + numeric + what + chosen + ".");
}
}

bool isChosenByName(vtkInformation* choice)
{
  return choice && choice->Get(vtkDataObject::FIELD_NAME()) != nullptr;
}

bool isPointAttribute(vtkInformation* choice, int attribute)
{
  return attributeOf(choice) == attribute &&
    choice->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_POINTS;
}

Status findPointArray(
  vtkInformation* choice, vtkPolyData* input, const char* role, std::optional<PointArray>& array)
{
  vtkAbstractArray* found = nullptr;
  Status status = findArray(choice, input, vtkDataObject::FIELD_ASSOCIATION_POINTS, role, found);
  array = lentArray(vtkDataArray::SafeDownCast(found));
  return status;
}

Status findCellArray(
  vtkInformation* choice, vtkPolyData* input, const char* role, vtkAbstractArray*& array)
{
  return findArray(choice, input, vtkDataObject::FIELD_ASSOCIATION_CELLS, role, array);
}
}
