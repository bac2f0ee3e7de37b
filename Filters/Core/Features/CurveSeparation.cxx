#include "Features/CurveSeparation.h"

#include "Features/CurveLevel.h"
#include "Features/CurveStretches.h"
#include "Voronoi/NeighborSearch.h"

#include <algorithm>
#include <map>
#include <utility>

namespace remesh
{
namespace
{
constexpr int maxPasses = 32;
constexpr double minSection = 0.02;         // of the spacing
constexpr double minGap = 0.05;             // of a section
constexpr double roundingOfSquares = 1e-12; // of squared distances

/** A site that is nearer to a place of a curve than the curve's own. */
struct Intruder
{
  Index curve;
  Index other;   ///< the curve that the site is on; noIndex for a corner
  Station foot;  ///< nearest to the site, of the places it is nearest to
  Station level; ///< as far as the site from a corner that both curves share, or else the foot
  double excess; ///< by how much the site is nearer, the most of all places; of squared distances
};

/** Finds the intruders of all curves. */
class Watch
{
public:
  Watch(const FeaturedSurface& featured, const FeatureSites& sites)
    : m_featured(featured)
    , m_sites(sites)
    , m_search(sites.sites)
  {
  }

  std::vector<Intruder> find()
  {
    forEachStretch(m_featured, m_sites, [&](const Stretch& stretch) { this->watch(stretch); });
    return std::move(m_intruders);
  }

private:
  void watch(const Stretch& stretch)
  {
    const double begin = stretch.begin;
    const double end = stretch.end;
    const Eigen::VectorXd middle = stretch.placeAt(0.5 * (begin + end));
    const Eigen::VectorXd site =
      coordinatesOf(m_sites, nearestCopy(m_sites, stretch.owner, middle));
    const double half = 0.5 * (end - begin) * stretch.along.norm();
    const double radius =
      std::max((stretch.placeAt(begin) - site).norm(), (stretch.placeAt(end) - site).norm());
    m_search.within(middle.data(), half + radius, m_near);
    for (const Neighbor& near : m_near)
    {
      const Index point = m_sites.pointOfSite[near.site];
      if (point != stretch.owner &&
        !isNextTo(m_featured, m_sites, stretch.collar.curve, stretch.station, point))
      {
        this->compare(stretch, site, near.site, roundingOfSquares * radius * radius);
      }
    }
  }

  /** Notes another site if it is nearer to a place of the stretch than its own, by more than that.
   */
  void compare(const Stretch& stretch, const Eigen::VectorXd& own, Index otherSite, double least)
  {
    const double begin = stretch.begin;
    const double end = stretch.end;
    const Coordinates other = coordinatesOf(m_sites, otherSite);
    // The difference of both squared distances is linear along the edge.
    const auto excessAt = [&](double t)
    {
      const Eigen::VectorXd place = stretch.placeAt(t);
      return (place - own).squaredNorm() - (place - other).squaredNorm();
    };
    const double atBegin = excessAt(begin);
    const double atEnd = excessAt(end);
    const double most = std::max(atBegin, atEnd);
    if (most <= least)
    {
      return;
    }
    double first = begin;
    double last = end;
    if (std::min(atBegin, atEnd) < 0.0)
    {
      (atBegin < 0.0 ? first : last) = begin + (end - begin) * atBegin / (atBegin - atEnd);
    }
    this->note(stretch, otherSite, std::min(std::max(stretch.footOf(other), first), last), most);
  }

  void note(const Stretch& stretch, Index site, double t, double excess)
  {
    const Index curve = stretch.collar.curve;
    const Index other = m_sites.points[m_sites.pointOfSite[site]].curve;
    const Station foot = stretch.stationAt(t, m_featured.features.curves[curve]);
    const Station level = levelWith(m_featured, m_sites, site, { curve, foot, stretch.placeAt(t) });
    m_intruders.push_back({ curve, other, foot, level, excess });
  }

  FeaturedSurface m_featured;
  const FeatureSites& m_sites;
  NeighborSearch m_search;
  std::vector<Neighbor> m_near;
  std::vector<Intruder> m_intruders;
};

/** Of all intruders in one section, the one with the largest excess. */
std::vector<Intruder> worstOfSections(
  const std::vector<Intruder>& intruders, const Stations& stations)
{
  std::map<std::pair<Index, std::ptrdiff_t>, Intruder> worst;
  for (const Intruder& intruder : intruders)
  {
    const std::vector<Station>& places = stations[intruder.curve];
    const auto after = std::upper_bound(places.begin(), places.end(), intruder.foot);
    const auto [entry, isNew] =
      worst.try_emplace({ intruder.curve, after - places.begin() }, intruder);
    if (!isNew && intruder.excess > entry->second.excess)
    {
      entry->second = intruder;
    }
  }
  std::vector<Intruder> result;
  for (const auto& entry : worst)
  {
    result.push_back(entry.second);
  }
  return result;
}

/** Puts places on the curves that are looked after, while there is room. */
class Division
{
public:
  Division(const FeaturedSurface& featured, std::vector<char> curves, const CurveRoom& room)
    : m_lengths(featured)
    , m_curves(std::move(curves))
    , m_mostPoints(room.maxPoints)
    , m_leastSection(minSection * room.spacing)
  {
  }

  /** @param points the features' vertices so far. @return how many are added. */
  Offset addPlaces(const std::vector<Intruder>& intruders, Offset points, Stations& stations)
  {
    Offset added = 0;
    for (const Intruder& intruder : intruders)
    {
      if (this->isFull(points + added))
      {
        break;
      }
      if (this->looksAfter(intruder) && this->addPlace(intruder, stations[intruder.curve]))
      {
        ++added;
        m_curves[intruder.curve] = 1;
      }
    }
    return added;
  }

  /** Whether there was no room, or is none with so many vertices. */
  bool isFull(Offset points)
  {
    m_isFull = m_isFull || points >= m_mostPoints;
    return m_isFull;
  }

private:
  bool looksAfter(const Intruder& intruder) const
  {
    return m_curves[intruder.curve] || (intruder.other != noIndex && m_curves[intruder.other]);
  }

  bool addPlace(const Intruder& intruder, std::vector<Station>& places)
  {
    const std::vector<double>& lengths = m_lengths.of(intruder.curve);
    return insertStation(lengths, intruder.level, m_leastSection, minGap, places) ||
      insertStation(lengths, intruder.foot, m_leastSection, minGap, places);
  }

  CurveLengths m_lengths;
  std::vector<char> m_curves;
  Offset m_mostPoints;
  double m_leastSection;
  bool m_isFull = false;
};
}

Index separateCurves(const FeaturedSurface& featured, std::vector<char> curves,
  const CurveRoom& room, const RunControl& control, FeatureSites& sites)
{
  const FeatureSiteMaker maker(featured);
  const Stations before = sites.stations;
  Stations stations = before;
  const Index pointsBefore = sites.numberOfPoints();
  Division division(featured, std::move(curves), room);
  std::size_t found = 0; // in the first round
  const auto goesOn = [&](int round)
  { return round < maxPasses && !sites.collar.empty() && !control.cancelled(); };
  for (int round = 0; goesOn(round); ++round)
  {
    const std::vector<Intruder> intruders =
      worstOfSections(Watch(featured, sites).find(), stations);
    found = round == 0 ? intruders.size() : found;
    if (division.isFull(sites.numberOfPoints()) && 2 * intruders.size() > found)
    {
      stations = before;
      sites = maker.make(stations);
    }
    if (division.addPlaces(intruders, sites.numberOfPoints(), stations) == 0)
    {
      break;
    }
    sites = maker.make(stations);
  }
  return sites.numberOfPoints() - pointsBefore;
}
}
