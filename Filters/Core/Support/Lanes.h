/**
 * @file Lanes.h
 * @brief Several numbers at once, and functions compiled for several sets of instructions.
 *
 * A function is written once and inlined into one copy for each set; which one runs is chosen by
 * pointer. Products and sums are rounded on their own (a flag of this library's build) and each
 * lane is worked on alone, so that all copies give the same bits. Such a function must not call
 * others that are not inlined: GCC 12 then leaves the wide registers' upper halves in use, which
 * slows all other code down.
 */
#ifndef remesh_Lanes_h
#define remesh_Lanes_h

#include "Support/InstructionSet.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace remesh
{
constexpr int lanes = 8;

/** Rounds up. */
constexpr int wholeLanes(int count)
{
  return (count + lanes - 1) / lanes * lanes;
}

/** Eight numbers at once (a vector of GCC and Clang, which split it where it is too wide). */
using Lanes = double __attribute__((vector_size(8 * lanes)));

[[gnu::always_inline]] inline void load(const double* from, Lanes& to)
{
  std::memcpy(&to, from, sizeof to);
}

[[gnu::always_inline]] inline void store(const Lanes& from, double* to)
{
  std::memcpy(to, &from, sizeof from);
}

using LaneBits = unsigned long long __attribute__((vector_size(8 * lanes)));

/**
 * All bits of the lanes that are negative. By the sign's bit, since compilers take comparisons of
 * such wide vectors apart.
 */
[[gnu::always_inline]] inline void findNegative(const Lanes& values, LaneBits& negative)
{
  std::memcpy(&negative, &values, sizeof values);
  negative = 0ULL - (negative >> 63);
}

/** Takes over the chosen lanes of other values. */
[[gnu::always_inline]] inline void replaceChosen(
  const Lanes& by, const LaneBits& chosen, Lanes& values)
{
  LaneBits bits;
  LaneBits others;
  std::memcpy(&bits, &by, sizeof by);
  std::memcpy(&others, &values, sizeof values);
  bits = (bits & chosen) | (others & ~chosen);
  std::memcpy(&values, &bits, sizeof bits);
}

/** The values of the chosen lanes, infinity in the others. */
[[gnu::always_inline]] inline void storeChosen(
  const Lanes& values, const LaneBits& chosen, double* to)
{
  Lanes stored = Lanes{} + std::numeric_limits<double>::infinity();
  replaceChosen(values, chosen, stored);
  store(stored, to);
}

/** The least of so many numbers. */
[[gnu::always_inline]] inline double leastOfLanes(const double* n)
{
  const double low = std::min(std::min(n[0], n[1]), std::min(n[2], n[3]));
  const double high = std::min(std::min(n[4], n[5]), std::min(n[6], n[7]));
  return std::min(low, high);
}

/** One bit for each lane that is set. */
[[gnu::always_inline]] inline unsigned bitsOf(const LaneBits& set)
{
  const LaneBits weights{ 1, 2, 4, 8, 16, 32, 64, 128 };
  const LaneBits weighted = set & weights;
  unsigned long long bits[lanes];
  std::memcpy(bits, &weighted, sizeof bits);
  return static_cast<unsigned>(
    ((bits[0] | bits[1]) | (bits[2] | bits[3])) | ((bits[4] | bits[5]) | (bits[6] | bits[7])));
}

/** Copies of `Body::run(Argument)`, which must be inlined. */
template <class Body, class Argument>
class CompiledFor
{
public:
  using Result = decltype(Body::run(std::declval<Argument>()));
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
    return Body::run(argument);
  }
#if defined(__x86_64__)
  [[gnu::target("avx2")]] static Result avx2(Argument argument)
  {
    return Body::run(argument);
  }
#if defined(__clang__) // knows no such preference
  [[gnu::target("avx512f,avx512dq,avx512vl")]]
#else
  [[gnu::target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")]]
#endif
  static Result
  avx512(Argument argument)
  {
    return Body::run(argument);
  }
#endif
};
}

#endif
