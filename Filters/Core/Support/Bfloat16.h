/**
 * @file Bfloat16.h
 * @brief Numbers in two bytes: a float's range, with two to three digits.
 */
#ifndef remesh_Bfloat16_h
#define remesh_Bfloat16_h

#include <cstdint>
#include <cstring>

namespace remesh
{
/** The upper half of a float, rounded to nearest, ties to even. Not for infinities and NaN. */
class Bfloat16
{
public:
  Bfloat16() = default;
  explicit Bfloat16(float value)
  {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    m_bits = static_cast<std::uint16_t>((bits + 0x7FFFU + ((bits >> 16) & 1U)) >> 16);
  }

  operator float() const
  {
    const std::uint32_t bits = static_cast<std::uint32_t>(m_bits) << 16;
    float value = 0.0F;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

private:
  std::uint16_t m_bits = 0;
};
}

#endif
