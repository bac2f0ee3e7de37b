/**
 * @file ChosenArrays.h
 * @brief Which of the input's arrays vtkAlgorithm::SetInputArrayToProcess chose.
 */
#ifndef remesh_ChosenArrays_h
#define remesh_ChosenArrays_h

#include "Preparation/PointArray.h"
#include "Support/Status.h"

#include <optional>

class vtkAbstractArray;
class vtkInformation;
class vtkPolyData;

namespace remesh
{
/** Whether `choice` (GetInputArrayInformation) names an array, or none: "" and "None". */
bool isChosenByName(vtkInformation* choice);

/** Whether `choice` is an attribute (vtkDataSetAttributes::AttributeTypes) of the points. */
bool isPointAttribute(vtkInformation* choice, int attribute);

/**
 * A numeric point array, chosen by its name or as the active attribute of a type.
 *
 * @param role how messages call it.
 * @param array none where nothing is chosen.
 * @return InvalidInput where what is chosen is not there, or is no numeric point array.
 */
Status findPointArray(
  vtkInformation* choice, vtkPolyData* input, const char* role, std::optional<PointArray>& array);

/** A cell array of any kind, likewise, or nullptr. */
Status findCellArray(
  vtkInformation* choice, vtkPolyData* input, const char* role, vtkAbstractArray*& array);
}

#endif
