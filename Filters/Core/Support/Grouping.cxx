#include "Support/Grouping.h"

namespace remesh
{
std::vector<Offset> scanAcrossBlocks(std::vector<Offset>& counts, std::size_t keys)
{
  std::vector<Offset> begins(keys + 1, 0);
  for (std::size_t k = 0; k < counts.size(); ++k)
  {
    begins[k % keys] += counts[k];
  }
  scanCounts(begins);
  std::vector<Offset> next(begins);
  for (std::size_t k = 0; k < counts.size(); ++k)
  {
    counts[k] = std::exchange(next[k % keys], next[k % keys] + counts[k]);
  }
  return begins;
}

void groupRange(
  Offset begin, const std::vector<Index>& keys, Offset firstKey, Offset endKey, Groups& groups)
{
  std::vector<Offset> next(static_cast<std::size_t>(endKey - firstKey), 0);
  for (const Index key : keys)
  {
    ++next[key - firstKey];
  }
  scanCounts(next);
  for (Offset key = firstKey; key < endKey; ++key)
  {
    groups.begins[key] = next[key - firstKey] += begin;
  }
  const auto first = groups.items.begin() + begin;
  const std::vector<Index> items(first, first + static_cast<Offset>(keys.size()));
  for (std::size_t k = 0; k < keys.size(); ++k)
  {
    groups.items[next[keys[k] - firstKey]++] = items[k];
  }
}
}
