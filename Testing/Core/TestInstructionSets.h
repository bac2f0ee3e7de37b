/**
 * @file TestInstructionSets.h
 * @brief The sets of instructions that tests compare with each other.
 */
#ifndef remesh_TestInstructionSets_h
#define remesh_TestInstructionSets_h

#include "Support/InstructionSet.h"
#include "TestChecks.h"

#include <vector>

namespace remesh::test
{
/** From the baseline to the widest. */
inline std::vector<InstructionSet> availableSets()
{
  std::vector<InstructionSet> sets;
  for (const InstructionSet set :
    { InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512 })
  {
    if (isAvailable(set))
    {
      sets.push_back(set);
    }
  }
  CHECK(isAvailable(InstructionSet::Baseline));
  CHECK(sets.back() == widestInstructionSet());
  return sets;
}
}

#endif
