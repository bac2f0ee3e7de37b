/**
 * @file Hilbert.h
 * @brief Position of a point along a 3-D Hilbert curve, for orders that keep neighbours together.
 *
 * The transform from coordinates to the curve is that of J. Skilling, *Programming the Hilbert
 * curve*, AIP Conference Proceedings 707, 2004 ("AxestoTranspose", which he put in the public
 * domain), here for three axes of 21 bits.
 */
#ifndef remesh_Hilbert_h
#define remesh_Hilbert_h

#include "Support/Types.h"

namespace remesh
{
constexpr int hilbertBitsPerAxis = 21; ///< three axes fill 63 bits

/** Spreads the low 21 bits of x so that two zero bits follow each. */
inline std::uint64_t spreadBits3(std::uint64_t x)
{
  x &= 0x1FFFFF;
  x = (x | x << 32) & 0x001F00000000FFFF;
  x = (x | x << 16) & 0x001F0000FF0000FF;
  x = (x | x << 8) & 0x100F00F00F00F00F;
  x = (x | x << 4) & 0x10C30C30C30C30C3;
  x = (x | x << 2) & 0x1249249249249249;
  return x;
}

/** Each bit becomes the parity of the bits above it. */
inline std::uint32_t parityAbove(std::uint32_t x)
{
  x >>= 1;
  x ^= x >> 1;
  x ^= x >> 2;
  x ^= x >> 4;
  x ^= x >> 8;
  x ^= x >> 16;
  return x;
}

/** Distance along the curve (63 bits) of a cell of the 2^21-cubed grid. */
inline std::uint64_t hilbertKey(std::array<std::uint32_t, 3> axes)
{
  auto [x, y, z] = axes;
  for (int level = hilbertBitsPerAxis - 1; level > 0; --level)
  {
    // Skilling's step without branches: where an axis has this bit, the lower bits of x are
    // inverted, else they are exchanged with that axis's.
    const std::uint32_t below = (std::uint32_t(1) << level) - 1;
    x ^= (0u - (x >> level & 1)) & below;
    const std::uint32_t invertY = (0u - (y >> level & 1)) & below;
    const std::uint32_t exchangeY = (x ^ y) & (below ^ invertY);
    x ^= exchangeY | invertY;
    y ^= exchangeY;
    const std::uint32_t invertZ = (0u - (z >> level & 1)) & below;
    const std::uint32_t exchangeZ = (x ^ z) & (below ^ invertZ);
    x ^= exchangeZ | invertZ;
    z ^= exchangeZ;
  }
  y ^= x;
  z ^= y;
  const std::uint32_t gray = parityAbove(z);
  return spreadBits3(x ^ gray) << 2 | spreadBits3(y ^ gray) << 1 | spreadBits3(z ^ gray);
}

/**
 * Distance along the curve of a point of the cube at `lower` with side 1 / `inverseExtent`.
 * Points outside count as the nearest cell of the cube; a NaN coordinate as the lower side.
 */
inline std::uint64_t hilbertKey(const Point3& point, const Point3& lower, double inverseExtent)
{
  constexpr double cells = std::uint32_t(1) << hilbertBitsPerAxis;
  std::array<std::uint32_t, 3> axes{};
  for (int k = 0; k < 3; ++k)
  {
    const double position = (point[k] - lower[k]) * inverseExtent * cells;
    if (position > 0.0) // false for NaN
    {
      axes[k] = static_cast<std::uint32_t>(position < cells - 1.0 ? position : cells - 1.0);
    }
  }
  return hilbertKey(axes);
}
}

#endif
