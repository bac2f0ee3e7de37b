#include "Support/Parallel.h"

#include "Support/Random.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <numeric>
#include <thread>

namespace remesh
{
namespace
{
/**
 * Blocks between two questions whether to go on: as many as take about this long, so that a run
 * ends soon after it is cancelled, however large its blocks are.
 */
constexpr Offset firstGroup = 32;
constexpr Offset largestGroup = 128;
constexpr std::chrono::milliseconds longestGroup(100);

void runShuffled(Offset begin, Offset end, const std::function<void(Offset)>& body)
{
  std::vector<Offset> order(static_cast<std::size_t>(end - begin));
  std::iota(order.begin(), order.end(), begin);
  for (std::size_t k = order.size(); k > 1; --k)
  {
    const auto other = static_cast<std::size_t>(uniform01(0, k, 0) * static_cast<double>(k));
    std::swap(order[k - 1], order[other]);
  }
  std::for_each(order.begin(), order.end(), body);
}

void runOnEightThreads(Offset begin, Offset end, const std::function<void(Offset)>& body)
{
  std::atomic<Offset> next(begin);
  std::vector<std::thread> threads;
  for (int k = 0; k < 8; ++k)
  {
    threads.emplace_back(
      [&]()
      {
        for (Offset block = next++; block < end; block = next++)
        {
          body(block);
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

void runOn(Schedule schedule, Offset begin, Offset end, const std::function<void(Offset)>& body)
{
  switch (schedule)
  {
    case Schedule::ShuffledBlocks:
      runShuffled(begin, end, body);
      return;
    case Schedule::EightThreads:
      runOnEightThreads(begin, end, body);
      return;
    case Schedule::Smp:
      vtkSMPTools::For(begin, end, 1,
        [&body](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType block = first; block < last; ++block)
          {
            body(block);
          }
        });
      return;
  }
}

/** An exception, as when memory runs out, must not leave a worker's thread: it comes out here. */
void runGroup(Schedule schedule, Offset begin, Offset end, const std::function<void(Offset)>& body)
{
  std::exception_ptr first;
  std::mutex lock;
  std::atomic<bool> failed(false);
  runOn(schedule, begin, end,
    [&](Offset block)
    {
      if (failed)
      {
        return;
      }
      try
      {
        body(block);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> guard(lock);
        first = first ? first : std::current_exception();
        failed = true;
      }
    });
  if (first)
  {
    std::rethrow_exception(first);
  }
}
}

Blocks Blocks::cut(Offset size, Offset wanted, Offset longest)
{
  const Offset length = (size + wanted - 1) / std::max<Offset>(wanted, 1);
  return { size, std::clamp<Offset>(length, 1, longest) };
}

bool forEachBlock(
  Offset numberOfBlocks, const RunControl& control, const std::function<void(Offset)>& body)
{
  Offset size = firstGroup;
  for (Offset begin = 0; begin < numberOfBlocks;)
  {
    if (control.cancelled())
    {
      return false;
    }
    const Offset end = std::min(numberOfBlocks, begin + size);
    const auto start = std::chrono::steady_clock::now();
    runGroup(control.schedule, begin, end, body);
    const bool wasLong = std::chrono::steady_clock::now() - start > longestGroup;
    size = std::clamp(wasLong ? size / 2 : 2 * size, Offset(1), largestGroup);
    control.report(static_cast<double>(end) / static_cast<double>(numberOfBlocks));
    begin = end;
  }
  return !control.cancelled();
}

bool forEachRange(
  const Blocks& blocks, const RunControl& control, const std::function<void(Offset, Offset)>& body)
{
  return forEachBlock(
    blocks.count(), control, [&](Offset block) { body(blocks.begin(block), blocks.end(block)); });
}
}
