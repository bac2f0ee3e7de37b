#include "Voronoi/NeighborLists.h"

#include "Embedding/Distance.h"
#include "Support/FloatBounds.h"
#include "Support/Parallel.h"
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
/** Lists are built anew when this part of them is worn. */
constexpr double maxWorn = 0.02;
/** At most so many sites, and at most one of so many, move by more than the usual. */
constexpr Offset maxLeapers = 32;
constexpr Offset sitesForLeaper = 256;
/** Beside one that came from farther away, in mean reaches of lists, walks would go too far. */
constexpr double farthestLeap = 4.0;

Blocks blocksOf(const Sites& sites)
{
  return Blocks::cut(sites.count(), 1024, 4096);
}

std::vector<Index> allOf(const Sites& sites)
{
  std::vector<Index> all(static_cast<std::size_t>(sites.count()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/** The coordinates of some sites as SiteDistances wants them; far away where a group has none. */
std::vector<double> packGroups(const Sites& sites, const std::vector<Index>& some, int groups)
{
  const auto d = static_cast<std::size_t>(sites.dimension);
  std::vector<double> coordinates(groups * lanes * d, std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < some.size(); ++k)
  {
    for (std::size_t m = 0; m < d; ++m)
    {
      coordinates[(k / lanes * d + m) * lanes + k % lanes] = sites.site(some[k])[m];
    }
  }
  return coordinates;
}

/** Order by rank: no branch to foresee, and several comparisons at once. */
void orderByDistance(std::vector<Neighbor>& found)
{
  if (found.size() > maxOrdered)
  {
    std::nth_element(found.begin(), found.begin() + maxOrdered, found.end(),
      [](const Neighbor& a, const Neighbor& b) { return a.distance < b.distance; });
    found.resize(maxOrdered);
  }
  const int count = static_cast<int>(found.size());
  float keys[maxOrdered];
  Neighbor ordered[maxOrdered];
  for (int k = 0; k < count; ++k)
  {
    keys[k] = static_cast<float>(found[k].distance);
  }
  for (int k = 0; k < count; ++k)
  {
    const float key = keys[k];
    int rank = 0;
    for (int other = 0; other < count; ++other)
    {
      rank += (keys[other] < key) + ((keys[other] == key) & (other < k));
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
  const std::vector<Index> leapers = this->findLeapers();
  if (this->worn()) // by the usual moves alone
  {
    return this->build(sites, control);
  }
  if (!this->measureLeapers(sites, leapers, control.silent()))
  {
    m_usualDisplacement = m_largestDisplacement;
    return Status::cancelled();
  }
  return this->worn() ? this->build(sites, control) : Status::success();
}

Status NeighborLists::measureDisplacements(const Sites& sites, const RunControl& control)
{
  const bool measured = forEachItem(blocksOf(sites), control,
    [&](Offset k)
    {
      const auto site = static_cast<Index>(k);
      m_displacements[k] = aboveRounding *
        std::sqrt(
          squaredDistance<Eigen::Dynamic>(sites.site(site), m_built.site(site), sites.dimension));
    });
  m_largestDisplacement = *std::max_element(m_displacements.begin(), m_displacements.end());
  m_usualDisplacement = m_largestDisplacement;
  std::fill(m_leapers.begin(), m_leapers.end(), std::numeric_limits<float>::infinity());
  const bool compared = measured &&
    forEachItem(blocksOf(sites), control,
      [&](Offset k)
      {
        m_approaches[k] =
          m_displacements[k] + this->list(static_cast<Index>(k)).largestOf(m_displacements);
      });
  return compared ? Status::success() : Status::cancelled();
}

/** The few sites that moved farthest; the usual displacement is that of the others. */
std::vector<Index> NeighborLists::findLeapers()
{
  const auto count = static_cast<Offset>(m_displacements.size());
  std::vector<Index> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  const auto last = order.begin() + std::min(maxLeapers, count / sitesForLeaper);
  std::nth_element(order.begin(), last, order.end(),
    [&](Index a, Index b)
    {
      return m_displacements[a] != m_displacements[b] ? m_displacements[a] > m_displacements[b]
                                                      : a < b;
    });
  m_usualDisplacement = m_displacements[*last];
  order.erase(last, order.end());
  return order;
}

bool NeighborLists::measureLeapers(
  const Sites& sites, const std::vector<Index>& leapers, const RunControl& control)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto groups = static_cast<int>((leapers.size() + lanes - 1) / lanes);
  const std::vector<double> coordinates = packGroups(sites, leapers, groups);
  std::vector<char> isLeaper(static_cast<std::size_t>(sites.count()), 0);
  for (const Index leaper : leapers)
  {
    isLeaper[leaper] = 1;
  }
  const SiteDistanceEvaluation measure = siteDistanceEvaluation(widestInstructionSet());
  return forEachRange(blocksOf(sites), control,
    [&](Offset begin, Offset end)
    {
      std::vector<double> squared(static_cast<std::size_t>(groups * lanes));
      for (Offset k = begin; k < end; ++k)
      {
        measure({ coordinates.data(), groups, sites.dimension, sites.site(static_cast<Index>(k)),
          squared.data() });
        if (isLeaper[k])
        {
          const auto own = std::find(leapers.begin(), leapers.end(), static_cast<Index>(k));
          squared[own - leapers.begin()] = infinity;
        }
        double nearest = infinity;
        for (int group = 0; group < groups; ++group)
        {
          nearest = std::min(nearest, minOfLanes(squared.data() + group * lanes));
        }
        m_leapers[k] = roundedDown(std::sqrt(nearest) / aboveRounding);
      }
    });
}

double NeighborLists::meanReach() const
{
  double sum = 0.0;
  Offset count = 0;
  for (const Place& place : m_places)
  {
    const bool endsEarly = place.count < m_length; // it holds all of a patch
    sum += endsEarly ? 0.0 : static_cast<double>(place.reach);
    count += endsEarly ? 0 : 1;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

bool NeighborLists::worn() const
{
  Offset worn = 0;
  const auto count = static_cast<Offset>(m_places.size());
  for (Offset k = 0; k < count; ++k)
  {
    double farthest = 0.0;
    worn += !this->holds(static_cast<Index>(k), m_places[k].needed, farthest);
  }
  return static_cast<double>(worn) > maxWorn * static_cast<double>(count);
}

double NeighborLists::radiusLike(const Place& like) const
{
  // In two dimensions the number of sites grows with the square of the radius.
  return like.count > 0 && like.reach < m_limit
    ? std::min(m_limit, like.reach * std::sqrt(wantedWithin / (like.count + 1.0)))
    : 0.0;
}

void NeighborLists::buildList(
  Index site, double radius, NearbySites& nearby, std::vector<Neighbor>& found)
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
  place.count = static_cast<Index>(std::min(length, found.size()));
  double near = 0.0;
  const std::size_t first = static_cast<std::size_t>(site) * length;
  for (Index k = 0; k < place.count; ++k)
  {
    m_ids[first + k] = found[k].site;
    m_distances[first + k] = below(found[k].distance); // as floats they were put in order
    near += k < nearNeighbors ? found[k].distance : 0.0;
  }
  const auto needed = static_cast<float>(minReach / nearNeighbors * near);
  place.needed = place.reach < minSpare * needed ? 0.0F : needed;
}

Status NeighborLists::build(const Sites& sites, const RunControl& control)
{
  if (m_built.coordinates.empty())
  {
    m_places.clear(); // some lists may have been left out, and tell nothing
  }
  m_built = sites;
  return this->buildFor(m_built, allOf(sites), control);
}

Status NeighborLists::buildInPlace(
  const Sites& sites, const RunControl& control, const std::vector<Index>* some)
{
  m_built = Sites{};
  m_places.clear(); // they are made anew, and the others are to be empty
  return this->buildFor(sites, some ? *some : allOf(sites), control);
}

void NeighborLists::makeRoom(std::size_t entries)
{
  if (m_room < entries)
  {
    m_ids.reset(new Index[entries]);
    m_distances.reset(new float[entries]);
    m_room = entries;
  }
}

Status NeighborLists::buildFor(
  const Sites& sites, const std::vector<Index>& listed, const RunControl& control)
{
  const Index count = sites.count();
  const auto n = static_cast<std::size_t>(count);
  const bool known = m_search && m_places.size() == n;
  m_search.emplace(sites);
  m_length = std::min(longestList, count - 1);
  this->makeRoom(n * static_cast<std::size_t>(m_length));
  m_places.resize(n);
  m_displacements.assign(n, 0.0);
  m_approaches.assign(n, 0.0);
  m_largestDisplacement = 0.0;
  m_usualDisplacement = 0.0;
  m_leapers.assign(n, std::numeric_limits<float>::infinity());
  const Blocks blocks = Blocks::cut(static_cast<Offset>(listed.size()), 1024, 4096);
  const bool done = forEachRange(blocks, control,
    [&](Offset begin, Offset end)
    {
      NearbySites nearby(*m_search, sites);
      std::vector<Neighbor> found;
      double former = 0.0; // nothing is known yet
      // Its own last list, or that of a site before, which is near as a rule, tells how far to
      // look.
      const auto radius = [&](Index site)
      { return known ? this->radiusLike(m_places[site]) : former; };
      nearby.forEach(listed.data() + begin, listed.data() + end, radius,
        [&](Index site, double within)
        {
          this->buildList(site, within, nearby, found);
          former = this->radiusLike(m_places[site]);
        });
    });
  if (!done)
  {
    m_search.reset(); // half-filled lists are none
    return Status::cancelled();
  }
  return Status::success();
}
}
