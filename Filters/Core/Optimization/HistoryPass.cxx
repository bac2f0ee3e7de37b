#include "Optimization/HistoryPass.h"

#include "Support/CompiledInLanes.h"

#include <algorithm>

namespace remesh
{
namespace
{
static_assert(wordsOfGroup == lanes);

template <class From, class To>
[[gnu::always_inline]] inline void copyBits(const From& from, To& to)
{
  static_assert(sizeof from == sizeof to);
  std::memcpy(&to, &from, sizeof to);
}

/** A group of a vector, its numbers k and those k + 8; each part of lanes for itself. */
template <class L>
struct Group
{
  using Numbers = typename L::Vector;
  using Floats = typename NativeVector<L::width>::Floats;
  using Words = typename NativeVector<L::width>::Words;
  Floats low[L::parts];
  Floats high[L::parts];

  [[gnu::always_inline]] inline void load(const float* from)
  {
    std::memcpy(low, from, sizeof low);
    std::memcpy(high, from + lanes, sizeof high);
  }

  [[gnu::always_inline]] inline void store(float* to) const
  {
    std::memcpy(to, low, sizeof low);
    std::memcpy(to + lanes, high, sizeof high);
  }

  [[gnu::always_inline]] inline void loadHalved(const std::uint32_t* from)
  {
    for (int k = 0; k < L::parts; ++k)
    {
      Words words;
      std::memcpy(&words, from + k * L::width, sizeof words);
      copyBits(words << 16, low[k]);
      copyBits(words & upperHalf, high[k]);
    }
  }

  [[gnu::always_inline]] static inline void roundToUpperHalf(Floats& values, Words& words)
  {
    copyBits(values, words);
    words = (words + 0x7FFFU + ((words >> 16) & 1U)) & upperHalf;
    copyBits(words, values);
  }

  /** Rounds it to what two bytes a number hold, and writes it. */
  [[gnu::always_inline]] inline void halve(std::uint32_t* place)
  {
    for (int k = 0; k < L::parts; ++k)
    {
      Words lower;
      Words upper;
      roundToUpperHalf(low[k], lower);
      roundToUpperHalf(high[k], upper);
      lower = (lower >> 16) | upper;
      std::memcpy(place + k * L::width, &lower, sizeof lower);
    }
  }

  [[gnu::always_inline]] inline void add(float factor, const Group& other)
  {
    for (int k = 0; k < L::parts; ++k)
    {
      low[k] += factor * other.low[k];
      high[k] += factor * other.high[k];
    }
  }
};

/** Adds the products of two groups. As doubles: the products of rounding noise are no floats. */
template <class L>
[[gnu::always_inline]] inline void addProducts(const Group<L>& a, const Group<L>& b, L& sums)
{
  using Numbers = typename L::Vector;
  for (int k = 0; k < L::parts; ++k)
  {
    sums.part[k] +=
      __builtin_convertvector(a.low[k], Numbers) * __builtin_convertvector(b.low[k], Numbers);
    sums.part[k] +=
      __builtin_convertvector(a.high[k], Numbers) * __builtin_convertvector(b.high[k], Numbers);
  }
}

template <class L>
[[gnu::always_inline]] inline double sumOf(const L& sums)
{
  double s[lanes];
  store(sums, s);
  return ((s[0] + s[1]) + (s[2] + s[3])) + ((s[4] + s[5]) + (s[6] + s[7]));
}

struct Recursion
{
  template <class L>
  [[gnu::always_inline]] static inline double run(const RecursionPass& task)
  {
    L sums{};
    for (std::size_t g = 0; g < task.groups; ++g)
    {
      float* const place = task.vector + g * groupOfNumbers;
      Group<L> values;
      Group<L> other;
      values.load(place);
      if (task.added)
      {
        other.loadHalved(task.added + g * wordsOfGroup);
        values.add(task.factor, other);
        values.store(place);
      }
      if (task.next)
      {
        other.loadHalved(task.next + g * wordsOfGroup);
        addProducts(values, other, sums);
      }
    }
    return sumOf(sums);
  }
};

struct Pair
{
  /** factor (b - a) as floats. */
  template <class L>
  [[gnu::always_inline]] static inline void differ(
    const double* a, const double* b, double factor, typename Group<L>::Floats (&result)[L::parts])
  {
    L x;
    L y;
    load(a, x);
    load(b, y);
    x = factor * (y - x);
    for (int k = 0; k < L::parts; ++k)
    {
      result[k] = __builtin_convertvector(x.part[k], typename Group<L>::Floats);
    }
  }

  template <class L>
  [[gnu::always_inline]] static inline void runGroup(const PairPass& task, L& sums)
  {
    Group<L> step;
    Group<L> change;
    differ<L>(task.placeBefore, task.placeAfter, 1.0, step.low);
    differ<L>(task.placeBefore + lanes, task.placeAfter + lanes, 1.0, step.high);
    differ<L>(task.momentBefore, task.momentAfter, -2.0, change.low);
    differ<L>(task.momentBefore + lanes, task.momentAfter + lanes, -2.0, change.high);
    step.halve(task.step);
    change.halve(task.change);
    addProducts(step, change, sums);
  }

  /** The last group, if it is not whole. */
  template <class L>
  [[gnu::always_inline]] static inline void runRest(
    const PairPass& task, std::size_t begin, L& sums)
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

  template <class L>
  [[gnu::always_inline]] static inline double run(const PairPass& task)
  {
    L sums{};
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
  return { CompiledInLanes<Recursion, const RecursionPass&>::select(set),
    CompiledInLanes<Pair, const PairPass&>::select(set) };
}
}
