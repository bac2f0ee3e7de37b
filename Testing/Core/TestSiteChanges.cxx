// Voronoi/SiteChanges: which sites of one state are in another, and what is new there.

#include "Support/Random.h"
#include "TestEmbeddings.h"
#include "TestSiteEdits.h"
#include "TestSurfaces.h"
#include "Voronoi/SiteChanges.h"

#include <algorithm>

using namespace remesh;

namespace
{
bool sameRow(const Sites& a, Index i, const Sites& b, Index j)
{
  return std::equal(a.site(i), a.site(i) + a.dimension, b.site(j));
}

/** Partners are at the same place, none has two, and what has none is told. */
void checkChanges(const Sites& earlier, const Sites& later)
{
  const SiteChanges changes = compareSites(earlier, later);
  CHECK_EQUAL(changes.later.size(), static_cast<std::size_t>(earlier.count()));
  CHECK(std::is_sorted(changes.added.begin(), changes.added.end()));
  std::vector<int> seen(static_cast<std::size_t>(later.count()), 0);
  std::size_t gone = 0;
  for (Index i = 0; i < earlier.count(); ++i)
  {
    const Index partner = changes.later[i];
    gone += partner == noIndex;
    if (partner != noIndex)
    {
      CHECK(sameRow(earlier, i, later, partner));
      ++seen[partner];
      continue;
    }
    for (const Index added : changes.added)
    {
      CHECK(!sameRow(earlier, i, later, added));
    }
  }
  for (const Index added : changes.added)
  {
    ++seen[added];
  }
  CHECK(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
  CHECK_EQUAL(changes.places.size(), (gone + changes.added.size()) * earlier.dimension);
}

void testSmallChanges()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::icosphere(2)), 6);
  Sites earlier = test::sampled(surface, 50, 1);
  test::append(earlier, 7, 0.0); // two at one place
  CHECK(compareSites(earlier, earlier).places.empty());
  CHECK_EQUAL(compareSites(earlier, earlier).later[7], 7);
  CHECK_EQUAL(compareSites(earlier, earlier).later[50], 50);

  Sites later = earlier;
  test::erase(later, 50);
  test::erase(later, 20);
  test::append(later, 30, 1e-15);
  const SiteChanges changes = compareSites(earlier, later);
  CHECK_EQUAL(changes.later[7], 7);
  CHECK_EQUAL(changes.later[50], noIndex);
  CHECK_EQUAL(changes.later[20], noIndex);
  CHECK_EQUAL(changes.later[49], 48);
  CHECK(changes.added == std::vector<Index>{ 49 });
  CHECK_EQUAL(changes.places.size(), std::size_t(3 * 6));
}

/** Many in a row are gone, come, move or change places; all; none is left. */
void testManyChanges()
{
  const EmbeddedSurface surface = test::embedded(test::meshOf(test::icosphere(2)), 3);
  const Sites earlier = test::sampled(surface, 200, 3);
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    Sites later = earlier;
    for (int k = 0; k < 1 << (seed % 7); ++k)
    {
      test::edit(later, surface, seed, k);
    }
    checkChanges(earlier, later);
    checkChanges(later, earlier);
  }
  Sites later = earlier;
  std::rotate(
    later.coordinates.begin(), later.coordinates.begin() + 3 * 17, later.coordinates.end());
  CHECK(compareSites(earlier, later).places.empty());
  checkChanges(earlier, later);
  checkChanges(earlier, test::sampled(surface, 150, 4));
}
}

int TestSiteChanges(int, char*[])
{
  testSmallChanges();
  testManyChanges();
  return test::result();
}
