// Support/FloatBounds: what std::nextafter says.

#include "Support/FloatBounds.h"
#include "Support/Random.h"
#include "TestChecks.h"

#include <cmath>
#include <limits>

using namespace remesh;

namespace
{
void checkBounds(double value)
{
  const auto nearest = static_cast<float>(value);
  const float previous = std::nextafter(nearest, 0.0F);
  CHECK_EQUAL(previousFloat(nearest), previous);
  CHECK_EQUAL(below(value), previous);
  const float down = roundedDown(value);
  CHECK(down <= value);
  CHECK(down == nearest || (nearest > value && down == previous));
}
}

int TestFloatBounds(int, char*[])
{
  for (const double value : { 0.0, 1.0, 2.0, 0x1p-126, 0x1p-149, 0x1.8p-149, 0x1p-160, 1e300,
         std::numeric_limits<double>::infinity() })
  {
    checkBounds(value);
  }
  for (std::uint64_t k = 0; k < 10000; ++k)
  {
    checkBounds(
      std::ldexp(1.0 + uniform01(k, 0, 0), static_cast<int>(250 * uniform01(k, 1, 0)) - 125));
  }
  return test::result();
}
