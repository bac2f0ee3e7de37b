#include "Support/InstructionSet.h"

#include <initializer_list>

namespace remesh
{
bool isAvailable(InstructionSet set)
{
#if defined(__GNUC__) && defined(__x86_64__)
  switch (set)
  {
    case InstructionSet::Avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl");
    case InstructionSet::Avx2:
      return __builtin_cpu_supports("avx2");
    case InstructionSet::Baseline:
      return true;
  }
#endif
  return set == InstructionSet::Baseline;
}

InstructionSet widestInstructionSet()
{
  for (const InstructionSet set : { InstructionSet::Avx512, InstructionSet::Avx2 })
  {
    if (isAvailable(set))
    {
      return set;
    }
  }
  return InstructionSet::Baseline;
}
}
