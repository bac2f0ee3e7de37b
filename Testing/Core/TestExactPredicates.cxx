// Voronoi/Predicates against rational arithmetic: H values with all their bits, of real facets too.

#include "Support/Random.h"
#include "TestChecks.h"
#include "TestFacetSites.h"

#include <iostream>

using namespace remesh;

namespace
{
struct Dice
{
  std::uint64_t seed;
  std::uint64_t next = 0;

  double fraction() { return uniform01(this->seed, this->next++, 0); }
  int below(int bound) { return static_cast<int>(this->fraction() * bound); }
};

/** The arithmetic that all else is held against, where the answers are known. */
void testBigInteger()
{
  using test::BigInteger;
  const auto sign = [](const BigInteger& a) { return a.sign(); };
  const BigInteger one(1.0, 0);
  const BigInteger large = BigInteger::powerOfTwo(1000);
  CHECK_EQUAL(sign(BigInteger()), 0);
  CHECK_EQUAL(sign(BigInteger(0.0, 60)), 0);
  CHECK_EQUAL(sign(BigInteger(-3.0, 0) + BigInteger(0.375, 3)), 0);
  CHECK_EQUAL(sign(large - one), 1);
  CHECK_EQUAL(sign(one - large), -1);
  CHECK_EQUAL(sign((large - one) * (large + one) - large * large + one), 0);
  CHECK_EQUAL(sign((large - one) * (large + one) - large * large), -1);
  CHECK_EQUAL(sign(BigInteger(0x1.fffffffffffffp0, 52) - BigInteger(0x1.fffffffffffffp52, 0)), 0);
  BigInteger sum;
  for (int k = 0; k < 300; ++k) // 2^300 - 1 in parts, carried all the way
  {
    sum = sum + BigInteger::powerOfTwo(k);
  }
  CHECK_EQUAL(sign(sum + one - BigInteger::powerOfTwo(300)), 0);
}

/** What the perturbation means: of sites that tie everywhere, the lowest id is the least. */
void testPerturbation()
{
  const std::vector<FacetSite> sites = { { 4, { 1, 1, 1 } }, { 2, { 1, 1, 1 } }, { 9, { 1, 1, 1 } },
    { 3, { 1, 1.5, 0.5 } } };
  const test::ExactSites exact(sites);
  CHECK_EQUAL(exact.atCorner(0, 1, 2), 1);
  CHECK_EQUAL(exact.atCorner(0, 2, 0), -1);
  CHECK_EQUAL(exact.atCorner(2, 3, 0), 1);
  CHECK_EQUAL(exact.onEdge(1, 0, 3, 0), -1);
  CHECK_EQUAL(exact.onEdge(2, 0, 3, 0), 1);
  CHECK_EQUAL(exact.onEdge(2, 0, 1, 0), 0);
}

void testDecisions(int cases)
{
  Dice dice{ 1 };
  test::DecisionCount count;
  for (int c = 0; c < cases; ++c)
  {
    std::vector<FacetSite> sites = test::anyFacetSites(dice, 4);
    test::disturb(sites, dice);
    test::shuffleIds(sites, dice);
    test::checkDecisions(sites, count);
  }
  CHECK_EQUAL(count.wrong, 0);
  CHECK(count.corners > 1000000);
  CHECK(count.edges > 1000000);
  CHECK(count.inside > 1000000);
  std::cout << count.corners << " decisions at corners, " << count.edges << " on edges, "
            << count.inside << " inside\n";
}
}

int TestExactPredicates(int, char*[])
{
  testBigInteger();
  testPerturbation();
  testDecisions(300000);
  return test::result();
}
