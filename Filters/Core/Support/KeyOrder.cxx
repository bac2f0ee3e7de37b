/**
 * @file KeyOrder.cxx
 * @brief Least-significant-digit radix sort of (key, item) pairs, in blocks.
 *
 * Keys in order are left so: facets are, when a tree is made of them. Else:
 *
 * 1. Find the digits in which keys differ.
 * 2. For each of them, from the lowest: count its values in each block, scan the counts value by
 *    value and block by block, and move the pairs.
 * 3. Take the items off the pairs.
 */
#include "Support/KeyOrder.h"

#include "Support/Grouping.h"

#include <algorithm>
#include <numeric>

namespace remesh
{
namespace
{
constexpr int digitBits = 11;
constexpr int numberOfDigits = (64 + digitBits - 1) / digitBits;
constexpr std::size_t radix = std::size_t(1) << digitBits;

struct KeyedItem
{
  std::uint64_t key;
  Index item;
};

std::size_t digitOf(std::uint64_t key, int digit)
{
  return static_cast<std::size_t>(key >> (digit * digitBits)) & (radix - 1);
}

/** Bits in which a key differs from the first. */
std::uint64_t differingBits(const std::vector<std::uint64_t>& keys)
{
  std::uint64_t bits = 0;
  for (const std::uint64_t key : keys)
  {
    bits |= key ^ keys.front();
  }
  return bits;
}

/** One pass of the sort; false when cancelled. */
bool moveByDigit(const std::vector<KeyedItem>& items, int digit, const RunControl& control,
  std::vector<KeyedItem>& moved)
{
  const Blocks blocks = longBlocks(static_cast<Offset>(items.size()));
  std::vector<Offset> places(radix * static_cast<std::size_t>(blocks.count()), 0);
  const auto forEachPlace = [&](Offset block, const auto& visit)
  {
    Offset* blockPlaces = places.data() + static_cast<std::size_t>(block) * radix;
    for (Offset k = blocks.begin(block); k < blocks.end(block); ++k)
    {
      visit(blockPlaces[digitOf(items[k].key, digit)], items[k]);
    }
  };
  if (!forEachBlock(blocks.count(), control,
        [&](Offset block)
        { forEachPlace(block, [](Offset& place, const KeyedItem&) { ++place; }); }))
  {
    return false;
  }
  scanAcrossBlocks(places, radix);
  return forEachBlock(blocks.count(), control,
    [&](Offset block)
    { forEachPlace(block, [&](Offset& place, const KeyedItem& item) { moved[place++] = item; }); });
}
}

std::vector<Index> orderByKey(const std::vector<std::uint64_t>& keys, const RunControl& control)
{
  const RunControl silent = control.silent();
  const auto size = static_cast<Offset>(keys.size());
  std::vector<Index> order(keys.size());
  if (std::is_sorted(keys.begin(), keys.end()))
  {
    std::iota(order.begin(), order.end(), 0);
    return order;
  }
  std::vector<KeyedItem> items(keys.size());
  std::vector<KeyedItem> moved(keys.size());
  bool done = forEachItem(size, silent,
    [&](Offset k) {
      items[k] = { keys[k], static_cast<Index>(k) };
    });
  const std::uint64_t differing = differingBits(keys);
  for (int digit = 0; done && digit < numberOfDigits; ++digit)
  {
    if (digitOf(differing, digit) != 0)
    {
      done = moveByDigit(items, digit, silent, moved);
      items.swap(moved);
    }
  }
  done = done && forEachItem(size, silent, [&](Offset k) { order[k] = items[k].item; });
  return order;
}
}
