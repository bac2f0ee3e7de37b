#include "Mesh/BoxDistances.h"

namespace remesh
{
namespace
{
struct Evaluation
{
  [[gnu::always_inline]] static inline void addPositive(const Lanes& outside, Lanes& sum)
  {
    LaneBits negative;
    LaneBits bits;
    Lanes positive;
    findNegative(outside, negative);
    std::memcpy(&bits, &outside, sizeof outside);
    bits &= ~negative;
    std::memcpy(&positive, &bits, sizeof bits);
    sum += positive * positive;
  }

  [[gnu::always_inline]] static inline void run(const BoxDistances& task)
  {
    Lanes sum{};
    Lanes bound;
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
  [[gnu::always_inline]] static inline unsigned run(const BoxMeeting& task)
  {
    LaneBits apart{};
    LaneBits negative;
    Lanes bound;
    for (int axis = 0; axis < 3; ++axis)
    {
      load(task.boxes.lower[axis], bound);
      findNegative(task.upper[axis] - bound + 0.0, negative); // -0 is none
      apart |= negative;
      load(task.boxes.upper[axis], bound);
      findNegative(bound - task.lower[axis] + 0.0, negative);
      apart |= negative;
    }
    return bitsOf(~apart);
  }
};
}

BoxDistanceEvaluation boxDistanceEvaluation(InstructionSet set)
{
  return CompiledFor<Evaluation, const BoxDistances&>::select(set);
}

BoxMeetingEvaluation boxMeetingEvaluation(InstructionSet set)
{
  return CompiledFor<Meeting, const BoxMeeting&>::select(set);
}
}
