#include "Adaptors/CellOrder.h"

#include "vtkArrayDispatch.h"
#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

namespace remesh
{
namespace
{
struct MakeOrder
{
  template <class Array>
  void operator()(Array* array, CellOrder& order) const
  {
    order = [tuples = vtk::DataArrayTupleRange(array), size = array->GetNumberOfComponents()](
              vtkIdType a, vtkIdType b)
    {
      const auto first = tuples[a];
      const auto second = tuples[b];
      int result = 0;
      for (int c = 0; c < size && result == 0; ++c)
      {
        using Value = typename Array::ValueType;
        result = compareTotally<Value>(first[c], second[c]);
      }
      return result;
    };
  }
};

/** Compares any array's tuples with `value(index)`. */
template <class Value>
CellOrder orderOfValues(int size, const Value& value)
{
  return [size, value](vtkIdType a, vtkIdType b)
  {
    int result = 0;
    for (int c = 0; c < size && result == 0; ++c)
    {
      result = compareTotally(value(a * size + c), value(b * size + c));
    }
    return result;
  };
}

/** For layouts that the dispatcher does not know: doubles, unless they cannot hold the values. */
CellOrder orderOfUnknownLayout(vtkDataArray* data)
{
  const int size = data->GetNumberOfComponents();
  switch (data->GetDataType())
  {
    case VTK_LONG:
    case VTK_LONG_LONG:
    case VTK_ID_TYPE:
      return orderOfValues(
        size, [data](vtkIdType k) { return data->GetVariantValue(k).ToLongLong(); });
    case VTK_UNSIGNED_LONG:
    case VTK_UNSIGNED_LONG_LONG:
      return orderOfValues(
        size, [data](vtkIdType k) { return data->GetVariantValue(k).ToUnsignedLongLong(); });
    default:
      return orderOfValues(size,
        [data, size](vtkIdType k)
        { return data->GetComponent(k / size, static_cast<int>(k % size)); });
  }
}
}

CellOrder orderOf(vtkAbstractArray* array)
{
  const int size = array->GetNumberOfComponents();
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    return orderOfValues(
      size, [strings](vtkIdType k) -> const vtkStdString& { return strings->GetPointer(0)[k]; });
  }
  if (auto* bits = vtkBitArray::SafeDownCast(array))
  {
    return orderOfValues(size, [bits](vtkIdType k) { return bits->GetValue(k); });
  }
  CellOrder order;
  auto* data = vtkDataArray::SafeDownCast(array);
  if (data && !vtkArrayDispatch::Dispatch::Execute(data, MakeOrder{}, order))
  {
    order = orderOfUnknownLayout(data);
  }
  if (!data)
  {
    order = [](vtkIdType a, vtkIdType b)
    { return compareTotally(a, b); }; // no values that one can tell
  }
  return order;
}
}
