/**
 * @file CompiledInLanes.h
 * @brief Functions compiled for several sets of instructions.
 *
 * A body is written once, as a template `Body::run<L>(argument)`, and inlined into one copy for
 * each set, with the lanes of that set (Lanes.h). Which copy runs is chosen by pointer. Products
 * and sums are rounded on their own (a flag of this library's build), so that all copies give the
 * same bits. A body must not call others that are not inlined: GCC 12 then leaves the wide
 * registers' upper halves in use, which slows all other code down.
 */
#ifndef remesh_CompiledInLanes_h
#define remesh_CompiledInLanes_h

#include "Support/InstructionSet.h"
#include "Support/Lanes.h"

#include <utility>

namespace remesh
{
/** Copies of `Body::run<L>(Argument)`, which must be inlined, each with the lanes of its set. */
template <class Body, class Argument>
class CompiledInLanes
{
public:
  using Result = decltype(Body::template run<Lanes<2>>(std::declval<Argument>()));
  using Function = Result (*)(Argument);

  static Function select(InstructionSet set)
  {
#if defined(__x86_64__)
    return set == InstructionSet::Avx512 ? avx512 : set == InstructionSet::Avx2 ? avx2 : baseline;
#else
    static_cast<void>(set);
    return baseline;
#endif
  }

private:
  static Result baseline(Argument argument)
  {
    return Body::template run<Lanes<2>>(argument);
  }
#if defined(__x86_64__)
  [[gnu::target("avx2")]] static Result avx2(Argument argument)
  {
    return Body::template run<Lanes<4>>(argument);
  }
#if defined(__clang__) // knows no such preference
  [[gnu::target("avx512f,avx512dq,avx512vl")]]
#else
  [[gnu::target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")]]
#endif
  static Result
  avx512(Argument argument)
  {
    return Body::template run<Lanes<8>>(argument);
  }
#endif
};
}

#endif
