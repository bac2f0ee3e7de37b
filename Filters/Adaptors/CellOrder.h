/**
 * @file CellOrder.h
 * @brief Which tuples of an array are equal, exactly as the array's type has them.
 */
#ifndef remesh_CellOrder_h
#define remesh_CellOrder_h

#include "vtkType.h"

#include <functional>

class vtkAbstractArray;

namespace remesh
{
/** -1, 0 or 1. A total order, also with NaN: it comes last, and equals itself. */
template <class Value>
int compareTotally(const Value& a, const Value& b)
{
  if (a < b)
  {
    return -1;
  }
  return b < a ? 1 : static_cast<int>(a != a) - static_cast<int>(b != b);
}

/** Negative, 0 or positive, as the value of one cell comes before, with or after another's. */
using CellOrder = std::function<int(vtkIdType, vtkIdType)>;

/**
 * The order of an array's tuples, component by component: a total one, in which NaN comes last and
 * equals itself. Numbers are compared in their own type: 64-bit ids stay distinct. Tuples of arrays
 * that hold neither numbers nor strings are all different, in the order of the cells.
 *
 * The array must outlive the order, which several threads may use at once.
 */
CellOrder orderOf(vtkAbstractArray* array);
}

#endif
