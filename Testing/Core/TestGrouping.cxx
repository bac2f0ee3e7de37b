// Support/Grouping, KeyOrder, DisjointSets: what the plain serial loops give, whatever the threads.

#include "Support/DisjointSets.h"
#include "Support/Grouping.h"
#include "Support/KeyOrder.h"
#include "Support/Random.h"
#include "TestChecks.h"

#include <numeric>

using namespace remesh;

namespace
{
constexpr Offset sizes[] = { 0, 1, 5, 8191, 70000 };
constexpr Schedule schedules[] = { Schedule::Smp, Schedule::ShuffledBlocks,
  Schedule::EightThreads };

RunControl controlOf(Schedule schedule)
{
  RunControl control;
  control.schedule = schedule;
  return control;
}

/** A number below `limit` that depends on the item alone. */
Index randomBelow(Index limit, Offset item)
{
  return static_cast<Index>(uniform01(1, static_cast<std::uint64_t>(item), 0) * limit);
}

void testGroups(const RunControl& control)
{
  for (const Offset size : sizes)
  {
    for (const Index keys : { 1, 7, 1024, 1025, 300000 })
    {
      // One in eight is left out.
      const auto keyOf = [&](Offset item)
      { return randomBelow(8, item) == 0 ? noIndex : randomBelow(keys, item + size); };
      std::vector<std::vector<Index>> expected(static_cast<std::size_t>(keys));
      for (Offset item = 0; item < size; ++item)
      {
        if (keyOf(item) != noIndex)
        {
          expected[keyOf(item)].push_back(static_cast<Index>(item));
        }
      }
      Groups groups;
      CHECK(groupByKey(size, keys, control, keyOf, groups));
      CHECK_EQUAL(groups.begins.size(), std::size_t(keys) + 1);
      CHECK_EQUAL(groups.begins.back(), Offset(groups.items.size()));
      bool same = groups.begins.front() == 0;
      for (Index key = 0; key < keys; ++key)
      {
        const auto begin = groups.items.begin() + groups.begins[key];
        const auto end = groups.items.begin() + groups.begins[key + 1];
        same = same && std::vector<Index>(begin, end) == expected[key];
      }
      CHECK(same);
    }
  }
  Groups none;
  CHECK(groupByKey(
    5, 0, control, [](Offset) { return noIndex; }, none));
  CHECK(none.items.empty() && none.begins == std::vector<Offset>{ 0 });
}

void testPacking(const RunControl& control)
{
  for (const Offset size : sizes)
  {
    const auto keep = [](Offset item) { return randomBelow(3, item) == 0; };
    std::vector<Offset> expected;
    for (Offset item = 0; item < size; ++item)
    {
      if (keep(item))
      {
        expected.push_back(item);
      }
    }
    std::vector<Offset> packed;
    CHECK(packItems(
      size, control, keep, [&](Offset count) { packed.resize(static_cast<std::size_t>(count)); },
      [&](Offset item, Offset number) { packed[number] = item; }));
    CHECK(packed == expected);
    CHECK_EQUAL(countItems(size, control, keep), Offset(expected.size()));
  }
}

void testOrder(const RunControl& control)
{
  for (const Offset size : sizes)
  {
    for (const int shift : { 0, 40, 63 }) // keys that differ in all, in few digits, in one bit
    {
      std::vector<std::uint64_t> keys(static_cast<std::size_t>(size));
      for (std::size_t k = 0; k < keys.size(); ++k)
      {
        keys[k] = mixBits(k) >> shift << (shift / 2);
      }
      std::vector<Index> expected(keys.size());
      std::iota(expected.begin(), expected.end(), Index(0));
      std::stable_sort(
        expected.begin(), expected.end(), [&](Index a, Index b) { return keys[a] < keys[b]; });
      CHECK(orderByKey(keys, control) == expected);
    }
  }
}

/** Chains of random length, united in any order: the lowest item stands for each. */
void testSets(const RunControl& control)
{
  constexpr Index size = 60000;
  const auto opensChain = [](Index item) { return item == 0 || randomBelow(50, item) == 0; };
  DisjointSets sets(size);
  LowestItems lowest(size);
  std::vector<Index> chains(size);
  for (Index item = 0, chain = 0; item < size; ++item)
  {
    chain = opensChain(item) ? item : chain;
    chains[item] = chain;
  }
  CHECK(forEachItem(size, control,
    [&](Offset k)
    {
      const auto item = static_cast<Index>(k);
      lowest.add(chains[item], item);
      if (!opensChain(item))
      {
        sets.unite(item - 1, item);
        sets.unite(item, chains[item]);
      }
    }));
  bool same = true;
  for (Index item = 0; item < size; ++item)
  {
    same = same && sets.find(item) == chains[item] &&
      sets.isLowest(item) == (chains[item] == item) && lowest.has(item) == opensChain(item) &&
      lowest[chains[item]] == chains[item];
  }
  CHECK(same);
}

void testCancel()
{
  const RunControl control({}, [] { return true; });
  Groups groups;
  const auto zero = [](Offset) { return Index(0); };
  CHECK(!groupByKey(10, 1, control, zero, groups));
  CHECK(!forEachItem(10, control, [](Offset) { CHECK(false); }));
  CHECK_EQUAL(countItems(10, control, [](Offset) { return true; }), Offset(-1));
  CHECK(!packItems(
    10, control, [](Offset) { return true; }, [](Offset) { CHECK(false); },
    [](Offset, Offset) { CHECK(false); }));
  CHECK_EQUAL(orderByKey({ 3, 1, 2 }, control).size(), std::size_t(3));
}
}

int TestGrouping(int, char*[])
{
  for (const Schedule schedule : schedules)
  {
    const RunControl control = controlOf(schedule);
    testGroups(control);
    testPacking(control);
    testOrder(control);
    testSets(control);
  }
  testCancel();
  return test::result();
}
