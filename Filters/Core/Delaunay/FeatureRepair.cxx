#include "Delaunay/FeatureRepair.h"

#include "Features/CurveSeparation.h"

#include <cmath>
#include <set>

namespace remesh
{
namespace
{
constexpr double leastGap = 0.02; // of a section, between its ends and a new place

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
  const Features& features, const Seams& seams, Offset mostPoints, const RunControl& control,
  Stations& stations, FeatureSites& featureSites, Sites& sites)
{
  std::vector<char> removed(static_cast<std::size_t>(sites.count()), 0);
  std::set<std::pair<Index, Index>> divided;
  std::vector<std::vector<double>> lengths(stations.size());
  Index count = 0;
  for (const Intrusion& intrusion : seams.intrusions)
  {
    const std::pair<Index, Index> section{ intrusion.curve, intrusion.section };
    if (removed[intrusion.site] || divided.count(section) > 0)
    {
      continue;
    }
    std::vector<double>& along = lengths[intrusion.curve];
    if (along.empty())
    {
      along = measureCurve(mesh, surface, features, intrusion.curve);
    }
    if (insertStation(along, intrusion.foot, 0.0, leastGap, stations[intrusion.curve]))
    {
      ++count;
      removed[intrusion.site] = 1;
      divided.insert(section);
    }
  }
  if (count == 0)
  {
    return 0;
  }
  featureSites = makeFeatureSites(mesh, surface, features, stations);
  const double spacing = std::sqrt(surface.siteMeasure / sites.count());
  count +=
    separateCurves(mesh, surface, features, mostPoints, spacing, control, stations, featureSites);
  sites = replaceFixed(featureSites.sites, sites, removed);
  return count;
}
}
