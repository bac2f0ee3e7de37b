#include "Voronoi/SiteDistances.h"

#include <cstddef>

namespace remesh
{
namespace
{
struct Evaluation
{
  [[gnu::always_inline]] static inline void run(const SiteDistances& task)
  {
    const double* from = task.coordinates;
    for (int group = 0; group < task.numberOfGroups; ++group)
    {
      Lanes sum{};
      for (int k = 0; k < task.dimension; ++k, from += lanes)
      {
        Lanes difference;
        load(from, difference);
        difference -= task.point[k];
        sum += difference * difference;
      }
      store(sum, task.squared + static_cast<std::ptrdiff_t>(group) * lanes);
    }
  }
};
}

SiteDistanceEvaluation siteDistanceEvaluation(InstructionSet set)
{
  return CompiledFor<Evaluation, const SiteDistances&>::select(set);
}
}
