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

bool groupWithinCoarse(const std::vector<KeyedIndex>& keyed,
  const std::vector<Offset>& coarseBegins, int lowBits, Index numberOfKeys,
  const RunControl& control, Groups& groups)
{
  groups.begins.resize(static_cast<std::size_t>(numberOfKeys) + 1);
  groups.items.resize(keyed.size());
  groups.begins.back() = static_cast<Offset>(keyed.size());
  return forEachBlock(static_cast<Offset>(coarseBegins.size()) - 1, control,
    [&](Offset coarse)
    {
      const Offset firstKey = coarse << lowBits;
      const Offset endKey = std::min<Offset>(numberOfKeys, (coarse + 1) << lowBits);
      std::vector<Offset> next(static_cast<std::size_t>(endKey - firstKey), 0);
      const Offset begin = coarseBegins[coarse];
      const Offset end = coarseBegins[coarse + 1];
      for (Offset k = begin; k < end; ++k)
      {
        ++next[keyed[k].key - firstKey];
      }
      scanCounts(next);
      for (Offset key = firstKey; key < endKey; ++key)
      {
        groups.begins[key] = next[key - firstKey] += begin;
      }
      for (Offset k = begin; k < end; ++k)
      {
        groups.items[next[keyed[k].key - firstKey]++] = keyed[k].item;
      }
    });
}
}
