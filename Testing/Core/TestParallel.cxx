// Support/Parallel: each block runs once, and what one throws reaches the caller, from any thread.

#include "Support/Parallel.h"
#include "TestMemory.h"
#include "TestSupport.h"

#include <atomic>
#include <chrono>
#include <new>
#include <thread>

using namespace remesh;

namespace
{
RunControl controlOf(Schedule schedule)
{
  RunControl control;
  control.schedule = schedule;
  return control;
}

void testEachOnce(Schedule schedule)
{
  std::vector<std::atomic<int>> calls(1000);
  CHECK(forEachBlock(1000, controlOf(schedule), [&](Offset block) { ++calls[block]; }));
  for (const std::atomic<int>& count : calls)
  {
    CHECK_EQUAL(count.load(), 1);
  }
}

void testExceptions(Schedule schedule)
{
  std::atomic<int> calls(0);
  bool caught = false;
  try
  {
    static_cast<void>(forEachBlock(1000, controlOf(schedule),
      [&](Offset block)
      {
        ++calls;
        if (block % 10 == 7)
        {
          throw std::bad_alloc();
        }
      }));
  }
  catch (const std::bad_alloc&)
  {
    caught = true;
  }
  CHECK(caught);
  CHECK(calls.load() < 1000); // no group follows
}

/** Where blocks take long, the control is asked after fewer of them. */
void testLongBlocks()
{
  int questions = 0;
  RunControl control({},
    [&]()
    {
      ++questions;
      return false;
    });
  control.schedule = Schedule::EightThreads;
  const auto wait = [](Offset) { std::this_thread::sleep_for(std::chrono::milliseconds(60)); };
  CHECK(forEachBlock(64, control, wait));
  CHECK(questions >= 4);
}

/** What was lent comes back, and is lent again; without memory, too. */
void testScratchPool()
{
  int made = 0;
  ScratchPool<int> pool([&]() { return std::make_unique<int>(made++); });
  for (int round = 0; round < 3; ++round)
  {
    auto first = pool.borrow();
    auto second = pool.borrow();
    auto third = pool.borrow();
    CHECK(*first != *second && *second != *third && *third != *first);
    test::allocationsLeft = 0;
    first.reset();
    second.reset();
    third.reset();
    test::allocationsLeft = test::noShortage;
    CHECK_EQUAL(made, 3);
  }
  {
    const auto all = { pool.borrow().release(), pool.borrow().release(), pool.borrow().release() };
    test::allocationsLeft = 0;
    bool failed = false;
    try
    {
      pool.borrow();
    }
    catch (const std::bad_alloc&)
    {
      failed = true;
    }
    test::allocationsLeft = test::noShortage;
    CHECK(failed);
    for (int* item : all)
    {
      delete item;
    }
  }
  CHECK(*pool.borrow() >= 3);
}
}

int TestParallel(int, char*[])
{
  for (const Schedule schedule :
    { Schedule::Smp, Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    testEachOnce(schedule);
    testExceptions(schedule);
  }
  testLongBlocks();
  testScratchPool();
  return test::result();
}
