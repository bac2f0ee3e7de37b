#include "Features/CurveSeparation.h"

#include "Features/CurveLevel.h"
#include "Voronoi/NeighborSearch.h"

#include <algorithm>
#include <map>
#include <utility>

namespace remesh
{
namespace
{
constexpr int mostRounds = 32;
constexpr double leastSection = 0.02; // of the spacing
constexpr double leastGap = 0.05;     // of a section
constexpr double rounding = 1e-12;    // of squared distances

/** A site that is nearer to a place of a curve than the curve's own. */
struct Intruder
{
  Index curve;
  Index other;   ///< the curve that the site is on; noIndex for a corner
  Station foot;  ///< nearest to the site, of the places it is nearest to
  Station level; ///< as far as the site from a corner that both curves share, or else the foot
  double excess; ///< by how much the site is nearer, the most of all places; of squared distances
};

using Coordinates = Eigen::Map<const Eigen::VectorXd>;

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
    std::size_t station = 0;
    for (const CollarEdge& collar : m_sites.collar)
    {
      station = collar.segment == 0 ? 0 : station;
      for (Offset i = m_featured.features.edges.edgeFacetsBegin[collar.edge];
           i < m_featured.features.edges.edgeFacetsBegin[collar.edge + 1]; ++i)
      {
        this->watchSide(collar, m_featured.features.edges.edgeFacets[i], station);
      }
      station += collar.changes.size();
    }
    return std::move(m_intruders);
  }

private:
  /** One side of an edge, the stretches of its sites one after the other. */
  void watchSide(const CollarEdge& collar, Index facet, std::size_t station)
  {
    const int k = m_featured.features.edges.sideOf(facet, collar.edge);
    const bool forward = m_featured.mesh.facetPoints[facet][k] == collar.start;
    const Triple& corners = m_featured.mesh.facetCorners[facet];
    const Index start = corners[forward ? k : (k + 1) % 3];
    const Index end = corners[forward ? (k + 1) % 3 : k];
    m_start = Coordinates(m_featured.surface.corner(start), m_featured.surface.dimension);
    m_along = Coordinates(m_featured.surface.corner(end), m_featured.surface.dimension) - m_start;
    Index owner = collar.first;
    double begin = 0.0;
    for (const CollarEdge::Change& change : collar.changes)
    {
      this->watchStretch(collar, owner, station++, begin, change.t);
      owner = change.to;
      begin = change.t;
    }
    this->watchStretch(collar, owner, station, begin, 1.0);
  }

  void watchStretch(
    const CollarEdge& collar, Index owner, std::size_t station, double begin, double end)
  {
    const Eigen::VectorXd middle = this->placeAt(0.5 * (begin + end));
    const Eigen::VectorXd site = this->coordinates(nearestCopy(m_sites, owner, middle));
    const double half = 0.5 * (end - begin) * m_along.norm();
    const double radius =
      std::max((this->placeAt(begin) - site).norm(), (this->placeAt(end) - site).norm());
    m_search.within(middle.data(), half + radius, m_near);
    for (const Neighbor& near : m_near)
    {
      const Index point = m_sites.pointOfSite[near.site];
      if (point == owner || this->isNext(collar.curve, station, point))
      {
        continue;
      }
      // The difference of both squared distances is linear along the edge.
      const Eigen::VectorXd other = this->coordinates(near.site);
      const auto excessAt = [&](double t)
      {
        const Eigen::VectorXd place = this->placeAt(t);
        return (place - site).squaredNorm() - (place - other).squaredNorm();
      };
      const double atBegin = excessAt(begin);
      const double atEnd = excessAt(end);
      const double most = std::max(atBegin, atEnd);
      if (most <= rounding * radius * radius)
      {
        continue;
      }
      double first = begin;
      double last = end;
      if (std::min(atBegin, atEnd) < 0.0)
      {
        (atBegin < 0.0 ? first : last) = begin + (end - begin) * atBegin / (atBegin - atEnd);
      }
      const double length2 = m_along.squaredNorm();
      const double foot = length2 > 0.0 ? (other - m_start).dot(m_along) / length2 : begin;
      this->note(collar, near.site, std::min(std::max(foot, first), last), most);
    }
  }

  void note(const CollarEdge& collar, Index site, double t, double excess)
  {
    const Index other = m_sites.points[m_sites.pointOfSite[site]].curve;
    Intruder intruder{ collar.curve, other, { collar.segment, t }, {}, excess };
    const FeatureCurve& curve = m_featured.features.curves[collar.curve];
    if (t >= 1.0 && collar.segment + 1 < static_cast<Index>(curve.edges.size()))
    {
      intruder.foot = { collar.segment + 1, 0.0 };
    }
    intruder.level =
      levelWith(m_featured, m_sites, site, intruder.curve, intruder.foot, this->placeAt(t));
    m_intruders.push_back(intruder);
  }

  /** Whether a feature point is one of those before and after a station. */
  bool isNext(Index curve, std::size_t station, Index point) const
  {
    const std::vector<Index>& points = m_sites.curvePoints[curve];
    const std::size_t last = points.size() - 1;
    const bool around = !m_featured.features.curves[curve].hasCorners;
    return (station > 0 && points[station - 1] == point) ||
      (station < last && points[station + 1] == point) ||
      (around && station == 0 && points[last - 1] == point) ||
      (around && station == last && points[1] == point);
  }

  Coordinates coordinates(Index site) const
  {
    return Coordinates(m_sites.sites.site(site), m_featured.surface.dimension);
  }

  Eigen::VectorXd placeAt(double t) const { return m_start + t * m_along; }

  FeaturedSurface m_featured;
  const FeatureSites& m_sites;
  NeighborSearch m_search;
  Eigen::VectorXd m_start; ///< of the edge on the side that is watched
  Eigen::VectorXd m_along;
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
  Division(
    const FeaturedSurface& featured, std::vector<char> curves, Offset mostPoints, double spacing)
    : m_lengths(featured)
    , m_curves(std::move(curves))
    , m_mostPoints(mostPoints)
    , m_leastSection(leastSection * spacing)
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
    return insertStation(lengths, intruder.level, m_leastSection, leastGap, places) ||
      insertStation(lengths, intruder.foot, m_leastSection, leastGap, places);
  }

  CurveLengths m_lengths;
  std::vector<char> m_curves;
  Offset m_mostPoints;
  double m_leastSection;
  bool m_isFull = false;
};
}

Index separateCurves(const FeaturedSurface& featured, std::vector<char> curves, Offset mostPoints,
  double spacing, const RunControl& control, FeatureSites& sites)
{
  const FeatureSiteMaker maker(featured);
  const Stations before = sites.stations;
  Stations stations = before;
  const Index pointsBefore = sites.numberOfPoints();
  Division division(featured, std::move(curves), mostPoints, spacing);
  std::size_t found = 0; // in the first round
  const auto goesOn = [&](int round)
  { return round < mostRounds && !sites.collar.empty() && !control.cancelled(); };
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
