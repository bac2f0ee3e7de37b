#include "Voronoi/BisectorValues.h"

#include "Support/Lanes.h"

namespace remesh
{
namespace
{
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
}
