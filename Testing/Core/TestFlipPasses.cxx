// The passes of a repair of flipped triangles: what each may do, and when they end.
#include "Placement/FlipPasses.h"
#include "TestChecks.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace
{
using namespace remesh;

constexpr Offset manyTriangles = 100000;

using Flipped = std::function<Offset(int pass)>; ///< how many are flipped when it is entered
using Steps = std::function<Offset(int pass)>;   ///< how many there have been until then

/** A pass as a repair sees it. */
struct Pass
{
  bool isBest;
  bool mayTurn;
  bool mayRefill;
  Effort effort;
  double leastGain;
};

std::vector<Pass> passesOf(
  const Flipped& flipped, const Steps& steps, FlipSteps kind = FlipSteps::MoveAndTurn)
{
  FlipPasses passes(kind, manyTriangles);
  std::vector<Pass> entered;
  for (int pass = 0; pass < 1000; ++pass)
  {
    FlipRepair repair;
    repair.flippedTriangles = flipped(pass);
    repair.movedVertices = steps(pass);
    if (!passes.enter(repair))
    {
      return entered;
    }
    entered.push_back({ passes.isBest(), passes.mayTurn(), passes.mayRefill(), passes.effort(),
      passes.leastGain() });
  }
  CHECK(false); // there is always a last one
  return entered;
}

Flipped always(Offset count)
{
  return [=](int) { return count; };
}

Offset oneInEach(int pass)
{
  return pass;
}

/** No step in the passes until all efforts but the last have been made; then one in each. */
Offset onlyLate(int pass)
{
  return pass < 8 ? 0 : pass;
}

/** Without flipped triangles there is nothing to do. */
void testNothing()
{
  CHECK(passesOf(always(0), oneInEach).empty());
}

/** Where only vertices may move, every step must turn a triangle back. */
void testMoving()
{
  const std::vector<Pass> moving = passesOf(always(5), oneInEach, FlipSteps::Move);
  CHECK(!moving.empty());
  for (const Pass& pass : moving)
  {
    CHECK(!pass.mayTurn);
    CHECK(!pass.isBest);
    CHECK_EQUAL(pass.leastGain, strayCost);
  }
  CHECK(passesOf(always(5), oneInEach).size() > moving.size());
}

/** Where no step is found, more and more is tried, and then no more. */
void testEfforts()
{
  const std::vector<Pass> passes = passesOf(always(5), [](int) { return 0; });
  CHECK(passes.size() > 3);
  CHECK(passes.front().effort == Effort::OwnStars);
  CHECK(passes.back().effort == Effort::KeptAnyway);
  for (std::size_t k = 1; k < passes.size(); ++k)
  {
    const int more = static_cast<int>(passes[k].effort) - static_cast<int>(passes[k - 1].effort);
    CHECK(more == 0 || more == 1);
  }
  for (const Pass& pass : passesOf(always(5), oneInEach))
  {
    CHECK(pass.effort == Effort::OwnStars);
  }
}

Offset passesThatRefill(const std::vector<Pass>& passes)
{
  return std::count_if(
    passes.begin(), passes.end(), [](const Pass& pass) { return pass.mayRefill; });
}

/** Cavities are filled once, and after passes in vain; in each pass if few are flipped. */
void testRefilling()
{
  const auto refilling = [](const Flipped& flipped, const Steps& steps)
  { return passesThatRefill(passesOf(flipped, steps, FlipSteps::Refill)); };
  CHECK_EQUAL(refilling(always(fewFlipped + 1), oneInEach), 1);
  CHECK(refilling(always(fewFlipped), oneInEach) > 3);
  CHECK(refilling(always(fewFlipped + 1), onlyLate) > 1);
  for (const FlipSteps steps : { FlipSteps::Move, FlipSteps::MoveAndTurn })
  {
    CHECK_EQUAL(passesThatRefill(passesOf(always(5), oneInEach, steps)), 0);
  }
}

Offset passesAtLastEffort(const Flipped& flipped)
{
  const std::vector<Pass> passes = passesOf(flipped, onlyLate);
  return std::count_if(passes.begin(), passes.end(),
    [](const Pass& pass) { return pass.effort == Effort::KeptAnyway; });
}

/** At the last effort steps may go on and on; with many triangles left, not if none is mended. */
void testVain()
{
  const Offset many = passesAtLastEffort(always(fewFlipped + 1));
  CHECK(many > 1);
  CHECK(passesAtLastEffort(always(fewFlipped)) > many + 1);
  const int first = 7; // at that effort
  for (const int fall : { first + 1, first + 2 })
  {
    const auto falling = [=](int pass) { return fewFlipped + (pass < fall ? 2 : 1); };
    CHECK_EQUAL(passesAtLastEffort(falling), many + fall - first);
    const auto rising = [=](int pass) { return fewFlipped + (pass < fall ? 2 : 3); };
    CHECK_EQUAL(passesAtLastEffort(rising), many);
  }
}

/** Far too many are only worth passes that halve them, and no turned edges. */
void testTooMany()
{
  const Offset most = mostFlipped(manyTriangles);
  CHECK_EQUAL(passesOf(always(most + 1), oneInEach).size(), 1U);
  CHECK(passesOf(always(most), oneInEach).back().mayTurn);
  const std::vector<Pass> halved =
    passesOf([=](int pass) { return ((most + 1) << 20) >> pass; }, oneInEach);
  CHECK(halved.size() > 1);
  CHECK(!halved.back().mayTurn);
}

/** From where steps may spoil something, each mesh with fewer flipped than all before is kept. */
void testBest()
{
  const std::vector<Offset> flipped{ 30, 5, 6, 7, 9, 8, 8, 9, 7, 8, 6 };
  const std::vector<Pass> passes =
    passesOf([&](int pass) { return flipped[pass % flipped.size()]; }, oneInEach);
  CHECK(passes.size() > flipped.size());
  Offset fewest = 1000;
  for (std::size_t k = 0; k < flipped.size(); ++k)
  {
    const bool maySpoil = passes[k].leastGain < strayCost;
    CHECK_EQUAL(passes[k].isBest, maySpoil && flipped[k] < fewest);
    fewest = maySpoil ? std::min(fewest, flipped[k]) : fewest;
  }
  CHECK_EQUAL(fewest, 6);
}
}

int TestFlipPasses(int, char*[])
{
  testNothing();
  testMoving();
  testEfforts();
  testRefilling();
  testVain();
  testTooMany();
  testBest();
  return test::result();
}
