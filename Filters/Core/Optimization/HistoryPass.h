/**
 * @file HistoryPass.h
 * @brief The passes over long vectors that a limited history of steps takes (J. Nocedal, "Updating
 *        quasi-Newton matrices with limited storage", 1980), over a part of them.
 *
 * Reading the vectors is most of the work. So the numbers of the history have two bytes (the upper
 * halves of floats, rounded to nearest, ties to even), the recursion works on floats, and adds one
 * vector of the history as it multiplies with the next.
 */
#ifndef remesh_HistoryPass_h
#define remesh_HistoryPass_h

#include "Support/InstructionSet.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace remesh
{
/**
 * Numbers in two bytes each, in groups: number k of a group is the lower half of its word k, or the
 * upper half of word k - 8. A last group may have fewer; zeros fill it. Not for infinities and NaN.
 */
using HalvedNumbers = std::vector<std::uint32_t>;
constexpr std::size_t wordsOfGroup = 8;
constexpr std::size_t groupOfNumbers = 2 * wordsOfGroup;
constexpr std::uint32_t upperHalf = 0xFFFF0000U; ///< of a word, and of a float

/** A step of the recursion: adds a multiple of a vector, and multiplies with the next one. */
struct RecursionPass
{
  float* vector; ///< whole groups
  std::size_t groups;
  float factor;
  const std::uint32_t* added; ///< `factor` times these are added to the vector, unless null
  const std::uint32_t* next;  ///< the product of these and the outcome is returned, unless null
};

/** A new pair: the step from one place to the next, and the change of the gradient -2 moment. */
struct PairPass
{
  const double* placeBefore; ///< `count` numbers each
  const double* placeAfter;
  const double* momentBefore;
  const double* momentAfter;
  std::size_t count;
  std::uint32_t* step; ///< where they go; the product of both is returned
  std::uint32_t* change;
};

struct HistoryPasses
{
  double (*recur)(const RecursionPass&);
  double (*pair)(const PairPass&);
};

/** Compiled for a set of instructions; all give the same bits. */
HistoryPasses historyPasses(InstructionSet set);

/** Number k. */
inline float numberOf(const HalvedNumbers& numbers, std::size_t k)
{
  const std::size_t place = k % groupOfNumbers;
  const std::uint32_t word = numbers[k / groupOfNumbers * wordsOfGroup + place % wordsOfGroup];
  const std::uint32_t bits = place < wordsOfGroup ? word << 16 : word & upperHalf;
  float number = 0.0F;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}
}

#endif
