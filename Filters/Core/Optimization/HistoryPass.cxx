#include "Optimization/HistoryPass.h"

#include "Support/Lanes.h"

namespace remesh
{
namespace
{
using Words = std::uint32_t __attribute__((vector_size(4 * wordsOfGroup)));
using Floats = float __attribute__((vector_size(4 * wordsOfGroup)));
static_assert(wordsOfGroup == lanes);

template <class From, class To>
[[gnu::always_inline]] inline void copyBits(const From& from, To& to)
{
  static_assert(sizeof from == sizeof to);
  std::memcpy(&to, &from, sizeof to);
}

/** A group of a vector: its numbers k and those k + 8. */
struct Group
{
  Floats low;
  Floats high;
};

[[gnu::always_inline]] inline void loadHalved(const std::uint32_t* from, Group& to)
{
  Words words;
  std::memcpy(&words, from, sizeof words);
  copyBits(words << 16, to.low);
  copyBits(words & upperHalf, to.high);
}

[[gnu::always_inline]] inline void roundToUpperHalf(Floats& values)
{
  Words words;
  copyBits(values, words);
  words = (words + 0x7FFFU + ((words >> 16) & 1U)) & upperHalf;
  copyBits(words, values);
}

/** Rounds a group to what two bytes a number hold, and writes it. */
[[gnu::always_inline]] inline void halve(Group& group, std::uint32_t* place)
{
  roundToUpperHalf(group.low);
  roundToUpperHalf(group.high);
  Words low;
  Words high;
  copyBits(group.low, low);
  copyBits(group.high, high);
  low = (low >> 16) | high;
  std::memcpy(place, &low, sizeof low);
}

/** Adds the products of two groups. As doubles: the products of rounding noise are no floats. */
[[gnu::always_inline]] inline void addProducts(const Group& a, const Group& b, Lanes& sums)
{
  sums += __builtin_convertvector(a.low, Lanes) * __builtin_convertvector(b.low, Lanes);
  sums += __builtin_convertvector(a.high, Lanes) * __builtin_convertvector(b.high, Lanes);
}

[[gnu::always_inline]] inline double sumOf(const Lanes& s)
{
  return ((s[0] + s[1]) + (s[2] + s[3])) + ((s[4] + s[5]) + (s[6] + s[7]));
}

struct Recursion
{
  [[gnu::always_inline]] static inline double run(const RecursionPass& task)
  {
    Lanes sums{};
    for (std::size_t g = 0; g < task.groups; ++g)
    {
      float* const place = task.vector + g * groupOfNumbers;
      Group values;
      Group other;
      std::memcpy(&values, place, sizeof values);
      if (task.added)
      {
        loadHalved(task.added + g * wordsOfGroup, other);
        values.low += task.factor * other.low;
        values.high += task.factor * other.high;
        std::memcpy(place, &values, sizeof values);
      }
      if (task.next)
      {
        loadHalved(task.next + g * wordsOfGroup, other);
        addProducts(values, other, sums);
      }
    }
    return sumOf(sums);
  }
};

struct Pair
{
  /** factor (b - a) as floats. */
  [[gnu::always_inline]] static inline void differ(
    const double* a, const double* b, double factor, Group& result)
  {
    Lanes x;
    Lanes y;
    load(a, x);
    load(b, y);
    result.low = __builtin_convertvector(factor * (y - x), Floats);
    load(a + lanes, x);
    load(b + lanes, y);
    result.high = __builtin_convertvector(factor * (y - x), Floats);
  }

  [[gnu::always_inline]] static inline void runGroup(const PairPass& task, Lanes& sums)
  {
    Group step;
    Group change;
    differ(task.placeBefore, task.placeAfter, 1.0, step);
    differ(task.momentBefore, task.momentAfter, -2.0, change);
    halve(step, task.step);
    halve(change, task.change);
    addProducts(step, change, sums);
  }

  /** The last group, if it is not whole. */
  [[gnu::always_inline]] static inline void runRest(
    const PairPass& task, std::size_t begin, Lanes& sums)
  {
    double rows[4][groupOfNumbers] = {};
    const double* const from[4] = { task.placeBefore, task.placeAfter, task.momentBefore,
      task.momentAfter };
    for (int row = 0; row < 4; ++row)
    {
      std::copy_n(from[row] + begin, task.count - begin, rows[row]);
    }
    runGroup({ rows[0], rows[1], rows[2], rows[3], groupOfNumbers, task.step + begin / 2,
               task.change + begin / 2 },
      sums);
  }

  [[gnu::always_inline]] static inline double run(const PairPass& task)
  {
    Lanes sums{};
    std::size_t k = 0;
    for (; k + groupOfNumbers <= task.count; k += groupOfNumbers)
    {
      runGroup({ task.placeBefore + k, task.placeAfter + k, task.momentBefore + k,
                 task.momentAfter + k, groupOfNumbers, task.step + k / 2, task.change + k / 2 },
        sums);
    }
    if (k < task.count)
    {
      runRest(task, k, sums);
    }
    return sumOf(sums);
  }
};
}

HistoryPasses historyPasses(InstructionSet set)
{
  return { CompiledFor<Recursion, const RecursionPass&>::select(set),
    CompiledFor<Pair, const PairPass&>::select(set) };
}
}
