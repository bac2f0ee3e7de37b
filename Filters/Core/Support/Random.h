/**
 * @file Random.h
 * @brief Random numbers that depend on nothing but (seed, index, stream).
 *
 * A counter-based generator: the finaliser of SplitMix64 (G. Steele, D. Lea, C. Flood, OOPSLA 2014)
 * applied to a mix of the three keys. Any number can be drawn at any time, by any thread.
 */
#ifndef remesh_Random_h
#define remesh_Random_h

#include <cstdint>

namespace remesh
{
inline std::uint64_t mixBits(std::uint64_t x)
{
  x += 0x9E3779B97F4A7C15ull;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
  return x ^ (x >> 31);
}

/** Uniform in [0, 1), a multiple of 2^-53. */
inline double uniform01(std::uint64_t seed, std::uint64_t index, std::uint64_t stream)
{
  const std::uint64_t bits = mixBits(mixBits(mixBits(seed) ^ index) ^ stream);
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}
}

#endif
