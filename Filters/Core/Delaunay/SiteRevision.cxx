#include "Delaunay/SiteRevision.h"

#include "Features/SpareSites.h"
#include "Support/SortUnique.h"

#include <algorithm>
#include <tuple>

namespace remesh
{
std::vector<std::vector<Index>> neighborsOf(const std::vector<Index>& candidates,
  const Components& components, const Dual& dual, Index numberOfSites)
{
  std::vector<Index> numbers(static_cast<std::size_t>(numberOfSites), noIndex);
  for (std::size_t k = 0; k < candidates.size(); ++k)
  {
    numbers[candidates[k]] = static_cast<Index>(k);
  }
  std::vector<std::vector<Index>> neighbors(candidates.size());
  for (const Triple& triangle : dual.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index a = components.sites[triangle[k]];
      const Index b = components.sites[triangle[(k + 1) % 3]];
      for (const auto& [site, neighbor] : { std::pair(a, b), std::pair(b, a) })
      {
        if (numbers[site] != noIndex && site != neighbor)
        {
          neighbors[numbers[site]].push_back(neighbor);
        }
      }
    }
  }
  return neighbors;
}

namespace
{
constexpr int ringsKept = 2; // of triangles around places from which no site is taken

/**
 * For each component, how many triangles it is away from a failure or a site from `firstKept` on;
 * `ringsKept` + 1 for all that are farther.
 */
std::vector<char> distancesToFailures(
  const Components& components, const Dual& dual, const Certificate& certificate, Index firstKept)
{
  const char far = ringsKept + 1;
  std::vector<char> distances(static_cast<std::size_t>(components.count()), far);
  for (Index k = 0; k < components.count(); ++k)
  {
    distances[k] = components.sites[k] >= firstKept ? 0 : far;
  }
  for (const Index cell : certificate.cells)
  {
    distances[cell] = 0;
  }
  for (const auto& [a, b] : certificate.edges)
  {
    distances[a] = distances[b] = 0;
  }
  for (const auto& [a, b, c] : certificate.vertices)
  {
    distances[a] = distances[b] = distances[c] = 0;
  }
  for (char ring = 1; ring <= ringsKept; ++ring)
  {
    for (const Triple& triangle : dual.triangles)
    {
      const auto isNearer = [&](Index k) { return distances[k] < ring; };
      if (std::any_of(triangle.begin(), triangle.end(), isNearer))
      {
        for (const Index k : triangle)
        {
          distances[k] = std::min(distances[k], ring);
        }
      }
    }
  }
  return distances;
}

/** For each site, the least distance of its components. */
std::vector<char> distancesOfSites(
  const Components& components, const std::vector<char>& distances, Index numberOfSites)
{
  std::vector<char> nearest(static_cast<std::size_t>(numberOfSites), ringsKept + 1);
  for (Index k = 0; k < components.count(); ++k)
  {
    nearest[components.sites[k]] = std::min(nearest[components.sites[k]], distances[k]);
  }
  return nearest;
}

/**
 * Takes of these sites, in their order, those that are no neighbours of one taken before, and then
 * others, if there are not enough. Many that go side by side would leave a hole.
 *
 * @param spare by which none of these goes that its patch cannot do without.
 */
std::vector<Index> takeApart(const std::vector<Index>& candidates, const DiagramDual& diagram,
  std::size_t wanted, SpareSites& spare)
{
  const Sites& sites = diagram.places.sites;
  const std::vector<std::vector<Index>> neighbors =
    neighborsOf(candidates, diagram.components, diagram.dual, sites.count());
  std::vector<Index> taken;
  std::vector<char> waits(static_cast<std::size_t>(sites.count()), 0);
  for (std::size_t k = 0; k < candidates.size() && taken.size() < wanted; ++k)
  {
    if (!waits[candidates[k]] && spare.take(sites.site(candidates[k])))
    {
      taken.push_back(candidates[k]);
      for (const Index neighbor : neighbors[k])
      {
        waits[neighbor] = 1;
      }
    }
  }
  for (std::size_t k = 0; k < candidates.size() && taken.size() < wanted; ++k)
  {
    if (waits[candidates[k]] && spare.take(sites.site(candidates[k])))
    {
      taken.push_back(candidates[k]);
    }
  }
  return taken;
}

/**
 * Free sites away from failures, the farther first, then by increasing energy of their cells, and
 * no neighbours of each other if there are enough.
 */
std::vector<Index> findDonors(const DiagramDual& diagram, const CellSums& sums,
  const std::vector<char>& distances, std::size_t wanted, SpareSites& spare)
{
  constexpr std::size_t choice = 8; // of candidates for each: sites have six neighbours
  const Sites& sites = diagram.places.sites;
  const std::vector<char> nearest = distancesOfSites(diagram.components, distances, sites.count());
  std::vector<Index> donors;
  for (Index i = sites.fixed; i < sites.count(); ++i)
  {
    if (nearest[i] > 0 && spare.has(sites.site(i)))
    {
      donors.push_back(i);
    }
  }
  const std::size_t count = std::min(choice * wanted, donors.size());
  const auto key = [&](Index i) { return std::make_tuple(-nearest[i], sums.energy[i], i); };
  std::partial_sort(donors.begin(), donors.begin() + static_cast<std::ptrdiff_t>(count),
    donors.end(), [&](Index a, Index b) { return key(a) < key(b); });
  donors.resize(count);
  return takeApart(donors, diagram, wanted, spare);
}

/** Takes sites away; the others keep their order. */
void removeSites(const std::vector<Index>& removed, Sites& sites)
{
  std::vector<char> goes(static_cast<std::size_t>(sites.count()), 0);
  for (const Index site : removed)
  {
    goes[site] = 1;
  }
  const auto d = static_cast<std::size_t>(sites.dimension);
  std::size_t kept = 0;
  for (Index i = 0; i < sites.count(); ++i)
  {
    if (!goes[i])
    {
      std::copy_n(sites.site(i), d, sites.coordinates.data() + kept * d);
      ++kept;
    }
  }
  sites.coordinates.resize(kept * d);
}

}

Revision reviseSites(const DiagramDual& diagram, const CellSums& sums, Refinement refinement,
  const RevisionGoal& goal, Sites& sites)
{
  const auto& [places, components, dual] = diagram;
  auto& added = refinement.added;
  auto& removed = refinement.removed;
  const auto d = static_cast<std::size_t>(sites.dimension);
  SpareSites spare(places.surface, sites);
  sortUnique(removed);
  removed.erase(std::remove_if(removed.begin(), removed.end(),
                  [&](Index site) { return !spare.take(sites.site(site)); }),
    removed.end());
  const Offset surplus = components.count() + static_cast<Offset>(added.size() / d) -
    static_cast<Offset>(removed.size()) - goal.wanted;
  if (surplus < 0)
  {
    addWhereEnergyIs(places, components, -surplus, refinement);
  }
  else if (surplus > 0)
  {
    std::vector<char> distances = distancesToFailures(
      components, dual, goal.failures, sites.count() - (goal.keepAdded ? goal.addedBefore : 0));
    for (Index k = 0; k < components.count(); ++k) // those that go already are no donors
    {
      const bool goes = std::binary_search(removed.begin(), removed.end(), components.sites[k]);
      distances[k] = goes ? 0 : distances[k];
    }
    const std::vector<Index> donors =
      findDonors(diagram, sums, distances, static_cast<std::size_t>(surplus), spare);
    const std::size_t missing = static_cast<std::size_t>(surplus) - donors.size();
    added.resize(added.size() - std::min(added.size(), missing * d));
    removed.insert(removed.end(), donors.begin(), donors.end());
  }
  const Index firstAdded = sites.count() - goal.addedBefore;
  const auto last = static_cast<Index>(
    std::count_if(removed.begin(), removed.end(), [&](Index site) { return site >= firstAdded; }));
  removeSites(removed, sites);
  sites.coordinates.insert(sites.coordinates.end(), added.begin(), added.end());
  return { static_cast<Index>(added.size() / d), static_cast<Index>(removed.size()), last };
}
}
