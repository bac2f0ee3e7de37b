/**
 * @file SiteChanges.cxx
 *
 * 1. Walk through both states side by side, past single sites that are gone, added or moved.
 * 2. Put what is left of both in the order of the coordinates, and pair equal ones.
 */
#include "Voronoi/SiteChanges.h"

#include <algorithm>

namespace remesh
{
namespace
{
/** So many sites in a row may be gone or added for the walk to find its way. */
constexpr Index farthestStep = 4;

/** -1, 0, 1 as the row of one site is before, like or after that of another. */
int compareRows(const Sites& a, Index i, const Sites& b, Index j)
{
  const double* x = a.site(i);
  const double* y = b.site(j);
  const auto [atX, atY] = std::mismatch(x, x + a.dimension, y);
  return atX == x + a.dimension ? 0 : *atX < *atY ? -1 : 1;
}

void sortByRow(const Sites& sites, std::vector<Index>& ids)
{
  std::sort(ids.begin(), ids.end(),
    [&](Index i, Index j)
    {
      const int compared = compareRows(sites, i, sites, j);
      return compared != 0 ? compared < 0 : i < j;
    });
}

/** Step 1. Sites that find no partner, ascending, are put into `before` and `after`. */
void walk(const Sites& earlier, const Sites& later, std::vector<Index>& partners,
  std::vector<Index>& before, std::vector<Index>& after)
{
  const auto same = [&](Index b, Index a)
  { return b < earlier.count() && a < later.count() && compareRows(earlier, b, later, a) == 0; };
  Index b = 0;
  Index a = 0;
  while (b < earlier.count() || a < later.count())
  {
    if (same(b, a))
    {
      partners[b++] = a++;
      continue;
    }
    Index gone = b < earlier.count() ? 1 : 0;
    Index added = a < later.count() ? 1 : 0;
    for (Index step = 1; step <= farthestStep; ++step)
    {
      if (same(b + step, a) || same(b, a + step))
      {
        gone = same(b + step, a) ? step : 0;
        added = gone > 0 ? 0 : step;
        break;
      }
    }
    for (; gone > 0; --gone)
    {
      before.push_back(b++);
    }
    for (; added > 0; --added)
    {
      after.push_back(a++);
    }
  }
}
}

SiteChanges compareSites(const Sites& earlier, const Sites& later)
{
  SiteChanges changes;
  changes.later.assign(static_cast<std::size_t>(earlier.count()), noIndex);
  std::vector<Index> before;
  std::vector<Index> after;
  walk(earlier, later, changes.later, before, after);
  sortByRow(earlier, before);
  sortByRow(later, after);
  const auto addPlace = [&](const double* place)
  { changes.places.insert(changes.places.end(), place, place + earlier.dimension); };
  std::size_t b = 0;
  std::size_t a = 0;
  while (b < before.size() || a < after.size())
  {
    const int compared = b == before.size() ? 1
      : a == after.size()                   ? -1
                                            : compareRows(earlier, before[b], later, after[a]);
    if (compared == 0)
    {
      changes.later[before[b++]] = after[a++];
    }
    else if (compared < 0)
    {
      addPlace(earlier.site(before[b++]));
    }
    else
    {
      addPlace(later.site(after[a]));
      changes.added.push_back(after[a++]);
    }
  }
  std::sort(changes.added.begin(), changes.added.end());
  return changes;
}
}
