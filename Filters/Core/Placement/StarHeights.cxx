#include "Placement/StarHeights.h"

namespace remesh
{
namespace
{
struct Evaluation
{
  [[gnu::always_inline]] static inline void multiply(
    const double (&columns)[3][lanes], const double* with, Lanes& product)
  {
    Lanes x;
    Lanes y;
    Lanes z;
    load(columns[0], x);
    load(columns[1], y);
    load(columns[2], z);
    product = with[0] * x + with[1] * y + with[2] * z;
  }

  [[gnu::always_inline]] static inline void run(const StarHeights& task)
  {
    double* squared = task.squared;
    for (const StarGroup& group : task.groups)
    {
      Lanes first;
      Lanes second;
      Lanes facing;
      Lanes height;
      multiply(group.first, task.way, first);
      multiply(group.second, task.way, second);
      multiply(group.normal, task.facing, facing);
      multiply(group.normal, task.way, height);
      LaneBits outside;
      LaneBits negative;
      findNegative(first, outside);
      findNegative(second, negative);
      outside |= negative;
      findNegative(1.0 - first - second, negative);
      outside |= negative;
      findNegative(0.0 - facing, negative);
      outside |= ~negative; // where it does not face along
      storeChosen(height * height, ~outside, squared);
      squared += lanes;
    }
  }
};
}

StarHeightEvaluation starHeightEvaluation(InstructionSet set)
{
  return CompiledFor<Evaluation, const StarHeights&>::select(set);
}
}
