#include "Features/CurveAlignment.h"

#include "Features/CurveLevel.h"
#include "Features/CurveStretches.h"
#include "Voronoi/NeighborSearch.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr int maxRounds = 4;
/**
 * Of the places that a curve has for itself. One that gets more has those of several curves
 * opposite it, or of such that come nearer and go: then its own are better, and what is too near is
 * parted.
 */
constexpr double maxGrowth = 1.25;

/** A place of a curve opposite a site of another one. */
struct Opposite
{
  Station place;
  double length;   ///< of the curve, up to the place
  double distance; ///< of place and site, as lengths of the curve count
};

/** Finds them, for each curve. */
class OppositePlaces
{
public:
  OppositePlaces(const FeaturedSurface& featured, const FeatureSites& sites)
    : m_featured(featured)
    , m_sites(sites)
    , m_search(sites.sites)
    , m_lengths(featured)
    , m_found(featured.features.curves.size())
  {
  }

  std::vector<std::vector<Opposite>> find()
  {
    forEachStretch(m_featured, m_sites, [&](const Stretch& stretch) { this->look(stretch); });
    return std::move(m_found);
  }

private:
  void look(const Stretch& stretch)
  {
    const Index curve = stretch.collar.curve;
    const std::vector<double>& lengths = m_lengths.of(curve);
    const double edge =
      lengths[stretch.collar.segment + 1] - lengths[stretch.collar.segment]; // as a density has it
    const double embedded = stretch.along.norm();
    if (!(embedded > 0.0))
    {
      return;
    }
    const double scale = edge / embedded;
    const double half = this->halfSpacing(curve, stretch.station) / scale;
    const Eigen::VectorXd middle = stretch.placeAt(0.5 * (stretch.begin + stretch.end));
    m_search.within(middle.data(), half + 0.5 * (stretch.end - stretch.begin) * embedded, m_near);
    for (const Neighbor& near : m_near)
    {
      const Index point = m_sites.pointOfSite[near.site];
      if (m_sites.points[point].curve < curve && point != stretch.owner &&
        !isNextTo(m_featured, m_sites, curve, stretch.station, point))
      {
        this->note(stretch, near.site, half, scale);
      }
    }
  }

  /** @param scale from lengths in R^d to those of the curve. */
  void note(const Stretch& stretch, Index site, double most, double scale)
  {
    const Index curve = stretch.collar.curve;
    const Coordinates at = coordinatesOf(m_sites, site);
    const double t = stretch.footOf(at);
    if (t < stretch.begin || t > stretch.end)
    {
      return;
    }
    const Eigen::VectorXd place = stretch.placeAt(t);
    const double distance = (place - at).norm();
    if (distance < most)
    {
      const Station foot = stretch.stationAt(t, m_featured.features.curves[curve]);
      const Station level = levelWith(m_featured, m_sites, site, { curve, foot, place });
      m_found[curve].push_back({ level, lengthAt(m_lengths.of(curve), level), scale * distance });
    }
  }

  /** Half of the mean distance between the stations around one, in lengths of the curve. */
  double halfSpacing(Index curve, std::size_t station)
  {
    const std::vector<double>& lengths = m_lengths.of(curve);
    const std::vector<Station>& stations = m_sites.stations[curve];
    const std::size_t before = station > 0 ? station - 1 : station;
    const std::size_t after = std::min(station + 1, stations.size() - 1);
    return 0.5 * (lengthAt(lengths, stations[after]) - lengthAt(lengths, stations[before])) /
      static_cast<double>(after - before);
  }

  FeaturedSurface m_featured;
  const FeatureSites& m_sites;
  NeighborSearch m_search;
  CurveLengths m_lengths;
  std::vector<Neighbor> m_near;
  std::vector<std::vector<Opposite>> m_found;
};

/** In order, and none nearer to another, or to an end, than to its site. */
std::vector<Station> thinnedOut(std::vector<Opposite> found, double length)
{
  std::sort(found.begin(), found.end(),
    [](const Opposite& a, const Opposite& b)
    { return a.length != b.length ? a.length < b.length : a.distance < b.distance; });
  std::vector<Station> places;
  double last = 0.0;
  for (const Opposite& opposite : found)
  {
    const double gap = std::min(opposite.length - last, length - opposite.length);
    if (gap > opposite.distance && gap > 0.0)
    {
      places.push_back(opposite.place);
      last = opposite.length;
    }
  }
  return places;
}
}

void alignCurves(const FeaturedSurface& featured, const RunControl& control, CurveSampler& sampler,
  FeatureSites& sites)
{
  if (sites.sites.count() == 0)
  {
    return; // patches without curves, as the parts of a surface are
  }
  const FeatureSiteMaker maker(featured);
  CurveLengths lengths(featured);
  std::vector<std::size_t> alone; // stations
  for (const std::vector<Station>& stations : sampler.stations())
  {
    alone.push_back(stations.size() + 1);
  }
  for (int round = 0; round < maxRounds && !control.cancelled(); ++round)
  {
    const std::vector<std::vector<Opposite>> found = OppositePlaces(featured, sites).find();
    const Stations before = sampler.stations();
    for (std::size_t c = 0; c < found.size(); ++c)
    {
      const auto curve = static_cast<Index>(c);
      const double most = maxGrowth * static_cast<double>(alone[c]);
      sampler.mark(curve, thinnedOut(found[c], lengths.of(curve).back()));
      if (static_cast<double>(sampler.stations()[c].size()) > most)
      {
        sampler.mark(curve, {});
      }
    }
    if (sampler.stations() == before)
    {
      break;
    }
    sites = maker.make(sampler.stations());
  }
}
}
