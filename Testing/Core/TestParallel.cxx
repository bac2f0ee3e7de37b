// Support/Parallel: each block runs once, and what one throws reaches the caller, from any thread.

#include "Support/Parallel.h"
#include "TestSupport.h"

#include <atomic>
#include <new>

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
}

int TestParallel(int, char*[])
{
  for (const Schedule schedule :
    { Schedule::Smp, Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    testEachOnce(schedule);
    testExceptions(schedule);
  }
  return test::result();
}
