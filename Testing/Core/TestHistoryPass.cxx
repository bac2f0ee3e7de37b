// Optimization/HistoryPass: numbers in two bytes are the nearest to those they are made from; the
// passes do what they say, of any length, and to the same bits for all sets of instructions.

#include "Optimization/HistoryPass.h"
#include "Support/Random.h"
#include "TestLanes.h"
#include "TestSupport.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace remesh;

namespace
{
constexpr std::uint32_t untouched = 0xA5A5A5A5U;

std::size_t groupsOf(std::size_t count)
{
  return (count + groupOfNumbers - 1) / groupOfNumbers;
}

/** The step from zeros to these, and a change of the gradient by -2 times the same. */
struct Pair
{
  HalvedNumbers step;
  HalvedNumbers change;
  double product = 0.0;

  Pair(const std::vector<double>& values, InstructionSet set)
    : step(groupsOf(values.size()) * wordsOfGroup, untouched)
    , change(step)
  {
    const std::vector<double> zeros(values.size(), 0.0);
    this->product = historyPasses(set).pair({ zeros.data(), values.data(), zeros.data(),
      values.data(), values.size(), this->step.data(), this->change.data() });
  }
};

float rounded(float value)
{
  const double zero = 0.0;
  const double place = value;
  HalvedNumbers step(wordsOfGroup, untouched);
  HalvedNumbers change(step);
  historyPasses(InstructionSet::Baseline)
    .pair({ &zero, &place, &zero, &zero, 1, step.data(), change.data() });
  return numberOf(step, 0);
}

void testFitting()
{
  for (const float value :
    { 0.0F, 1.0F, -1.0F, 1.5F, 0.0078125F, -3.25F, 0x1.FEp127F, 0x1p-126F, 0x1p-133F })
  {
    CHECK_EQUAL(rounded(value), value);
  }
  CHECK(std::signbit(rounded(-0.0F)));
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
    const float spacing = std::ldexp(1.0F, std::ilogb(value) - 7);
    CHECK(std::abs(rounded(value) - value) <= 0.5F * spacing);
    CHECK_EQUAL(std::fmod(rounded(value), spacing), 0.0F);
  }
}

std::vector<double> randomNumbers(std::size_t count, std::uint64_t seed)
{
  std::vector<double> numbers(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    numbers[k] = 2.0 * uniform01(seed, k, 0) - 1.0;
  }
  return numbers;
}

void testPairs()
{
  for (const std::size_t count : { 1, 7, 8, 15, 16, 17, 31, 32, 1000 })
  {
    const std::vector<double> values = randomNumbers(count, 1);
    const Pair pair(values, InstructionSet::Baseline);
    double product = 0.0;
    for (std::size_t k = 0; k < count; ++k)
    {
      const auto value = static_cast<float>(values[k]);
      CHECK_EQUAL(numberOf(pair.step, k), rounded(value));
      CHECK_EQUAL(numberOf(pair.change, k), -2.0F * numberOf(pair.step, k));
      product -= 2.0 * rounded(value) * rounded(value);
    }
    for (std::size_t k = count; k < groupsOf(count) * groupOfNumbers; ++k)
    {
      CHECK_EQUAL(numberOf(pair.step, k), 0.0F); // what fills the last group
    }
    CHECK_NEAR(pair.product, product, 1e-6 * std::abs(product));
    for (const InstructionSet set : test::availableSets())
    {
      const Pair other(values, set);
      CHECK(other.step == pair.step && other.change == pair.change);
      CHECK_EQUAL(other.product, pair.product);
    }
  }
}

/** Products of numbers that are rounding noise are no floats, but they count. */
void testNoise()
{
  std::vector<double> values = randomNumbers(100, 5);
  const double product = Pair(values, InstructionSet::Baseline).product;
  constexpr double small = 0x1p-80;
  std::transform(
    values.begin(), values.end(), values.begin(), [](double value) { return small * value; });
  const Pair pair(values, InstructionSet::Baseline);
  CHECK_EQUAL(pair.product, small * small * product);
  std::vector<float> vector(groupsOf(100) * groupOfNumbers, static_cast<float>(small));
  const double sum = historyPasses(widestInstructionSet())
                       .recur({ vector.data(), groupsOf(100), 0.0F, nullptr, pair.step.data() });
  CHECK(sum != 0.0 && std::abs(sum) < 1e-45);
}

void testRecursion()
{
  constexpr std::size_t count = 500;
  const Pair first(randomNumbers(count, 2), InstructionSet::Baseline);
  const Pair second(randomNumbers(count, 3), InstructionSet::Baseline);
  std::vector<float> start(groupsOf(count) * groupOfNumbers, 0.0F);
  for (std::size_t k = 0; k < count; ++k)
  {
    start[k] = static_cast<float>(uniform01(4, k, 0));
  }
  for (const bool adds : { false, true })
  {
    for (const bool multiplies : { false, true })
    {
      std::vector<float> expected = start;
      double product = 0.0;
      for (std::size_t k = 0; k < count; ++k)
      {
        expected[k] += adds ? 0.3F * numberOf(first.step, k) : 0.0F;
        product += multiplies ? static_cast<double>(expected[k]) * numberOf(second.step, k) : 0.0;
      }
      double baseline = 0.0;
      for (const InstructionSet set : test::availableSets())
      {
        std::vector<float> vector = start;
        const double found = historyPasses(set).recur({ vector.data(), groupsOf(count), 0.3F,
          adds ? first.step.data() : nullptr, multiplies ? second.step.data() : nullptr });
        CHECK(vector == expected);
        CHECK_NEAR(found, product, 1e-5);
        baseline = set == test::availableSets().front() ? found : baseline;
        CHECK_EQUAL(found, baseline);
      }
    }
  }
}
}

int TestHistoryPass(int, char*[])
{
  testFitting();
  testNearest();
  testPairs();
  testNoise();
  testRecursion();
  return test::result();
}
