#include "Voronoi/BisectorValues.h"

#include "Support/Lanes.h"

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
  [[gnu::always_inline]] static inline double run(const BisectorsAtPoint& task)
  {
    double least = std::numeric_limits<double>::infinity();
    for (int first = 0; first < task.count; first += lanes)
    {
      Lanes sum{};
      Lanes row;
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
      least = std::min(least, leastOfLanes(v));
    }
    return least;
  }
};

struct Packing
{
  [[gnu::always_inline]] static inline void run(const BisectorPack& task)
  {
    const double* x = task.x;
    for (int first = task.first; first < task.last; first += lanes)
    {
      const double* y[lanes];
      Lanes squared{};
      for (int lane = 0; lane < lanes; ++lane)
      {
        const bool empty = first + lane >= task.count;
        y[lane] = empty ? x
                        : task.coordinates +
            static_cast<std::ptrdiff_t>(task.sites[first + lane]) * task.dimension;
        squared[lane] = empty ? unreachable : 0.0;
      }
      double* to = task.offsets + first;
      for (int m = 0; m < task.dimension; ++m, to += task.stride)
      {
        const Lanes row = { y[0][m], y[1][m], y[2][m], y[3][m], y[4][m], y[5][m], y[6][m],
          y[7][m] };
        const Lanes offsets = row - x[m];
        store(offsets, to);
        squared += offsets * offsets;
      }
      store(squared, to);
    }
  }
};

struct Evaluation
{
  [[gnu::always_inline]] static inline void run(const BisectorValues& task)
  {
    const int d = task.dimension;
    const double* points = task.points;
    for (int first = 0; first < task.count; first += lanes)
    {
      Lanes sum0{};
      Lanes sum1{};
      Lanes sum2{};
      Lanes row;
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
      LaneBits chosen = ~LaneBits{};
      for (int k = 0; k < task.numberOfLimits; ++k)
      {
        const double* limit = task.limits[k];
        LaneBits below0;
        LaneBits below1;
        LaneBits below2;
        findNegative(sum0 - limit[0], below0);
        findNegative(sum1 - limit[1], below1);
        findNegative(sum2 - limit[2], below2);
        chosen &= below0 | below1 | below2;
      }
      task.chosen[first / lanes] = static_cast<std::uint8_t>(bitsOf(chosen));
    }
  }
};
}

BisectorEvaluation bisectorEvaluation(InstructionSet set)
{
  return CompiledFor<Evaluation, const BisectorValues&>::select(set);
}

BisectorMinimum bisectorMinimum(InstructionSet set)
{
  return CompiledFor<Minimum, const BisectorsAtPoint&>::select(set);
}

BisectorPacking bisectorPacking(InstructionSet set)
{
  return CompiledFor<Packing, const BisectorPack&>::select(set);
}
}
