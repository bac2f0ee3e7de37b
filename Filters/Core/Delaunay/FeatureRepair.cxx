#include "Delaunay/FeatureRepair.h"

#include <algorithm>
#include <set>

namespace remesh
{
namespace
{
constexpr double leastGap = 0.02; // of a section, between its ends and a new place

/** Puts a place between those of a curve, but not close to one; false if it would be. */
bool insertStation(
  const std::vector<double>& lengths, const Station& station, std::vector<Station>& places)
{
  const auto after = std::upper_bound(places.begin(), places.end(), station);
  if (after == places.begin() || after == places.end())
  {
    return false;
  }
  const double begin = lengthAt(lengths, *(after - 1));
  const double end = lengthAt(lengths, *after);
  const double gap = leastGap * (end - begin);
  const double length = lengthAt(lengths, station);
  if (length < begin + gap || length > end - gap)
  {
    return false;
  }
  places.insert(after, station);
  return true;
}

/** The new fixed sites, then the free ones that stay. */
Sites replaceFixed(const Sites& fixed, const Sites& old, const std::vector<char>& removed)
{
  Sites sites = fixed;
  for (Index i = old.fixed; i < old.count(); ++i)
  {
    if (!removed[i])
    {
      sites.coordinates.insert(sites.coordinates.end(), old.site(i), old.site(i) + old.dimension);
    }
  }
  return sites;
}
}

Index refineCurves(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const Features& features, const Seams& seams, Stations& stations, FeatureSites& featureSites,
  Sites& sites)
{
  std::vector<char> removed(static_cast<std::size_t>(sites.count()), 0);
  std::set<std::pair<Index, Index>> divided; // by free sites
  std::vector<std::vector<double>> lengths(stations.size());
  Index count = 0;
  Index spare = sites.count() - sites.fixed; // each new vertex takes the place of a free one
  for (const Intrusion& intrusion : seams.intrusions)
  {
    const bool isFree = intrusion.site >= sites.fixed;
    const std::pair<Index, Index> section{ intrusion.curve, intrusion.section };
    if (spare == 0 || (isFree && (removed[intrusion.site] || divided.count(section) > 0)))
    {
      continue;
    }
    std::vector<double>& along = lengths[intrusion.curve];
    if (along.empty())
    {
      along = measureCurve(mesh, surface, features, intrusion.curve);
    }
    if (insertStation(along, intrusion.foot, stations[intrusion.curve]))
    {
      ++count;
      --spare;
      if (isFree)
      {
        removed[intrusion.site] = 1;
        divided.insert(section);
      }
    }
  }
  if (count == 0)
  {
    return 0;
  }
  featureSites = makeFeatureSites(mesh, surface, features, stations);
  sites = replaceFixed(featureSites.sites, sites, removed);
  return count;
}
}
