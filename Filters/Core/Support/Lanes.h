/**
 * @file Lanes.h
 * @brief Several numbers at once, in vectors of the width that a set of instructions has.
 *
 * GCC takes vectors that are wider than the registers apart in memory. So eight numbers are one,
 * two or four vectors; CompiledInLanes.h chooses. Each lane is worked on alone, so that all give
 * the same bits.
 */
#ifndef remesh_Lanes_h
#define remesh_Lanes_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__GNUC__) && !defined(__clang__)
// All of it is inlined: no vector is ever passed to a function. And GCC 12 takes some vectors that
// are set part by part for read before.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace remesh
{
constexpr int lanes = 8;

/** Rounds up. */
constexpr int wholeLanes(int count)
{
  return (count + lanes - 1) / lanes * lanes;
}

/** The least of so many numbers. */
[[gnu::always_inline]] inline double minOfLanes(const double* n)
{
  const double low = std::min(std::min(n[0], n[1]), std::min(n[2], n[3]));
  const double high = std::min(std::min(n[4], n[5]), std::min(n[6], n[7]));
  return std::min(low, high);
}

template <int Width>
struct NativeVector;
template <>
struct NativeVector<2>
{
  using Numbers = double __attribute__((vector_size(16)));
  using Floats = float __attribute__((vector_size(8)));
  using Words = std::uint32_t __attribute__((vector_size(8)));
  using Bits = unsigned long long __attribute__((vector_size(16)));
};
template <>
struct NativeVector<4>
{
  using Numbers = double __attribute__((vector_size(32)));
  using Floats = float __attribute__((vector_size(16)));
  using Words = std::uint32_t __attribute__((vector_size(16)));
  using Bits = unsigned long long __attribute__((vector_size(32)));
};
template <>
struct NativeVector<8>
{
  using Numbers = double __attribute__((vector_size(64)));
  using Floats = float __attribute__((vector_size(32)));
  using Words = std::uint32_t __attribute__((vector_size(32)));
  using Bits = unsigned long long __attribute__((vector_size(64)));
};

/** Eight masks: all bits of a lane, or none. */
template <int Width>
struct LaneBits
{
  static constexpr int parts = lanes / Width;
  using Vector = typename NativeVector<Width>::Bits;
  Vector part[parts];

  [[gnu::always_inline]] inline friend LaneBits operator&(const LaneBits& a, const LaneBits& b)
  {
    LaneBits c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] & b.part[k];
    }
    return c;
  }
  [[gnu::always_inline]] inline friend LaneBits operator~(const LaneBits& a)
  {
    LaneBits c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = ~a.part[k];
    }
    return c;
  }
};

/** Eight numbers. Not set when made. */
template <int Width>
struct Lanes
{
  static constexpr int width = Width;
  static constexpr int parts = lanes / Width;
  using Vector = typename NativeVector<Width>::Numbers;
  using Bits = LaneBits<Width>;
  Vector part[parts];

  Lanes() = default;
  [[gnu::always_inline]] inline explicit Lanes(double number)
  {
    for (Vector& vector : part)
    {
      vector = number - Vector{};
    }
  }

  [[gnu::always_inline]] inline friend Lanes operator+(const Lanes& a, const Lanes& b)
  {
    Lanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] + b.part[k];
    }
    return c;
  }
  [[gnu::always_inline]] inline friend Lanes operator-(const Lanes& a, const Lanes& b)
  {
    Lanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] - b.part[k];
    }
    return c;
  }
  [[gnu::always_inline]] inline friend Lanes operator*(const Lanes& a, const Lanes& b)
  {
    Lanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] * b.part[k];
    }
    return c;
  }
  [[gnu::always_inline]] inline friend Lanes operator/(const Lanes& a, const Lanes& b)
  {
    Lanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] / b.part[k];
    }
    return c;
  }
  // With a plain number, written out: made into lanes by the constructor, a run took 8 % longer.
  [[gnu::always_inline]] inline friend Lanes operator+(double a, const Lanes& b)
  {
    Lanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a + b.part[k];
    }
    return c;
  }
  [[gnu::always_inline]] inline friend Lanes operator-(double a, const Lanes& b)
  {
    Lanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a - b.part[k];
    }
    return c;
  }
  [[gnu::always_inline]] inline friend Lanes operator*(double a, const Lanes& b)
  {
    Lanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a * b.part[k];
    }
    return c;
  }
  [[gnu::always_inline]] inline friend Lanes operator+(const Lanes& a, double b)
  {
    Lanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] + b;
    }
    return c;
  }
  [[gnu::always_inline]] inline friend Lanes operator-(const Lanes& a, double b)
  {
    Lanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = a.part[k] - b;
    }
    return c;
  }
  [[gnu::always_inline]] inline friend Lanes operator*(const Lanes& a, double b)
  {
    Lanes c;
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
  [[gnu::always_inline]] inline friend Lanes operator-(const Lanes& a)
  {
    Lanes c;
    for (int k = 0; k < parts; ++k)
    {
      c.part[k] = -a.part[k];
    }
    return c;
  }
};

template <int W>
[[gnu::always_inline]] inline void load(const double* from, Lanes<W>& to)
{
  for (int k = 0; k < to.parts; ++k)
  {
    std::memcpy(&to.part[k], from + k * W, sizeof to.part[k]);
  }
}

template <int W>
[[gnu::always_inline]] inline void store(const Lanes<W>& from, double* to)
{
  for (int k = 0; k < from.parts; ++k)
  {
    std::memcpy(to + k * W, &from.part[k], sizeof from.part[k]);
  }
}

/** Made wider, which is exact. */
template <int W>
[[gnu::always_inline]] inline void load(const float* from, Lanes<W>& to)
{
  for (int k = 0; k < to.parts; ++k)
  {
    typename NativeVector<W>::Floats floats;
    std::memcpy(&floats, from + k * W, sizeof floats);
    to.part[k] = __builtin_convertvector(floats, typename Lanes<W>::Vector);
  }
}

/** All bits of the lanes that are negative: by the sign's bit, so of minus zero, too. */
template <int W>
[[gnu::always_inline]] inline void findNegative(const Lanes<W>& values, LaneBits<W>& negative)
{
  for (int k = 0; k < values.parts; ++k)
  {
    std::memcpy(&negative.part[k], &values.part[k], sizeof values.part[k]);
    negative.part[k] = 0ULL - (negative.part[k] >> 63);
  }
}

/** Marks the lanes that are negative, too. */
template <int W>
[[gnu::always_inline]] inline void addNegative(const Lanes<W>& values, LaneBits<W>& marks)
{
  LaneBits<W> negative;
  findNegative(values, negative);
  for (int k = 0; k < values.parts; ++k)
  {
    marks.part[k] |= negative.part[k];
  }
}

/** Adds up the marks of each lane: as all bits are set, they are minus one. */
template <int W>
[[gnu::always_inline]] inline void count(const LaneBits<W>& marks, LaneBits<W>& sums)
{
  for (int k = 0; k < marks.parts; ++k)
  {
    sums.part[k] -= marks.part[k];
  }
}

template <int W>
[[gnu::always_inline]] inline int sumOf(const LaneBits<W>& numbers)
{
  unsigned long long n[lanes];
  for (int k = 0; k < numbers.parts; ++k)
  {
    std::memcpy(n + k * W, &numbers.part[k], sizeof numbers.part[k]);
  }
  return static_cast<int>(((n[0] + n[1]) + (n[2] + n[3])) + ((n[4] + n[5]) + (n[6] + n[7])));
}

/** Takes over the chosen lanes of other values. */
template <int W>
[[gnu::always_inline]] inline void replaceChosen(
  const Lanes<W>& by, const LaneBits<W>& chosen, Lanes<W>& values)
{
  for (int k = 0; k < values.parts; ++k)
  {
    typename LaneBits<W>::Vector bits;
    typename LaneBits<W>::Vector rest;
    std::memcpy(&bits, &by.part[k], sizeof bits);
    std::memcpy(&rest, &values.part[k], sizeof rest);
    bits = (bits & chosen.part[k]) | (rest & ~chosen.part[k]);
    std::memcpy(&values.part[k], &bits, sizeof bits);
  }
}

/** The values of the chosen lanes, `other` in the others. */
template <int W>
[[gnu::always_inline]] inline void keepChosen(
  const LaneBits<W>& chosen, double other, Lanes<W>& values)
{
  Lanes<W> kept(other);
  replaceChosen(values, chosen, kept);
  values = kept;
}

/** Zero instead of what is negative. */
template <int W>
[[gnu::always_inline]] inline void keepPositive(Lanes<W>& values)
{
  for (int k = 0; k < values.parts; ++k)
  {
    typename LaneBits<W>::Vector bits;
    std::memcpy(&bits, &values.part[k], sizeof bits);
    bits &= (bits >> 63) - 1ULL;
    std::memcpy(&values.part[k], &bits, sizeof bits);
  }
}

/** One bit for each lane that is marked. */
template <int W>
[[gnu::always_inline]] inline unsigned bitsOf(const LaneBits<W>& marks)
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
}

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#endif
