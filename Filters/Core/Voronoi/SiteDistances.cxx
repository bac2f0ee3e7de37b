#include "Voronoi/SiteDistances.h"

#include "Support/CompiledInLanes.h"

#include <cstddef>

namespace remesh
{
namespace
{
struct DistanceEvaluation
{
  template <class L>
  [[gnu::always_inline]] static inline void run(const SiteDistances& task)
  {
    const double* from = task.coordinates;
    for (int group = 0; group < task.numberOfGroups; ++group)
    {
      L sum{};
      for (int k = 0; k < task.dimension; ++k, from += lanes)
      {
        L difference;
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
  return CompiledInLanes<DistanceEvaluation, const SiteDistances&>::select(set);
}
}
