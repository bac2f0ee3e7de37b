/**
 * @file LaneColumns.h
 * @brief Columns of eight rows as lanes: numbers that are side by side in memory, of eight things.
 */
#ifndef remesh_LaneColumns_h
#define remesh_LaneColumns_h

#include "Support/Lanes.h"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push // as in Lanes.h
#pragma GCC diagnostic ignored "-Wpsabi"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace remesh
{
/** Column m of eight rows. */
template <int W>
[[gnu::always_inline]] inline void readColumn(
  const double* const* rows, std::ptrdiff_t m, Lanes<W>& to)
{
  for (int k = 0; k < to.parts; ++k)
  {
    using Vector = typename Lanes<W>::Vector;
    const double* const* r = rows + k * W;
    if constexpr (W == 2)
    {
      const Vector column{ r[0][m], r[1][m] };
      std::memcpy(&to.part[k], &column, sizeof column);
    }
    else if constexpr (W == 4)
    {
      const Vector column{ r[0][m], r[1][m], r[2][m], r[3][m] };
      std::memcpy(&to.part[k], &column, sizeof column);
    }
    else
    {
      const Vector column{ r[0][m], r[1][m], r[2][m], r[3][m], r[4][m], r[5][m], r[6][m], r[7][m] };
      std::memcpy(&to.part[k], &column, sizeof column);
    }
  }
}

/** Columns m and m + 1: the numbers of a row are loaded together, which takes half as long. */
template <int W>
[[gnu::always_inline]] inline void readTwoColumns(
  const double* const* rows, std::ptrdiff_t m, Lanes<W>& first, Lanes<W>& second)
{
  using Vector = typename Lanes<W>::Vector;
  for (int k = 0; k < first.parts; ++k)
  {
    const double* const* r = rows + k * W;
    typename NativeVector<2>::Numbers pairs[W];
    for (int row = 0; row < W; ++row)
    {
      std::memcpy(&pairs[row], r[row] + m, sizeof pairs[row]);
    }
    Vector even;
    Vector odd;
    if constexpr (W == 2)
    {
      even = pairs[0];
      odd = pairs[1];
      first.part[k] = __builtin_shufflevector(even, odd, 0, 2);
      second.part[k] = __builtin_shufflevector(even, odd, 1, 3);
    }
    else if constexpr (W == 4)
    {
      even = __builtin_shufflevector(pairs[0], pairs[2], 0, 1, 2, 3);
      odd = __builtin_shufflevector(pairs[1], pairs[3], 0, 1, 2, 3);
      first.part[k] = __builtin_shufflevector(even, odd, 0, 4, 2, 6);
      second.part[k] = __builtin_shufflevector(even, odd, 1, 5, 3, 7);
    }
    else
    {
      using Half = typename NativeVector<4>::Numbers;
      const Half even0 = __builtin_shufflevector(pairs[0], pairs[2], 0, 1, 2, 3);
      const Half even1 = __builtin_shufflevector(pairs[4], pairs[6], 0, 1, 2, 3);
      const Half odd0 = __builtin_shufflevector(pairs[1], pairs[3], 0, 1, 2, 3);
      const Half odd1 = __builtin_shufflevector(pairs[5], pairs[7], 0, 1, 2, 3);
      even = __builtin_shufflevector(even0, even1, 0, 1, 2, 3, 4, 5, 6, 7);
      odd = __builtin_shufflevector(odd0, odd1, 0, 1, 2, 3, 4, 5, 6, 7);
      first.part[k] = __builtin_shufflevector(even, odd, 0, 8, 2, 10, 4, 12, 6, 14);
      second.part[k] = __builtin_shufflevector(even, odd, 1, 9, 3, 11, 5, 13, 7, 15);
    }
  }
}

/** The first `count` columns. */
template <class L>
[[gnu::always_inline]] inline void readColumns(const double* const* rows, int count, L* columns)
{
  int m = 0;
  for (; m + 1 < count; m += 2)
  {
    readTwoColumns(rows, m, columns[m], columns[m + 1]);
  }
  if (m < count)
  {
    readColumn(rows, m, columns[m]);
  }
}
}

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#endif
