/**
 * @file TestSiteEdits.h
 * @brief Changes of a few sites, as repairs make them.
 */
#ifndef remesh_TestSiteEdits_h
#define remesh_TestSiteEdits_h

#include "Support/Random.h"
#include "TestEmbeddings.h"

namespace remesh::test
{
/** Appends a copy of a site, displaced along one axis. */
inline void append(Sites& sites, Index site, double displacement)
{
  const std::vector<double> row(sites.site(site), sites.site(site) + sites.dimension);
  sites.coordinates.insert(sites.coordinates.end(), row.begin(), row.end());
  sites.site(sites.count() - 1)[0] += displacement;
}

inline void erase(Sites& sites, Index site)
{
  const auto first =
    sites.coordinates.begin() + static_cast<std::ptrdiff_t>(site) * sites.dimension;
  sites.coordinates.erase(first, first + sites.dimension);
}

/** One change of any kind, by the numbers; sites at one place are among what comes out. */
inline void edit(Sites& sites, const EmbeddedSurface& surface, std::uint64_t seed, int number)
{
  const auto random = [&](std::uint64_t which)
  { return uniform01(seed, static_cast<std::uint64_t>(number), which); };
  const auto any = [&](std::uint64_t which)
  { return static_cast<Index>(random(which) * sites.count()); };
  const Index site = any(0);
  const auto begin = static_cast<std::ptrdiff_t>(site) * sites.dimension;
  switch (static_cast<int>(6.0 * random(1)))
  {
    case 0: // gone, if there are enough
      if (sites.count() > 4)
      {
        erase(sites, site);
      }
      break;
    case 1: // moved a little
      sites.site(site)[0] += 1e-3 * random(2);
      break;
    case 2: // a new one in the middle of the others
    {
      const Sites one = sampled(surface, 1, seed + 100 * static_cast<std::uint64_t>(number));
      sites.coordinates.insert(
        sites.coordinates.begin() + begin, one.coordinates.begin(), one.coordinates.end());
      break;
    }
    case 3: // moved to another's place
      std::copy_n(sites.site(any(3)), sites.dimension, sites.site(site));
      break;
    case 4: // two change places
      std::swap_ranges(sites.site(site), sites.site(site) + sites.dimension, sites.site(any(4)));
      break;
    default: // another at the same place
      append(sites, site, 0.0);
  }
}
}

#endif
