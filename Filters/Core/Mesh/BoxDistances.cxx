#include "Mesh/BoxDistances.h"

#include "Support/CompiledInLanes.h"

namespace remesh
{
namespace
{
struct Evaluation
{
  template <class L>
  [[gnu::always_inline]] static inline void addPositive(L outside, L& sum)
  {
    keepPositive(outside);
    sum += outside * outside;
  }

  template <class L>
  [[gnu::always_inline]] static inline void run(const BoxDistances& task)
  {
    L sum{};
    L bound;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = task.point[axis];
      load(task.boxes.lower[axis], bound);
      addPositive(bound - x, sum);
      load(task.boxes.upper[axis], bound);
      addPositive(x - bound, sum); // of the two, one at most is above 0
    }
    store(sum, task.squared);
  }
};

struct Meeting
{
  template <class L>
  [[gnu::always_inline]] static inline unsigned run(const BoxMeeting& task)
  {
    typename L::Bits apart{};
    L bound;
    for (int axis = 0; axis < 3; ++axis)
    {
      load(task.boxes.lower[axis], bound);
      addNegative(task.upper[axis] - bound + 0.0, apart); // -0 is none
      load(task.boxes.upper[axis], bound);
      addNegative(bound - task.lower[axis] + 0.0, apart);
    }
    return bitsOf(~apart);
  }
};
}

BoxDistanceEvaluation boxDistanceEvaluation(InstructionSet set)
{
  return CompiledInLanes<Evaluation, const BoxDistances&>::select(set);
}

BoxMeetingEvaluation boxMeetingEvaluation(InstructionSet set)
{
  return CompiledInLanes<Meeting, const BoxMeeting&>::select(set);
}
}
