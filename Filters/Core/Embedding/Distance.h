/**
 * @file Distance.h
 * @brief The one squared distance in R^d that all exact decisions rest on.
 *
 * A pair (site, corner) must give the same double wherever it is asked for: one function, one
 * order of operations, no contraction into fused operations (a flag of this library's build).
 * D is 3, 6, or Eigen::Dynamic for any other dimension.
 */
#ifndef remesh_Distance_h
#define remesh_Distance_h

#include "Support/Types.h"

#include <type_traits>

namespace remesh
{
template <int D>
double squaredDistance(const double* a, const double* b, int dimension)
{
  const int size = D == Eigen::Dynamic ? dimension : D;
  // Four chains of sums, so that the processor need not wait for each addition.
  double sums[4] = { 0.0, 0.0, 0.0, 0.0 };
  int k = 0;
  for (; k + 4 <= size; k += 4)
  {
    for (int c = 0; c < 4; ++c)
    {
      const double difference = a[k + c] - b[k + c];
      sums[c] += difference * difference;
    }
  }
  for (int c = 0; c < 3 && k < size; ++k, ++c)
  {
    const double difference = a[k] - b[k];
    sums[c] += difference * difference;
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/**
 * A bound times this covers the rounding of the few distances that it is compared with, in up to
 * 10^6 dimensions; it lets next to no more sites through.
 */
constexpr double aboveRounding = 1.0 + 1e-9;

/** Calls `function` with the dimension as a compile-time constant where it is compiled for it. */
template <class Function>
auto dispatchDimension(int dimension, Function&& function)
{
  switch (dimension)
  {
    case 3:
      return function(std::integral_constant<int, 3>{});
    case 6:
      return function(std::integral_constant<int, 6>{});
    default:
      return function(std::integral_constant<int, Eigen::Dynamic>{});
  }
}
}

#endif
