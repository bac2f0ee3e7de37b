/**
 * @file InstructionSet.h
 * @brief The vector instructions that loops are compiled for, chosen when the program runs.
 */
#ifndef remesh_InstructionSet_h
#define remesh_InstructionSet_h

namespace remesh
{
enum class InstructionSet
{
  Baseline, ///< what the compiler was told, for Debian plain x86-64
  Avx2,
  Avx512
};

/** Whether this processor, and the compiler used, know the set. */
bool isAvailable(InstructionSet set);

/** The widest one available. */
InstructionSet widestInstructionSet();
}

#endif
