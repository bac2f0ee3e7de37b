// Voronoi/Expansion: exact sums, told by their signs.

#include "Support/Random.h"
#include "TestChecks.h"
#include "Voronoi/Expansion.h"

#include <vector>

using namespace remesh;

namespace
{
__extension__ typedef __int128 Integer;

int signOf(Integer value)
{
  return (value > 0) - (value < 0);
}

int signOfSum(const std::vector<double>& terms)
{
  Expansion sum;
  for (const double term : terms)
  {
    sum.add(term);
  }
  return sum.sign();
}

void testSums()
{
  CHECK_EQUAL(Expansion().sign(), 0);
  CHECK_EQUAL(signOfSum({ 0.0, -0.0 }), 0);
  CHECK_EQUAL(signOfSum({ 1.0, -1.0 }), 0);
  // Tiny against huge: lost in a double, kept here, and left when the huge ones cancel.
  CHECK_EQUAL(signOfSum({ 1e300, 1e-300, -1e300 }), 1);
  CHECK_EQUAL(signOfSum({ 1e-300, 1e300, -1e300, -2e-300 }), -1);
  CHECK_EQUAL(signOfSum({ 1e300, 1.0, 0x1p-1074, -1.0, -1e300 }), 1);
  CHECK_EQUAL(signOfSum({ 1e300, 1.0, 0x1p-1074, -1.0, -1e300, -0x1p-1074 }), 0);
  // (1 + 2^-52) (1 - 2^-52) = 1 - 2^-104
  Expansion product;
  product.addProduct(1.0 + 0x1p-52, 1.0 - 0x1p-52);
  product.add(-1.0);
  CHECK_EQUAL(product.sign(), -1);
  product.add(0x1p-104);
  CHECK_EQUAL(product.sign(), 0);
}

void testEstimate()
{
  CHECK_EQUAL(Expansion().estimate(), 0.0);
  Expansion sum;
  sum.add(1e300);
  sum.addProduct(3.0, 0.25);
  sum.add(-1e300);
  CHECK_EQUAL(sum.estimate(), 0.75);
  sum.add(0x1p-60);
  CHECK_NEAR(sum.estimate(), 0.75, 0x1p-52);
}

/** All powers of two there and back, in both orders: many terms that do not overlap. */
void testManyTerms()
{
  std::vector<double> terms;
  for (int e = 0; e < 90; ++e)
  {
    terms.push_back(std::ldexp(1.0, 11 * e - 500));
  }
  CHECK_EQUAL(signOfSum(terms), 1);
  for (int e = 0; e < 90; ++e)
  {
    terms.push_back(-terms[e]);
  }
  CHECK_EQUAL(signOfSum(terms), 0);
  terms.insert(terms.begin(), -0x1p-1000);
  CHECK_EQUAL(signOfSum(terms), -1);
  terms.front() = 0x1p-1000;
  CHECK_EQUAL(signOfSum({ terms.rbegin(), terms.rend() }), 1);
}

/** A sum of 24 triple products (as in Predicates.cxx) against 128-bit integers. */
void testTripleProducts(double largest, double scale)
{
  int wrong = 0;
  int zeros = 0;
  std::uint64_t draw = 0;
  const auto number = [&]() { return std::floor((2.0 * uniform01(1, draw++, 0) - 1.0) * largest); };
  for (int c = 0; c < 20000; ++c)
  {
    Expansion sum;
    Integer expected = 0;
    for (int t = 0; t < 23; ++t)
    {
      const double x = number(), y = number(), z = number();
      sum.addProduct(scale * x, y, z / scale);
      expected += static_cast<Integer>(x) * static_cast<Integer>(y) * static_cast<Integer>(z);
    }
    wrong += sum.sign() != signOf(expected);
    // The rest of the sum in digits of 30 bits leaves nothing, or one unit.
    const int unit = static_cast<int>(number()) % 2;
    Integer rest = unit - expected;
    for (double digit = 1.0; rest != 0; digit *= 0x1p30)
    {
      const Integer low = rest % (Integer(1) << 30);
      sum.addProduct(digit, static_cast<double>(static_cast<long long>(low)), 1.0);
      rest /= Integer(1) << 30;
    }
    wrong += sum.sign() != unit;
    zeros += unit == 0;
  }
  CHECK_EQUAL(wrong, 0);
  CHECK(zeros > 5000);
}
}

int TestExpansion(int, char*[])
{
  testSums();
  testEstimate();
  testManyTerms();
  testTripleProducts(10.0, 1.0);
  testTripleProducts(0x1p39, 1.0);
  testTripleProducts(0x1p39, 0x1p-90);
  return test::result();
}
