#include "Voronoi/BisectorValues.h"

#include "Support/CompiledInLanes.h"
#include "Support/LaneColumns.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace remesh
{
namespace
{
/** The value of lanes without a site. */
constexpr double unreachable = 1e100;

struct Minimum
{
  template <class L>
  [[gnu::always_inline]] static inline double run(const BisectorsAtPoint& task)
  {
    double least = std::numeric_limits<double>::infinity();
    for (int first = 0; first < task.count; first += lanes)
    {
      L sum{};
      L row;
      const double* column = task.offsets + first;
      for (int m = 0; m < task.dimension; ++m, column += task.stride)
      {
        load(column, row);
        sum += task.point[m] * row;
      }
      load(column, row);
      sum = row - 2.0 * sum;
      double* v = task.values + first;
      store(sum, v);
      least = std::min(least, minOfLanes(v));
    }
    return least;
  }
};

struct Packing
{
  /** A row of offsets; returns where the next one goes. */
  template <class L>
  [[gnu::always_inline]] static inline double* keep(
    L& row, double x, double* to, int stride, L& squared)
  {
    row -= x;
    store(row, to);
    squared += row * row;
    return to + stride;
  }

  template <class L>
  [[gnu::always_inline]] static inline void run(const BisectorPack& task)
  {
    const double* x = task.x;
    for (int first = task.first; first < task.last; first += lanes)
    {
      const double* y[lanes];
      double squares[lanes];
      for (int lane = 0; lane < lanes; ++lane)
      {
        const bool empty = first + lane >= task.count;
        y[lane] = empty ? x
                        : task.coordinates +
            static_cast<std::ptrdiff_t>(task.sites[first + lane]) * task.dimension;
        squares[lane] = empty ? unreachable : 0.0;
      }
      L squared;
      load(squares, squared);
      double* to = task.offsets + first;
      int m = 0;
      for (; m + 1 < task.dimension; m += 2)
      {
        L one;
        L other;
        readTwoColumns(y, m, one, other);
        to = keep(one, x[m], to, task.stride, squared);
        to = keep(other, x[m + 1], to, task.stride, squared);
      }
      if (m < task.dimension)
      {
        L last;
        readColumn(y, m, last);
        to = keep(last, x[m], to, task.stride, squared);
      }
      store(squared, to);
    }
  }
};

struct Evaluation
{
  template <class L>
  [[gnu::always_inline]] static inline void run(const BisectorValues& task)
  {
    const int d = task.dimension;
    const double* points = task.points;
    for (int first = 0; first < task.count; first += lanes)
    {
      L sum0{};
      L sum1{};
      L sum2{};
      L row;
      const double* column = task.offsets + first;
      for (int m = 0; m < d; ++m, column += task.stride)
      {
        load(column, row);
        sum0 += points[m] * row;
        sum1 += points[d + m] * row;
        sum2 += points[2 * d + m] * row;
      }
      load(column, row);
      sum0 = row - 2.0 * sum0;
      sum1 = row - 2.0 * sum1;
      sum2 = row - 2.0 * sum2;
      double* values = task.values + first;
      store(sum0, values);
      store(sum1, values + task.stride);
      store(sum2, values + 2 * task.stride);
      unsigned chosen = (1U << lanes) - 1U;
      for (int k = 0; k < task.numberOfLimits; ++k)
      {
        const double* limit = task.limits[k];
        typename L::Bits below{};
        addNegative(sum0 - limit[0], below);
        addNegative(sum1 - limit[1], below);
        addNegative(sum2 - limit[2], below);
        chosen &= bitsOf(below);
      }
      task.chosen[first / lanes] = static_cast<std::uint8_t>(chosen);
    }
  }
};
}

BisectorEvaluation bisectorEvaluation(InstructionSet set)
{
  return CompiledInLanes<Evaluation, const BisectorValues&>::select(set);
}

BisectorMinimum bisectorMinimum(InstructionSet set)
{
  return CompiledInLanes<Minimum, const BisectorsAtPoint&>::select(set);
}

BisectorPacking bisectorPacking(InstructionSet set)
{
  return CompiledInLanes<Packing, const BisectorPack&>::select(set);
}
}
