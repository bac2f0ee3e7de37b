/**
 * @file KeyOrder.cxx
 * @brief Least-significant-digit radix sort of (key, item) pairs.
 *
 * 1. One pass counts all digits of all keys.
 * 2. For each digit, from the lowest: scan its counts to offsets, and move the pairs.
 * 3. Take the items off the pairs.
 */
#include "Support/KeyOrder.h"

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

using Histogram = std::array<std::size_t, radix>;

std::size_t digitOf(std::uint64_t key, int digit)
{
  return static_cast<std::size_t>(key >> (digit * digitBits)) & (radix - 1);
}

std::vector<Histogram> countDigits(const std::vector<std::uint64_t>& keys)
{
  std::vector<Histogram> counts(numberOfDigits, Histogram{});
  for (const std::uint64_t key : keys)
  {
    for (int digit = 0; digit < numberOfDigits; ++digit)
    {
      ++counts[digit][digitOf(key, digit)];
    }
  }
  return counts;
}

void scan(Histogram& counts)
{
  std::size_t total = 0;
  for (std::size_t& count : counts)
  {
    const std::size_t begin = total;
    total += count;
    count = begin;
  }
}
}

std::vector<Index> orderByKey(const std::vector<std::uint64_t>& keys)
{
  const std::size_t size = keys.size();
  std::vector<Index> order(size);
  if (size == 0)
  {
    return order;
  }
  std::vector<KeyedItem> items(size);
  std::vector<KeyedItem> moved(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    items[i] = { keys[i], static_cast<Index>(i) };
  }
  std::vector<Histogram> counts = countDigits(keys);
  for (int digit = 0; digit < numberOfDigits; ++digit)
  {
    Histogram& offsets = counts[digit];
    if (offsets[digitOf(keys[0], digit)] == size)
    {
      continue;
    }
    scan(offsets);
    for (const KeyedItem& item : items)
    {
      moved[offsets[digitOf(item.key, digit)]++] = item;
    }
    items.swap(moved);
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    order[i] = items[i].item;
  }
  return order;
}
}
