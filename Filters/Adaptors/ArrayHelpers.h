/**
 * @file ArrayHelpers.h
 * @brief Short ways to make VTK's arrays, points and cells.
 */
#ifndef remesh_ArrayHelpers_h
#define remesh_ArrayHelpers_h

#include "Support/Types.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace remesh
{
/** A named array added to `data`, for the caller to fill. */
template <class Array>
vtkSmartPointer<Array> addArray(
  vtkFieldData* data, const char* name, Offset tuples, int components = 1)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  data->AddArray(array);
  return array;
}

/** A named column with one value per index, `value(index)`. */
template <class Array, class Value>
void addColumn(vtkFieldData* data, const char* name, Offset tuples, const Value& value)
{
  const auto array = addArray<Array>(data, name, tuples);
  auto* values = array->GetPointer(0);
  for (Offset k = 0; k < tuples; ++k)
  {
    values[k] = value(k);
  }
}

/** Double precision points, one `place(index)` each. */
template <class Place>
vtkSmartPointer<vtkPoints> makePoints(Offset count, const Place& place)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  for (Offset k = 0; k < count; ++k)
  {
    const Point3 point = place(k);
    points->SetPoint(k, point.data());
  }
  return points;
}
}

#endif
