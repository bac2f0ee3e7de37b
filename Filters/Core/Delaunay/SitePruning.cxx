#include "Delaunay/SitePruning.h"

#include "Delaunay/SiteRevision.h"
#include "Delaunay/TopologyRepair.h"
#include "Features/SpareSites.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace remesh
{
namespace
{
constexpr double smallEnergy = 0.1; // of the mean of all cells: sites half as far apart, about
constexpr double leastShare = 0.01; // of the vertices; fewer sites are not worth a diagram
constexpr int mostCorrections = 4;  // of the number of places
constexpr int mostRounds = 32;
constexpr char mostFailures = 2;       // the second one alone
constexpr std::size_t morePlaces = 16; // than sites chosen, where cells of several parts are lost

/** Added sites of one small cell each that may go, those of the least energy first. */
std::vector<Index> findCandidates(const VertexPlaces& places, const Components& components,
  Index firstAdded, const std::vector<char>& failures)
{
  const double sum = std::accumulate(components.energy.begin(), components.energy.end(), 0.0);
  const double most = smallEnergy * sum / std::max<Index>(components.count(), 1);
  std::vector<Index> small; // components
  for (Index k = 0; k < components.count(); ++k)
  {
    const Index site = components.sites[k];
    const bool isOnlyPart = (k == 0 || components.sites[k - 1] != site) &&
      (k + 1 == components.count() || components.sites[k + 1] != site);
    if (site >= firstAdded && site >= places.sites.fixed &&
      failures[site - firstAdded] < mostFailures && isOnlyPart && components.energy[k] < most)
    {
      small.push_back(k);
    }
  }
  std::stable_sort(small.begin(), small.end(),
    [&](Index a, Index b) { return components.energy[a] < components.energy[b]; });
  for (Index& k : small)
  {
    k = components.sites[k];
  }
  return small;
}

/**
 * Candidates to try together, in their order: no neighbours of each other, and two rings apart from
 * others where one has failed before, so that it is known which one fails.
 */
std::vector<std::size_t> takeApart(const std::vector<Index>& candidates,
  const std::vector<std::vector<Index>>& neighbors, Index firstAdded,
  const std::vector<char>& failures, const VertexPlaces& places)
{
  SpareSites spare(places.surface, places.sites);
  const auto numberOfSites = static_cast<std::size_t>(places.sites.count());
  std::vector<char> isNext(numberOfSites, 0); // to one taken, or taken
  std::vector<char> isNextToFailed(numberOfSites, 0);
  std::vector<std::size_t> taken;
  for (std::size_t k = 0; k < candidates.size(); ++k)
  {
    const Index site = candidates[k];
    const bool failed = failures[site - firstAdded] > 0;
    const std::vector<char>& apart = failed ? isNext : isNextToFailed;
    const bool waits = isNext[site] ||
      std::any_of(neighbors[k].begin(), neighbors[k].end(), [&](Index n) { return apart[n] != 0; });
    if (!waits && spare.take(places.sites.site(site)))
    {
      taken.push_back(k);
      const auto mark = [&](Index near)
      {
        isNext[near] = 1;
        isNextToFailed[near] = failed || isNextToFailed[near];
      };
      mark(site);
      std::for_each(neighbors[k].begin(), neighbors[k].end(), mark);
    }
  }
  return taken;
}
}

bool SitePruning::choose(
  const VertexPlaces& places, const Components& components, const Dual& dual, PruningBase base)
{
  m_base = std::move(base);
  m_base.added = std::min(m_base.added, m_base.sites->count() - m_base.sites->fixed);
  m_failures.resize(static_cast<std::size_t>(m_base.added), 0);
  m_correction = 0;
  m_corrections = 0;
  const std::vector<Index> candidates =
    findCandidates(places, components, this->firstAdded(), m_failures);
  if (m_rounds >= mostRounds ||
    static_cast<double>(candidates.size()) < leastShare * static_cast<double>(m_base.vertices))
  {
    m_base = {};
    return false;
  }
  std::vector<std::vector<Index>> neighbors =
    neighborsOf(candidates, components, dual, places.sites.count());
  for (const std::size_t k :
    takeApart(candidates, neighbors, this->firstAdded(), m_failures, places))
  {
    m_batch.push_back(candidates[k]);
    m_neighbors.push_back(std::move(neighbors[k]));
  }
  Refinement refinement;
  addWhereEnergyIs(
    places, components, static_cast<Offset>(m_batch.size() + morePlaces), refinement);
  m_places = std::move(refinement.added);
  m_rounds += this->isTrying() ? 1 : 0;
  return this->isTrying();
}

Offset SitePruning::extraPoints() const
{
  return std::max(m_base.extraPoints - static_cast<Offset>(m_batch.size()), Offset(0));
}

Offset SitePruning::wanted() const
{
  return m_base.wanted - m_base.extraPoints + this->extraPoints();
}

Offset SitePruning::numberOfPlaces() const
{
  const Offset left = m_base.vertices - static_cast<Offset>(m_batch.size());
  const auto most = static_cast<Offset>(m_places.size()) / m_base.sites->dimension;
  return this->isTrying() ? std::clamp(this->wanted() - left - m_correction, Offset(0), most) : 0;
}

std::vector<Index> SitePruning::addedThatStay() const
{
  std::vector<char> goes(m_failures.size(), 0);
  for (const Index site : m_batch)
  {
    goes[site - this->firstAdded()] = 1;
  }
  std::vector<Index> stay;
  for (Index k = 0; k < m_base.added; ++k)
  {
    if (!goes[k])
    {
      stay.push_back(this->firstAdded() + k);
    }
  }
  return stay;
}

SitePruning::Trial SitePruning::next() const
{
  const Sites& from = *m_base.sites;
  const auto end = [&](const std::vector<double>& rows, Offset count)
  { return rows.begin() + static_cast<std::ptrdiff_t>(count * from.dimension); };
  const std::vector<Index> stay = this->addedThatStay();
  Trial trial{ { from.dimension, from.fixed, {} }, static_cast<Index>(stay.size()),
    this->extraPoints() };
  std::vector<double>& rows = trial.sites.coordinates;
  rows.assign(from.coordinates.begin(), end(from.coordinates, this->firstAdded()));
  rows.insert(rows.end(), m_places.begin(), end(m_places, this->numberOfPlaces()));
  for (const Index site : stay)
  {
    rows.insert(rows.end(), from.site(site), from.site(site) + from.dimension);
  }
  return trial;
}

bool SitePruning::blamePlaces(const std::vector<Index>& failing, Offset placed)
{
  const auto d = static_cast<Offset>(m_base.sites->dimension);
  const auto first = failing.begin();
  std::vector<double> good;
  bool isFound = false;
  for (Offset k = 0; k * d < static_cast<Offset>(m_places.size()); ++k)
  {
    const Offset site = this->firstAdded() + k;
    const bool isBad = k < placed && std::binary_search(first, failing.end(), site);
    isFound = isFound || isBad;
    if (!isBad)
    {
      good.insert(good.end(), m_places.begin() + k * d, m_places.begin() + (k + 1) * d);
    }
  }
  m_places = std::move(good);
  return isFound;
}

bool SitePruning::blameSites(const std::vector<Index>& failing, Offset placed)
{
  const std::vector<Index> stay = this->addedThatStay();
  const Offset firstOfThese = this->firstAdded() + placed; // in the trial
  std::vector<char> fails(static_cast<std::size_t>(m_base.sites->count()), 0);
  for (const Index site : failing)
  {
    if (site < this->firstAdded())
    {
      fails[site] = 1;
    }
    else if (site >= firstOfThese)
    {
      fails[stay[site - firstOfThese]] = 1;
    }
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < m_batch.size(); ++k)
  {
    if (std::any_of(m_neighbors[k].begin(), m_neighbors[k].end(),
          [&](Index neighbor) { return fails[neighbor] != 0; }))
    {
      ++m_failures[m_batch[k] - this->firstAdded()];
      continue;
    }
    m_batch[kept] = m_batch[k];
    std::swap(m_neighbors[kept], m_neighbors[k]);
    ++kept;
  }
  const bool isFound = kept < m_batch.size();
  m_batch.resize(kept);
  m_neighbors.resize(kept);
  return isFound;
}

bool SitePruning::correct(Offset surplus)
{
  const Offset before = this->numberOfPlaces();
  if (surplus > 0) // others may be tried instead, next time
  {
    const auto d = static_cast<Offset>(m_base.sites->dimension);
    const Offset kept = std::max(before - surplus, Offset(0));
    m_places.erase(m_places.begin() + kept * d, m_places.begin() + before * d);
  }
  m_correction += surplus;
  ++m_corrections;
  return this->numberOfPlaces() != before && m_corrections <= mostCorrections;
}

void SitePruning::giveUp()
{
  for (const Index site : m_batch)
  {
    ++m_failures[site - this->firstAdded()];
  }
  m_batch.clear();
  m_neighbors.clear();
}

bool SitePruning::judge(bool holds, const std::vector<Index>& failing, Offset vertices)
{
  ++m_rounds;
  const Offset surplus = vertices - this->wanted();
  const bool isNearer = std::abs(surplus) < std::abs(m_base.vertices - m_base.wanted);
  if (holds && failing.empty() && (surplus == 0 || isNearer))
  {
    std::vector<char> failures;
    for (const Index site : this->addedThatStay())
    {
      failures.push_back(m_failures[site - this->firstAdded()]);
    }
    m_failures = std::move(failures);
    m_batch.clear();
    m_neighbors.clear();
    m_base = {};
    return true;
  }
  bool goesOn = false;
  if (!failing.empty())
  {
    const Offset placed = this->numberOfPlaces();
    const bool places = this->blamePlaces(failing, placed);
    goesOn = this->blameSites(failing, placed) || places;
  }
  else if (holds)
  {
    goesOn = this->correct(surplus);
  }
  if (!goesOn || m_rounds >= mostRounds)
  {
    this->giveUp();
  }
  return false;
}
}
