/**
 * @file PointArray.h
 * @brief An array of the caller's points, read where it is.
 */
#ifndef remesh_PointArray_h
#define remesh_PointArray_h

#include "Support/Types.h"

#include <algorithm>
#include <functional>
#include <string>

namespace remesh
{
/**
 * P x dimension numbers that belong to the caller, who keeps them as long as they are read: in
 * thousands of dimensions, a copy counts in gigabytes. Several threads may read at once.
 */
struct PointArray
{
  std::string name;
  Offset count = 0; ///< rows
  int dimension = 0;
  const double* doubles = nullptr;                        ///< row after row; or
  const float* floats = nullptr;                          ///< likewise; or
  std::function<void(Offset row, double* values)> reader; ///< for whatever else holds the numbers

  /** Copies a row. */
  void read(Offset row, double* values) const
  {
    const Offset begin = row * this->dimension;
    if (this->doubles)
    {
      std::copy_n(this->doubles + begin, this->dimension, values);
    }
    else if (this->floats)
    {
      std::copy_n(this->floats + begin, this->dimension, values);
    }
    else
    {
      this->reader(row, values);
    }
  }

  /** The number of a row, where there is one a row. */
  double value(Offset row) const
  {
    if (this->doubles || this->floats)
    {
      return this->doubles ? this->doubles[row] : this->floats[row];
    }
    double value = 0.0;
    this->reader(row, &value);
    return value;
  }
};
}

#endif
