/**
 * @file Grouping.h
 * @brief Parallel count, scan and fill: kept items packed together, items grouped by their key.
 *
 * All results are those of the plain serial loop, whatever the threads: items keep their order.
 */
#ifndef remesh_Grouping_h
#define remesh_Grouping_h

#include "Support/Parallel.h"

#include <algorithm>
#include <atomic>
#include <utility>
#include <vector>

namespace remesh
{
/** A cut of [0, count) for loops of little work per item: few blocks, none of them short. */
inline Blocks longBlocks(Offset count)
{
  constexpr Offset shortest = Offset(1) << 13;
  return Blocks::cut(
    count, std::clamp<Offset>(count / shortest, 1, 64), std::max<Offset>(count, 1));
}

/** Turns counts into the sums of those before them; returns the sum of all. */
template <class Integer>
Integer scanCounts(std::vector<Integer>& counts)
{
  Integer sum = 0;
  for (Integer& count : counts)
  {
    sum += std::exchange(count, sum);
  }
  return sum;
}

/**
 * Counts of `keys` keys in each block, block by block, become the places where the keys of the
 * block begin when all items are ordered by key, then by block. Returns `keys` + 1: where each key
 * begins.
 */
std::vector<Offset> scanAcrossBlocks(std::vector<Offset>& counts, std::size_t keys);

/** Calls `body(item)` for each item of [0, count), in parallel. False when cancelled. */
template <class Body>
[[nodiscard]] bool forEachItem(Offset count, const RunControl& control, const Body& body)
{
  return forEachItem(longBlocks(count), control, body);
}

/** How many items of [0, count) fulfil `holds(item)`; -1 when cancelled. */
template <class Predicate>
Offset countItems(Offset count, const RunControl& control, const Predicate& holds)
{
  const Blocks blocks = longBlocks(count);
  std::vector<Offset> counts(static_cast<std::size_t>(blocks.count()), 0);
  const bool done = forEachBlock(blocks.count(), control,
    [&](Offset block)
    {
      Offset found = 0;
      for (Offset item = blocks.begin(block); item < blocks.end(block); ++item)
      {
        found += holds(item) ? 1 : 0;
      }
      counts[block] = found;
    });
  return done ? scanCounts(counts) : -1;
}

/**
 * Numbers the items of [0, count) for which `keep(item)` holds, in their order.
 *
 * @param keep is asked twice for each item, and by several threads.
 * @param allocate is called once with the number of kept items, before any `place`.
 * @param place is called with (item, number) for each kept item, in parallel.
 * @return false when cancelled.
 */
template <class Keep, class Allocate, class Place>
[[nodiscard]] bool packItems(Offset count, const RunControl& control, const Keep& keep,
  const Allocate& allocate, const Place& place)
{
  const Blocks blocks = longBlocks(count);
  std::vector<Offset> numbers(static_cast<std::size_t>(blocks.count()), 0);
  if (!forEachBlock(blocks.count(), control.silent(),
        [&](Offset block)
        {
          Offset kept = 0;
          for (Offset item = blocks.begin(block); item < blocks.end(block); ++item)
          {
            kept += keep(item) ? 1 : 0;
          }
          numbers[block] = kept;
        }))
  {
    return false;
  }
  allocate(scanCounts(numbers));
  return forEachBlock(blocks.count(), control,
    [&](Offset block)
    {
      Offset number = numbers[block];
      for (Offset item = blocks.begin(block); item < blocks.end(block); ++item)
      {
        if (keep(item))
        {
          place(item, number++);
        }
      }
    });
}

/** For each key the lowest item that names it; threads may lower it at the same time. */
class LowestItems
{
public:
  explicit LowestItems(std::size_t numberOfKeys)
    : m_items(numberOfKeys)
  {
    for (std::atomic<Offset>& item : m_items)
    {
      item.store(none, std::memory_order_relaxed);
    }
  }

  void add(std::size_t key, Offset item)
  {
    Offset lowest = m_items[key].load(std::memory_order_relaxed);
    while (
      item < lowest && !m_items[key].compare_exchange_weak(lowest, item, std::memory_order_relaxed))
    {
    }
  }

  bool has(std::size_t key) const { return (*this)[key] != none; }
  Offset operator[](std::size_t key) const { return m_items[key].load(std::memory_order_relaxed); }

private:
  static constexpr Offset none = std::numeric_limits<Offset>::max();
  std::vector<std::atomic<Offset>> m_items;
};

/** Items of each key, ascending. */
struct Groups
{
  std::vector<Offset> begins; ///< keys + 1, into `items`
  std::vector<Index> items;
};

/**
 * Step 3 of `groupByKey` for the items from `begin` on, which have the keys from `firstKey` on.
 *
 * @param keys of these items, one by one; they are put in the order of their keys.
 */
void groupRange(
  Offset begin, const std::vector<Index>& keys, Offset firstKey, Offset endKey, Groups& groups);

/**
 * Groups the items [0, count) by `keyOf(item)`.
 *
 * 1. Move the items, in blocks, to the order of the high bits of their keys.
 * 2. For each value of the high bits, look up the keys of its items again.
 * 3. Count and scan them, and fill in the items.
 *
 * @param count <= maximumIndex.
 * @param keyOf gives a key of [0, numberOfKeys), or noIndex for an item to leave out. It is asked
 *        three times for each item, and by several threads.
 * @return false when cancelled.
 * Cost: O(count + numberOfKeys), in parallel; 12 bytes for each item of a bucket,
 * of which there are a thousand if there are as many keys, on each thread.
 */
template <class KeyOf>
[[nodiscard]] bool groupByKey(
  Offset count, Index numberOfKeys, const RunControl& control, const KeyOf& keyOf, Groups& groups)
{
  constexpr Index maxCoarse = 1024;
  int lowBits = 0;
  while (numberOfKeys >> lowBits > maxCoarse)
  {
    ++lowBits;
  }
  const auto coarse = static_cast<std::size_t>(numberOfKeys >> lowBits) + 1;
  const Blocks blocks = longBlocks(count);
  std::vector<Offset> places(coarse * static_cast<std::size_t>(blocks.count()), 0);
  const auto forEachKey = [&](Offset block, const auto& visit)
  {
    Offset* blockPlaces = places.data() + static_cast<std::size_t>(block) * coarse;
    for (Offset item = blocks.begin(block); item < blocks.end(block); ++item)
    {
      if (const Index key = keyOf(item); key != noIndex)
      {
        visit(blockPlaces[key >> lowBits], key, static_cast<Index>(item));
      }
    }
  };
  if (!forEachBlock(blocks.count(), control.silent(),
        [&](Offset block) { forEachKey(block, [](Offset& place, Index, Index) { ++place; }); }))
  {
    return false;
  }
  const std::vector<Offset> coarseBegins = scanAcrossBlocks(places, coarse);
  groups.items.resize(static_cast<std::size_t>(coarseBegins.back()));
  groups.begins.resize(static_cast<std::size_t>(numberOfKeys) + 1);
  groups.begins.back() = coarseBegins.back();
  return forEachBlock(blocks.count(), control.silent(),
           [&](Offset block) {
             forEachKey(
               block, [&](Offset& place, Index, Index item) { groups.items[place++] = item; });
           }) &&
    forEachBlock(static_cast<Offset>(coarse), control,
      [&](Offset high)
      {
        const Offset begin = coarseBegins[high];
        std::vector<Index> keys(static_cast<std::size_t>(coarseBegins[high + 1] - begin));
        std::transform(groups.items.begin() + begin, groups.items.begin() + coarseBegins[high + 1],
          keys.begin(), keyOf);
        groupRange(begin, keys, high << lowBits,
          std::min<Offset>(numberOfKeys, (high + 1) << lowBits), groups);
      });
}
}

#endif
