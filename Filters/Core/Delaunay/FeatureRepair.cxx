#include "Delaunay/FeatureRepair.h"

#include "Features/CurveSeparation.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace remesh
{
namespace
{
constexpr double leastGap = 0.02; // of a section, between its ends and a new place

/** The lengths along each curve that is asked for. */
class CurveLengths
{
public:
  CurveLengths(const SurfaceMesh& mesh, const EmbeddedSurface& surface, const Features& features)
    : m_mesh(mesh)
    , m_surface(surface)
    , m_features(features)
    , m_lengths(features.curves.size())
  {
  }

  const std::vector<double>& of(Index curve)
  {
    std::vector<double>& lengths = m_lengths[curve];
    if (lengths.empty())
    {
      lengths = measureCurve(m_mesh, m_surface, m_features, curve);
    }
    return lengths;
  }

private:
  const SurfaceMesh& m_mesh;
  const EmbeddedSurface& m_surface;
  const Features& m_features;
  std::vector<std::vector<double>> m_lengths;
};

/** Section by section, those nearest to its middle first. */
std::vector<Intrusion> inwardFirst(
  const std::vector<Intrusion>& intrusions, const Stations& stations, CurveLengths& lengths)
{
  std::vector<std::tuple<Index, Index, double, std::size_t>> order;
  for (std::size_t k = 0; k < intrusions.size(); ++k)
  {
    const Intrusion& intrusion = intrusions[k];
    const std::vector<double>& along = lengths.of(intrusion.curve);
    const std::vector<Station>& places = stations[intrusion.curve];
    const double middle = 0.5 *
      (lengthAt(along, places[intrusion.section]) + lengthAt(along, places[intrusion.section + 1]));
    order.emplace_back(
      intrusion.curve, intrusion.section, std::abs(lengthAt(along, intrusion.foot) - middle), k);
  }
  std::sort(order.begin(), order.end());
  std::vector<Intrusion> ordered;
  for (const auto& place : order)
  {
    ordered.push_back(intrusions[std::get<std::size_t>(place)]);
  }
  return ordered;
}
}

Index refineCurves(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const Features& features, const std::vector<Intrusion>& intrusions, const Sites& sites,
  Offset mostPoints, const RunControl& control, Stations& stations, FeatureSites& featureSites,
  std::vector<Index>& joining)
{
  joining.clear();
  std::vector<char> removed(static_cast<std::size_t>(sites.count()), 0);
  std::set<std::pair<Index, Index>> divided;
  CurveLengths lengths(mesh, surface, features);
  Index count = 0;
  for (const Intrusion& intrusion : inwardFirst(intrusions, stations, lengths))
  {
    const std::pair<Index, Index> section{ intrusion.curve, intrusion.section };
    if (removed[intrusion.site] || divided.count(section) > 0)
    {
      continue;
    }
    if (insertStation(
          lengths.of(intrusion.curve), intrusion.foot, 0.0, leastGap, stations[intrusion.curve]))
    {
      ++count;
      if (intrusion.site >= sites.fixed)
      {
        removed[intrusion.site] = 1;
        joining.push_back(intrusion.site);
      }
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
