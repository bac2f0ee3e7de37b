#include "Repair/ReserveRelease.h"

#include "Delaunay/SiteRevision.h"
#include "Features/SpareSites.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace remesh
{
namespace
{
constexpr double smallEnergy = 0.1;  // of the mean of all cells: sites half as far apart, about
constexpr double minShare = 0.01;    // of the vertices; fewer sites are not worth a diagram
constexpr int maxFailuresOfSite = 2; // the second one alone
constexpr Offset morePlaces = 16;    // than sites chosen, where cells of several parts are lost

std::vector<double> rowOf(const Sites& sites, Index site)
{
  return { sites.site(site), sites.site(site) + sites.dimension };
}

bool isIn(const std::vector<Index>& ascending, Index value)
{
  return std::binary_search(ascending.begin(), ascending.end(), value);
}
}

bool ReserveRelease::answers(const SiteCandidate& candidate) const
{
  return candidate.task().options.exactNumber && !candidate.othersStay() &&
    !candidate.verdict().isUnproven && candidate.verdict().reserve > 0;
}

bool ReserveRelease::hopes(const SiteCandidate& candidate) const
{
  return !candidate.verdict().isUnproven;
}

int ReserveRelease::failuresOf(const SiteCandidate& candidate, Index site) const
{
  const auto found = m_failures.find(rowOf(candidate.result().sites, site));
  return found == m_failures.end() ? 0 : found->second;
}

/** Added sites of one small cell each that may go, those of the least energy first. */
std::vector<Index> ReserveRelease::findCandidates(const SiteCandidate& candidate) const
{
  const Components& components = candidate.result().components;
  const double sum = std::accumulate(components.energy.begin(), components.energy.end(), 0.0);
  const double small = smallEnergy * sum / std::max<Index>(components.count(), 1);
  std::vector<Index> found; // components
  for (Index k = 0; k < components.count(); ++k)
  {
    const Index site = components.sites[k];
    const bool isOnlyPart = (k == 0 || components.sites[k - 1] != site) &&
      (k + 1 == components.count() || components.sites[k + 1] != site);
    if (site >= m_firstAdded && isOnlyPart && components.energy[k] < small &&
      this->failuresOf(candidate, site) < maxFailuresOfSite)
    {
      found.push_back(k);
    }
  }
  std::stable_sort(found.begin(), found.end(),
    [&](Index a, Index b) { return components.energy[a] < components.energy[b]; });
  for (Index& k : found)
  {
    k = components.sites[k];
  }
  return found;
}

/**
 * Those to try together, in their order: no neighbours of each other, and two rings apart from
 * others where one has failed before, so that it is known which one fails.
 */
void ReserveRelease::choose(const SiteCandidate& candidate, const std::vector<Index>& candidates)
{
  const RemeshResult& result = candidate.result();
  std::vector<std::vector<Index>> neighbors =
    neighborsOf(candidates, result.components, result.dual, result.sites.count());
  SpareSites spare(candidate.task().surface, result.sites);
  const auto numberOfSites = static_cast<std::size_t>(result.sites.count());
  std::vector<char> isNext(numberOfSites, 0); // to one taken, or taken
  std::vector<char> isNextToFailed(numberOfSites, 0);
  m_gone.clear();
  m_neighbors.clear();
  m_rows.clear();
  for (std::size_t k = 0; k < candidates.size(); ++k)
  {
    const Index site = candidates[k];
    const bool failed = this->failuresOf(candidate, site) > 0;
    const std::vector<char>& apart = failed ? isNext : isNextToFailed;
    if ((!m_batch.empty() && m_batch.count(rowOf(result.sites, site)) == 0) || isNext[site] ||
      !spare.has(result.sites.site(site)) ||
      std::any_of(neighbors[k].begin(), neighbors[k].end(), [&](Index n) { return apart[n] != 0; }))
    {
      continue;
    }
    spare.take(result.sites.site(site));
    m_gone.push_back(site);
    m_rows.push_back(rowOf(result.sites, site));
    neighbors[k].push_back(site);
    for (const Index near : neighbors[k])
    {
      isNext[near] = 1;
      isNextToFailed[near] = failed || isNextToFailed[near];
    }
    m_neighbors.push_back(std::move(neighbors[k]));
  }
}

/** Where energy is, the best first. */
std::vector<ReserveRelease::Place> ReserveRelease::findPlaces(const SiteCandidate& candidate) const
{
  Refinement refinement;
  addWhereEnergyIs(candidate.places(), candidate.result().components,
    static_cast<Offset>(m_gone.size() + m_badPlaces.size()) + morePlaces, refinement);
  const auto d = static_cast<std::ptrdiff_t>(candidate.task().surface.dimension);
  std::vector<Place> places;
  for (auto row = refinement.added.begin(); row != refinement.added.end(); row += d)
  {
    if (const Place place(row, row + d); m_badPlaces.count(place) == 0)
    {
      places.push_back(place);
    }
  }
  return places;
}

/** So that the mesh has as many vertices as wanted; extra points are given back first. */
Offset ReserveRelease::numberOfPlaces(const SiteCandidate& candidate) const
{
  const auto gone = static_cast<Offset>(m_gone.size());
  const Offset left = candidate.result().components.count() - gone;
  const Offset given = std::min(candidate.extraPoints(), gone);
  return std::max(candidate.wantedVertices() - given - left, Offset(0));
}

/** The sites without those that go; places come before the other sites that repairs added. */
Sites ReserveRelease::exchanged(const Sites& before)
{
  std::vector<Index> gone = m_gone;
  std::sort(gone.begin(), gone.end());
  m_stayed.clear();
  for (Index site = m_firstAdded; site < before.count(); ++site)
  {
    if (!isIn(gone, site))
    {
      m_stayed.push_back(site);
    }
  }
  Sites sites{ before.dimension, before.fixed,
    { before.site(0), before.site(0) + Offset(m_firstAdded) * before.dimension } };
  for (const Place& place : m_places)
  {
    sites.coordinates.insert(sites.coordinates.end(), place.begin(), place.end());
  }
  for (const Index site : m_stayed)
  {
    sites.coordinates.insert(
      sites.coordinates.end(), before.site(site), before.site(site) + before.dimension);
  }
  return sites;
}

Status ReserveRelease::edit(
  SiteCandidate& candidate, int /*edit*/, const RunControl& control, bool& done)
{
  const Sites& before = candidate.result().sites;
  const Index added = std::min(candidate.added(), before.count() - before.fixed);
  m_firstAdded = before.count() - added;
  const std::vector<Index> candidates = this->findCandidates(candidate);
  done = static_cast<double>(candidates.size()) >=
    minShare * static_cast<double>(candidate.result().components.count());
  if (!done)
  {
    return Status::success();
  }
  if (m_added != added)
  {
    m_batch.clear(); // the sites are others
    m_added = added;
  }
  this->choose(candidate, candidates);
  done = !m_gone.empty();
  if (!done)
  {
    return Status::success();
  }
  m_places = this->findPlaces(candidate);
  const auto most = static_cast<Offset>(m_places.size());
  m_places.resize(static_cast<std::size_t>(std::min(this->numberOfPlaces(candidate), most)));
  Sites sites = this->exchanged(before);
  const Offset given = std::min(candidate.extraPoints(), static_cast<Offset>(m_gone.size()));
  candidate.replaceSites(
    std::move(sites), static_cast<Index>(m_stayed.size()), candidate.extraPoints() - given);
  return control.cancelled() ? Status::cancelled() : Status::success();
}

bool ReserveRelease::learn(const SiteCandidate& candidate)
{
  const std::vector<Index> failing = candidate.failingSites();
  // In the numbers of before; places have none.
  const auto placed = static_cast<Index>(m_places.size());
  std::vector<Index> failed;
  bool isBlamed = false;
  for (const Index site : failing)
  {
    const Index k = site - m_firstAdded;
    if (k >= 0 && k < placed)
    {
      m_badPlaces.insert(m_places[k]);
      isBlamed = true;
      continue;
    }
    failed.push_back(k < 0 ? site : m_stayed[k - placed]);
  }
  std::sort(failed.begin(), failed.end());
  m_batch.clear();
  for (std::size_t k = 0; k < m_gone.size(); ++k)
  {
    if (std::any_of(m_neighbors[k].begin(), m_neighbors[k].end(),
          [&](Index neighbor) { return isIn(failed, neighbor); }))
    {
      ++m_failures[m_rows[k]];
      isBlamed = true;
      continue;
    }
    m_batch.insert(m_rows[k]);
  }
  return isBlamed;
}
}
