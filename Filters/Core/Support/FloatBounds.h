/**
 * @file FloatBounds.h
 * @brief Doubles that are not negative as floats that are not above them.
 */
#ifndef remesh_FloatBounds_h
#define remesh_FloatBounds_h

#include <cstdint>
#include <cstring>

namespace remesh
{
/** The next smaller float; 0 stays 0. */
inline float previousFloat(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  bits -= bits > 0 ? 1 : 0;
  std::memcpy(&value, &bits, sizeof bits);
  return value;
}

/** The largest float that is not above the value. */
inline float roundedDown(double value)
{
  const auto rounded = static_cast<float>(value);
  return rounded > value ? previousFloat(rounded) : rounded;
}

/** Below all values that round to the same float. */
inline float below(double value)
{
  return previousFloat(static_cast<float>(value));
}
}

#endif
