/**
 * @file ArrayHelpers.h
 * @brief Short ways to make VTK's arrays, points and cells.
 */
#ifndef remesh_ArrayHelpers_h
#define remesh_ArrayHelpers_h

#include "Support/Grouping.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace remesh
{
/** Calls `body(block)` in parallel; the caller asks `control` whether it was done to the end. */
template <class Body>
void fillBlocks(Offset count, const RunControl& control, const Body& body)
{
  static_cast<void>(forEachBlock(count, control, body));
}

/** Calls `body(item)` in parallel; the caller asks `control` whether it was done to the end. */
template <class Body>
void fillItems(Offset count, const RunControl& control, const Body& body)
{
  static_cast<void>(forEachItem(count, control, body));
}

/**
 * Named arrays of one length for one set of attributes, filled in parallel. When the run is
 * cancelled they are of no use.
 */
struct Columns
{
  vtkFieldData* data;
  Offset tuples;
  RunControl control;

  /** An array for the caller to fill. */
  template <class Array>
  vtkSmartPointer<Array> addEmpty(const char* name, int components) const
  {
    auto array = vtkSmartPointer<Array>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(this->tuples);
    this->data->AddArray(array);
    return array;
  }

  /** One value per index, `value(index)`. */
  template <class Array, class Value>
  void add(const char* name, const Value& value) const
  {
    auto* values = this->addEmpty<Array>(name, 1)->GetPointer(0);
    fillItems(this->tuples, this->control, [&](Offset k) { values[k] = value(k); });
  }

  /** Several values per index, which `fill(index, values)` writes. */
  template <class Array, class Fill>
  void addTuples(const char* name, int components, const Fill& fill) const
  {
    auto* values = this->addEmpty<Array>(name, components)->GetPointer(0);
    fillItems(this->tuples, this->control, [&](Offset k) { fill(k, values + k * components); });
  }
};

/** Double precision points, one `place(index)` each. */
template <class Place>
vtkSmartPointer<vtkPoints> makePoints(
  Offset count, const Place& place, const RunControl& control = RunControl())
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  auto* values = vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0);
  fillItems(count, control, [&](Offset k) { Point3::Map(values + 3 * k) = place(k); });
  return points;
}

/** Cells of `size` points each; `fill(index, ids)` writes the points of one. */
template <class Fill>
vtkSmartPointer<vtkCellArray> makeCells(
  Offset count, int size, const RunControl& control, const Fill& fill)
{
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(count * size);
  vtkIdType* begins = offsets->GetPointer(0);
  vtkIdType* ids = connectivity->GetPointer(0);
  fillItems(count, control,
    [&](Offset k)
    {
      begins[k] = k * size;
      fill(k, ids + k * size);
    });
  begins[count] = count * size;
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}
}

#endif
