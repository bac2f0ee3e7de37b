#include "Delaunay/FeatureRepair.h"

#include "Features/CurveSeparation.h"

#include <cmath>
#include <set>

namespace remesh
{
namespace
{
constexpr double leastGap = 0.02; // of a section, between its ends and a new place
}

Index refineCurves(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const Features& features, const Seams& seams, const Sites& sites, Offset mostPoints,
  const RunControl& control, Stations& stations, FeatureSites& featureSites,
  std::vector<Index>& joining)
{
  joining.clear();
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
      joining.push_back(intrusion.site);
      divided.insert(section);
    }
  }
  if (count == 0)
  {
    return 0;
  }
  featureSites = makeFeatureSites(mesh, surface, features, stations);
  const double spacing = std::sqrt(surface.siteMeasure / sites.count());
  return count +
    separateCurves(mesh, surface, features, mostPoints, spacing, control, stations, featureSites);
}

void replaceFixed(const FeatureSites& featureSites, Sites& sites)
{
  const auto free = sites.coordinates.begin() +
    static_cast<std::ptrdiff_t>(sites.fixed) * static_cast<std::ptrdiff_t>(sites.dimension);
  Sites replaced = featureSites.sites;
  replaced.coordinates.insert(replaced.coordinates.end(), free, sites.coordinates.end());
  sites = std::move(replaced);
}
}
