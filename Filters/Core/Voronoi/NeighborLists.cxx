#include "Voronoi/NeighborLists.h"

#include "Embedding/Distance.h"
#include "Support/FloatBounds.h"
#include "Voronoi/NearbySites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace remesh
{
namespace
{
/** Enough for most cells of a relaxed sampling; the rest is extended. */
constexpr Index longestList = 24;
/** Within a radius that is to fill a list: a few more, so that few lists end early. */
constexpr double wantedWithin = 27.0;
/** Fewer found than this, and the nearest are asked for instead. */
constexpr std::size_t minWithin = 16;
/** More found than this are not put in order. */
constexpr std::size_t maxOrdered = 64;
/** Neighbours whose mean distance tells the spacing of the sites around. */
constexpr Index nearNeighbors = 3;
/** A list is worn when it holds the sites within less than so many spacings. */
constexpr double minReach = 1.6;
/** Hardly longer than that when they are built, as beside a crowd of sites, lists do not count. */
constexpr float minSpare = 1.15F;
/** Lists are built anew when this part of the sample's is worn. */
constexpr double maxWorn = 0.02;
/**
 * At least so many sites are the sample: a share of 2 % is found to a fifteenth of itself, and no
 * rank needs many lists for it alone. With up to twice as many sites, all are.
 */
constexpr Index minSample = 8192;
/** Beside one that came from farther away, in mean reaches of lists, walks would go too far. */
constexpr double farthestLeap = 4.0;

constexpr float unlimited = std::numeric_limits<float>::infinity();

std::vector<Index> allOf(const Sites& sites)
{
  std::vector<Index> all(static_cast<std::size_t>(sites.count()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/**
 * Order by rank: no branch to foresee, and several comparisons at once. Equal ones by their ids,
 * whatever the order in which they were found.
 */
void orderByDistance(std::vector<Neighbor>& found)
{
  if (found.size() > maxOrdered)
  {
    std::nth_element(found.begin(), found.begin() + maxOrdered, found.end(),
      [](const Neighbor& a, const Neighbor& b)
      { return a.distance != b.distance ? a.distance < b.distance : a.site < b.site; });
    found.resize(maxOrdered);
  }
  const int count = static_cast<int>(found.size());
  float keys[maxOrdered];
  Index sites[maxOrdered];
  Neighbor ordered[maxOrdered];
  for (int k = 0; k < count; ++k)
  {
    keys[k] = static_cast<float>(found[k].distance);
    sites[k] = found[k].site;
  }
  for (int k = 0; k < count; ++k)
  {
    const float key = keys[k];
    const Index site = sites[k];
    int rank = 0;
    for (int other = 0; other < count; ++other)
    {
      rank += (keys[other] < key) + ((keys[other] == key) & (sites[other] < site));
    }
    ordered[rank] = found[k];
  }
  std::copy_n(ordered, count, found.begin());
}
}

Status NeighborLists::update(const Sites& sites, const RunControl& control)
{
  if (!m_search || m_built.coordinates.size() != sites.coordinates.size())
  {
    return this->build(sites, control);
  }
  m_now = &sites;
  if (Status status = this->measureDisplacements(sites, control.silent()); !status.ok())
  {
    return status;
  }
  if (!this->worn())
  {
    return Status::success();
  }
  if (m_largestDisplacement > farthestLeap * this->meanReach())
  {
    return this->build(sites, control);
  }
  m_usualDisplacement = m_leapers.find(sites, m_displacements);
  if (this->worn()) // by the usual moves alone
  {
    return this->build(sites, control);
  }
  const bool measured = this->forEachList(control.silent(),
    [&](Index site) { m_places[site].leapers = m_leapers.nearestTo(sites, site); });
  if (!measured)
  {
    m_usualDisplacement = m_largestDisplacement;
    return Status::cancelled();
  }
  return this->worn() ? this->build(sites, control) : Status::success();
}

template <class Visit>
bool NeighborLists::forEachList(const RunControl& control, const Visit& visit)
{
  return forEachItem(siteBlocks(*m_sites), control,
    [&](Offset k)
    {
      const auto site = static_cast<Index>(k);
      if (this->isListed(site))
      {
        visit(site);
      }
    });
}

Status NeighborLists::measureDisplacements(const Sites& sites, const RunControl& control)
{
  const bool measured = dispatchDimension(sites.dimension,
    [&](auto dimension)
    {
      return forEachItem(siteBlocks(sites), control,
        [&](Offset k)
        {
          const auto site = static_cast<Index>(k);
          const double squared = squaredDistance<decltype(dimension)::value>(
            sites.site(site), m_built.site(site), sites.dimension);
          m_displacements[k] = aboveRounding * std::sqrt(squared);
        });
    });
  m_largestDisplacement = *std::max_element(m_displacements.begin(), m_displacements.end());
  m_usualDisplacement = m_largestDisplacement;
  m_leapers.clear();
  const bool compared = measured &&
    this->forEachList(control,
      [&](Index site)
      {
        Place& place = m_places[site];
        place.approach = this->approachOf(site, place.count);
        place.leapers = unlimited;
      });
  return compared ? Status::success() : Status::cancelled();
}

double NeighborLists::meanReach() const
{
  double sum = 0.0;
  Offset count = 0;
  for (const Index site : m_sample)
  {
    const Place& place = m_places[site];
    const bool endsEarly = place.count < m_length; // it holds all of a patch
    sum += endsEarly ? 0.0 : static_cast<double>(place.reach);
    count += endsEarly ? 0 : 1;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

bool NeighborLists::worn() const
{
  const auto worn = std::count_if(m_sample.begin(), m_sample.end(),
    [&](Index site)
    {
      double farthest = 0.0;
      return !this->holds(site, m_places[site].needed, farthest);
    });
  return static_cast<double>(worn) > maxWorn * static_cast<double>(m_sample.size());
}

/** Beside the sample. @param known whether there are lists of as many sites. */
std::vector<Index> NeighborLists::othersToList(bool known) const
{
  std::vector<Index> others;
  for (Index site = 0; site < m_built.count(); ++site)
  {
    const bool wanted = !m_onlyAsked || (known && this->isListed(site));
    if (wanted && this->standIn(site) != site)
    {
      others.push_back(site);
    }
  }
  return others;
}

Index NeighborLists::numberOfLists() const
{
  return static_cast<Index>(std::count_if(m_places.begin(), m_places.end(),
    [](const Place& place) { return place.count.load() != unlisted; }));
}

double NeighborLists::radiusAround(double reach, Index count) const
{
  // In two dimensions the number of sites grows with the square of the radius.
  return count > 0 && reach < m_limit
    ? std::min(m_limit, reach * std::sqrt(wantedWithin / (count + 1.0)))
    : 0.0;
}

/** @param count of the site's list. */
double NeighborLists::approachOf(Index site, Index count) const
{
  const std::size_t first = static_cast<std::size_t>(site) * static_cast<std::size_t>(m_length);
  const NeighborList list{ m_ids.get() + first, m_distances.get() + first, count };
  return m_displacements[site] + list.largestOf(m_displacements);
}

/** Returns the number of its entries: when that is in the site's place, others read it. */
Index NeighborLists::makeList(
  Index site, double radius, NearbySites& nearby, std::vector<Neighbor>& found) const
{
  const auto length = static_cast<std::size_t>(m_length);
  Place& place = m_places[site];
  found.clear();
  if (radius > 0.0)
  {
    nearby.within(site, radius, found);
    found.erase(std::remove_if(found.begin(), found.end(),
                  [site](const Neighbor& neighbor) { return neighbor.site == site; }),
      found.end());
  }
  if (found.size() < std::min(minWithin, length))
  {
    m_search->neighbors(site, m_length + 1, m_limit, found);
    radius = found.size() > length ? found.back().distance : m_limit;
  }
  else
  {
    orderByDistance(found);
  }
  place.reach = found.size() > length ? below(found[length].distance) : roundedDown(radius);
  const auto count = static_cast<Index>(std::min(length, found.size()));
  double near = 0.0;
  const std::size_t first = static_cast<std::size_t>(site) * length;
  for (Index k = 0; k < count; ++k)
  {
    m_ids[first + k] = found[k].site;
    m_distances[first + k] = below(found[k].distance); // as floats they were put in order
    near += k < nearNeighbors ? found[k].distance : 0.0;
  }
  const auto needed = static_cast<float>(minReach / nearNeighbors * near);
  place.needed = place.reach < minSpare * needed ? 0.0F : needed;
  place.radius = static_cast<float>(this->radiusAround(place.reach, count));
  return count;
}

template <class Radius>
bool NeighborLists::makeLists(
  const std::vector<Index>& listed, const RunControl& control, const Radius& radius) const
{
  const Blocks blocks = Blocks::cut(static_cast<Offset>(listed.size()), 1024, 4096);
  return forEachRange(blocks, control,
    [&](Offset begin, Offset end)
    {
      NearbySites nearby(*m_search, *m_sites);
      std::vector<Neighbor> found;
      double former = 0.0;
      nearby.forEach(
        listed.data() + begin, listed.data() + end,
        [&](Index site) { return radius(site, former); },
        [&](Index site, double within)
        {
          Place& place = m_places[site];
          place.approach = 0.0;
          place.leapers = unlimited;
          place.count.store(this->makeList(site, within, nearby, found), std::memory_order_release);
          former = place.radius;
        });
    });
}

void NeighborLists::makeAsked(Index site) const
{
  const std::lock_guard<std::mutex> guard(m_locks[static_cast<std::size_t>(site) % numberOfLocks]);
  if (this->isListed(site))
  {
    return; // it came meanwhile
  }
  NearbySites nearby(*m_search, *m_sites);
  std::vector<Neighbor> found;
  nearby.forEach(
    &site, &site + 1, [&](Index) { return this->radiusOfStandIn(site); },
    [&](Index, double within)
    {
      Place& place = m_places[site];
      const Index count = this->makeList(site, within, nearby, found);
      place.approach = this->approachOf(site, count);
      place.leapers = m_leapers.nearestTo(*m_now, site);
      place.count.store(count, std::memory_order_release); // from now on others read it
    });
}

void NeighborLists::begin(const Sites& sites)
{
  const auto n = static_cast<std::size_t>(sites.count());
  m_sites = &sites;
  m_now = &sites;
  m_search.emplace(sites);
  m_length = std::min(longestList, sites.count() - 1);
  if (const std::size_t entries = n * static_cast<std::size_t>(m_length); m_room < entries)
  {
    m_ids.reset(new Index[entries]);
    m_distances.reset(new float[entries]);
    m_room = entries;
  }
  if (m_places.size() != n)
  {
    m_places = std::vector<Place>(n);
  }
  for (Place& place : m_places)
  {
    place.count.store(unlisted, std::memory_order_relaxed);
  }
  m_displacements.assign(n, 0.0);
  m_largestDisplacement = 0.0;
  m_usualDisplacement = 0.0;
  m_leapers.clear();
}

Status NeighborLists::finish(bool done)
{
  if (!done)
  {
    m_search.reset(); // half-filled lists are none
    return Status::cancelled();
  }
  return Status::success();
}

Status NeighborLists::build(const Sites& sites, const RunControl& control)
{
  const bool known = m_search && m_places.size() == static_cast<std::size_t>(sites.count()) &&
    !m_built.coordinates.empty(); // in place there was no sample
  m_built = sites;
  m_stride = std::max(1, sites.count() / minSample);
  const std::vector<Index> others = this->othersToList(known);
  m_sample.clear();
  for (Index site = 0; site < sites.count(); site += m_stride)
  {
    m_sample.push_back(site);
  }
  this->begin(m_built);
  // Its own last list, or that of a site before, which is near as a rule, tells how far to look.
  const bool done =
    this->makeLists(m_sample, control.step(0, 2),
      [&](Index site, double former) { return known ? m_places[site].radius : former; }) &&
    this->makeLists(
      others, control.step(1, 2), [&](Index site, double) { return this->radiusOfStandIn(site); });
  return this->finish(done);
}

Status NeighborLists::buildInPlace(
  const Sites& sites, const RunControl& control, const std::vector<Index>* some)
{
  m_built = Sites{};
  m_stride = 0;
  const std::vector<Index> listed = some ? *some : allOf(sites);
  this->begin(sites);
  return this->finish(
    this->makeLists(listed, control, [](Index, double former) { return former; }));
}
}
