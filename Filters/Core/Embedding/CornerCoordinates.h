/**
 * @file CornerCoordinates.h
 * @brief Values at the corners of a surface, in the caller's units: held, lent, or both.
 *
 * In thousands of dimensions each copy of an embedding counts in gigabytes. So arrays of the caller
 * can be lent: then each corner names its row in them, and rows are put together when asked for.
 */
#ifndef remesh_CornerCoordinates_h
#define remesh_CornerCoordinates_h

#include "Support/Types.h"

#include <algorithm>
#include <vector>

namespace remesh
{
/** Rows of numbers in the caller's memory, P x dimension; either doubles or floats. */
struct LentArray
{
  const double* doubles = nullptr;
  const float* floats = nullptr;
  int dimension = 0;
  double scale = 1.0; ///< each value counts times this
};

struct CornerCoordinates
{
  int dimension = 0;
  std::vector<double> values;  ///< C x (dimension - that of the lent arrays), the first components
  std::vector<LentArray> lent; ///< the components after these, array by array
  std::vector<Offset> rows;    ///< C, of the lent arrays; empty where nothing is lent

  bool isLent() const { return !this->lent.empty(); }

  Offset count() const
  {
    return this->isLent() ? static_cast<Offset>(this->rows.size())
                          : static_cast<Offset>(this->values.size()) / std::max(1, this->dimension);
  }

  /** The row of a corner, `dimension` values: where it is held, or else put together in `scratch`.
   */
  const double* row(Index corner, std::vector<double>& scratch) const
  {
    if (!this->isLent())
    {
      return this->values.data() +
        static_cast<std::size_t>(corner) * static_cast<std::size_t>(this->dimension);
    }
    scratch.resize(static_cast<std::size_t>(this->dimension));
    this->read(corner, scratch.data());
    return scratch.data();
  }

  /** Copies the row of a corner. */
  void read(Index corner, double* row) const
  {
    const int held = this->heldDimension();
    row = std::copy_n(
      this->values.data() + static_cast<std::size_t>(corner) * static_cast<std::size_t>(held), held,
      row);
    for (const LentArray& array : this->lent)
    {
      const Offset begin = this->rows[corner] * array.dimension;
      row = array.doubles ? copyScaled(array.doubles + begin, array, row)
                          : copyScaled(array.floats + begin, array, row);
    }
  }

  /** The rows of some corners; what is lent stays so. */
  CornerCoordinates of(const std::vector<Index>& corners) const
  {
    CornerCoordinates some;
    some.dimension = this->dimension;
    some.lent = this->lent;
    const auto held = static_cast<std::size_t>(this->heldDimension());
    for (const Index corner : corners)
    {
      const auto first =
        this->values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(corner) * held);
      some.values.insert(some.values.end(), first, first + static_cast<std::ptrdiff_t>(held));
      if (this->isLent())
      {
        some.rows.push_back(this->rows[corner]);
      }
    }
    return some;
  }

private:
  int heldDimension() const
  {
    int held = this->dimension;
    for (const LentArray& array : this->lent)
    {
      held -= array.dimension;
    }
    return held;
  }

  template <class Value>
  static double* copyScaled(const Value* from, const LentArray& array, double* to)
  {
    return std::transform(from, from + array.dimension, to,
      [&array](Value value) { return array.scale * static_cast<double>(value); });
  }
};
}

#endif
