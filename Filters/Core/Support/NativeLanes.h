/**
 * @file NativeLanes.h
 * @brief The lanes of Lanes.h as vectors of the width that a set of instructions has.
 *
 * GCC takes vectors that are wider than the registers apart in memory: with AVX2 code became slower
 * than without. So a body is a template, `Body::run<L>(argument)`, where L is eight numbers in one,
 * two or four vectors, and is compiled for each set with its own L. The bits are the same.
 */
#ifndef remesh_NativeLanes_h
#define remesh_NativeLanes_h

#include "Support/Lanes.h"

#include <cstddef>

#if defined(__GNUC__) && !defined(__clang__)
// All of it is inlined: no vector is ever passed to a function. And GCC 12 takes some vectors that
// are set part by part for read before.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace remesh
{
template <int Width>
struct NativeVector;
template <>
struct NativeVector<2>
{
  using Numbers = double __attribute__((vector_size(16)));
  using Bits = unsigned long long __attribute__((vector_size(16)));
};
template <>
struct NativeVector<4>
{
  using Numbers = double __attribute__((vector_size(32)));
  using Bits = unsigned long long __attribute__((vector_size(32)));
};
template <>
struct NativeVector<8>
{
  using Numbers = double __attribute__((vector_size(64)));
  using Bits = unsigned long long __attribute__((vector_size(64)));
};

/** Eight masks: all bits of a lane, or none. */
template <int Width>
struct NativeBits
{
  static constexpr int parts = lanes / Width;
  using Vector = typename NativeVector<Width>::Bits;
  Vector part[parts];
};

/** Eight numbers. Not set when made. */
template <int Width>
struct NativeLanes
{
  static constexpr int width = Width;
  static constexpr int parts = lanes / Width;
  using Vector = typename NativeVector<Width>::Numbers;
  using Bits = NativeBits<Width>;
  Vector part[parts];

  NativeLanes() = default;
  [[gnu::always_inline]] inline explicit NativeLanes(double number)
  {
    for (Vector& vector : part)
    {
      vector = number - Vector{};
    }
  }

  [[gnu::always_inline]] inline friend NativeLanes operator+(
    const NativeLanes& a, const NativeLanes& b)
  {
    NativeLanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] + b.part[k];
    }
    return c;
  }
  [[gnu::always_inline]] inline friend NativeLanes operator-(
    const NativeLanes& a, const NativeLanes& b)
  {
    NativeLanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] - b.part[k];
    }
    return c;
  }
  [[gnu::always_inline]] inline friend NativeLanes operator*(
    const NativeLanes& a, const NativeLanes& b)
  {
    NativeLanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] * b.part[k];
    }
    return c;
  }
  [[gnu::always_inline]] inline friend NativeLanes operator/(
    const NativeLanes& a, const NativeLanes& b)
  {
    NativeLanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] / b.part[k];
    }
    return c;
  }
  // With a plain number, written out: made into lanes by the constructor, a run took 8 % longer.
  [[gnu::always_inline]] inline friend NativeLanes operator+(double a, const NativeLanes& b)
  {
    NativeLanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a + b.part[k];
    }
    return c;
  }
  [[gnu::always_inline]] inline friend NativeLanes operator-(double a, const NativeLanes& b)
  {
    NativeLanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a - b.part[k];
    }
    return c;
  }
  [[gnu::always_inline]] inline friend NativeLanes operator*(double a, const NativeLanes& b)
  {
    NativeLanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a * b.part[k];
    }
    return c;
  }
  [[gnu::always_inline]] inline friend NativeLanes operator+(const NativeLanes& a, double b)
  {
    NativeLanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] + b;
    }
    return c;
  }
  [[gnu::always_inline]] inline friend NativeLanes operator-(const NativeLanes& a, double b)
  {
    NativeLanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] - b;
    }
    return c;
  }
  [[gnu::always_inline]] inline friend NativeLanes operator*(const NativeLanes& a, double b)
  {
    NativeLanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] * b;
    }
    return c;
  }
  template <class Other>
  [[gnu::always_inline]] inline void operator+=(const Other& other)
  {
    *this = *this + other;
  }
  template <class Other>
  [[gnu::always_inline]] inline void operator-=(const Other& other)
  {
    *this = *this - other;
  }
  template <class Other>
  [[gnu::always_inline]] inline void operator*=(const Other& other)
  {
    *this = *this * other;
  }
  [[gnu::always_inline]] inline friend NativeLanes operator-(const NativeLanes& a)
  {
    NativeLanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = -a.part[k];
    }
    return c;
  }
};

template <int W>
[[gnu::always_inline]] inline void load(const double* from, NativeLanes<W>& to)
{
  for (int k = 0; k < to.parts; ++k)
  {
    std::memcpy(&to.part[k], from + k * W, sizeof to.part[k]);
  }
}

template <int W>
[[gnu::always_inline]] inline void store(const NativeLanes<W>& from, double* to)
{
  for (int k = 0; k < from.parts; ++k)
  {
    std::memcpy(to + k * W, &from.part[k], sizeof from.part[k]);
  }
}

/** Column m of eight rows. */
template <int W>
[[gnu::always_inline]] inline void readColumn(
  const double* const* rows, std::ptrdiff_t m, NativeLanes<W>& to)
{
  for (int k = 0; k < to.parts; ++k)
  {
    using Vector = typename NativeLanes<W>::Vector;
    const double* const* r = rows + k * W;
    if constexpr (W == 2)
    {
      const Vector column{ r[0][m], r[1][m] };
      std::memcpy(&to.part[k], &column, sizeof column);
    }
    else if constexpr (W == 4)
    {
      const Vector column{ r[0][m], r[1][m], r[2][m], r[3][m] };
      std::memcpy(&to.part[k], &column, sizeof column);
    }
    else
    {
      const Vector column{ r[0][m], r[1][m], r[2][m], r[3][m], r[4][m], r[5][m], r[6][m], r[7][m] };
      std::memcpy(&to.part[k], &column, sizeof column);
    }
  }
}

/** All bits of the lanes that are negative: by the sign's bit, so of minus zero, too. */
template <int W>
[[gnu::always_inline]] inline void findNegative(
  const NativeLanes<W>& values, NativeBits<W>& negative)
{
  for (int k = 0; k < values.parts; ++k)
  {
    std::memcpy(&negative.part[k], &values.part[k], sizeof values.part[k]);
    negative.part[k] = 0ULL - (negative.part[k] >> 63);
  }
}

/** Marks the lanes that are negative, too. */
template <int W>
[[gnu::always_inline]] inline void addNegative(const NativeLanes<W>& values, NativeBits<W>& marks)
{
  NativeBits<W> negative;
  findNegative(values, negative);
  for (int k = 0; k < values.parts; ++k)
  {
    marks.part[k] |= negative.part[k];
  }
}

/** Adds up the marks of each lane: as all bits are set, they are minus one. */
template <int W>
[[gnu::always_inline]] inline void count(const NativeBits<W>& marks, NativeBits<W>& sums)
{
  for (int k = 0; k < marks.parts; ++k)
  {
    sums.part[k] -= marks.part[k];
  }
}

template <int W>
[[gnu::always_inline]] inline int sumOf(const NativeBits<W>& numbers)
{
  unsigned long long n[lanes];
  for (int k = 0; k < numbers.parts; ++k)
  {
    std::memcpy(n + k * W, &numbers.part[k], sizeof numbers.part[k]);
  }
  return static_cast<int>(((n[0] + n[1]) + (n[2] + n[3])) + ((n[4] + n[5]) + (n[6] + n[7])));
}

/** The values of the chosen lanes, `other` in the others. */
template <int W>
[[gnu::always_inline]] inline void keepChosen(
  const NativeBits<W>& chosen, double other, NativeLanes<W>& values)
{
  const NativeLanes<W> others(other);
  for (int k = 0; k < values.parts; ++k)
  {
    typename NativeBits<W>::Vector bits;
    typename NativeBits<W>::Vector rest;
    std::memcpy(&bits, &values.part[k], sizeof bits);
    std::memcpy(&rest, &others.part[k], sizeof rest);
    bits = (bits & chosen.part[k]) | (rest & ~chosen.part[k]);
    std::memcpy(&values.part[k], &bits, sizeof bits);
  }
}

/** Zero instead of what is negative. */
template <int W>
[[gnu::always_inline]] inline void keepPositive(NativeLanes<W>& values)
{
  for (int k = 0; k < values.parts; ++k)
  {
    typename NativeBits<W>::Vector bits;
    std::memcpy(&bits, &values.part[k], sizeof bits);
    bits &= (bits >> 63) - 1ULL;
    std::memcpy(&values.part[k], &bits, sizeof bits);
  }
}

/** One bit for each lane that is marked. */
template <int W>
[[gnu::always_inline]] inline unsigned bitsOf(const NativeBits<W>& marks)
{
  unsigned long long bits[lanes];
  for (int k = 0; k < marks.parts; ++k)
  {
    std::memcpy(bits + k * W, &marks.part[k], sizeof marks.part[k]);
  }
  unsigned long long sum = 0;
  for (int lane = 0; lane < lanes; ++lane)
  {
    sum |= bits[lane] & (1ULL << lane);
  }
  return static_cast<unsigned>(sum);
}

/** Copies of `Body::run<L>(Argument)`, which must be inlined, each with the lanes of its set. */
template <class Body, class Argument>
class CompiledInLanes
{
public:
  using Result = decltype(Body::template run<NativeLanes<2>>(std::declval<Argument>()));
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
    return Body::template run<NativeLanes<2>>(argument);
  }
#if defined(__x86_64__)
  [[gnu::target("avx2")]] static Result avx2(Argument argument)
  {
    return Body::template run<NativeLanes<4>>(argument);
  }
#if defined(__clang__) // knows no such preference
  [[gnu::target("avx512f,avx512dq,avx512vl")]]
#else
  [[gnu::target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")]]
#endif
  static Result
  avx512(Argument argument)
  {
    return Body::template run<NativeLanes<8>>(argument);
  }
#endif
};
}

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#endif
