// Numbers in two bytes: nearest to the float they are made from, and the same float again if it
// fits.

#include "Support/Bfloat16.h"
#include "Support/Random.h"
#include "TestChecks.h"

#include <cmath>
#include <limits>

using namespace remesh;

namespace
{
float rounded(float value)
{
  return static_cast<float>(Bfloat16(value));
}

void testFitting()
{
  for (const float value :
    { 0.0F, 1.0F, -1.0F, 1.5F, 0.0078125F, -3.25F, 0x1.FEp127F, 0x1p-126F, 0x1p-133F })
  {
    CHECK_EQUAL(rounded(value), value);
  }
  CHECK(std::signbit(rounded(-0.0F)));
  CHECK_EQUAL(static_cast<float>(Bfloat16()), 0.0F);
}

void testNearest()
{
  // Halfway between two neighbours: to the even one.
  CHECK_EQUAL(rounded(1.0F + 0x1p-8F), 1.0F);
  CHECK_EQUAL(rounded(1.0F + 0x3p-8F), 1.0F + 0x4p-8F);
  CHECK_EQUAL(rounded(1.0F + 0x1.01p-8F), 1.0F + 0x1p-7F);
  for (std::uint64_t k = 0; k < 10000; ++k)
  {
    const auto value = static_cast<float>(
      std::ldexp(uniform01(k, 0, 0) - 0.5, static_cast<int>(200.0 * uniform01(k, 1, 0)) - 100));
    CHECK(std::abs(rounded(value) - value) <= 0x1p-8F * std::abs(value));
  }
}
}

int TestBfloat16(int, char*[])
{
  testFitting();
  testNearest();
  return test::result();
}
