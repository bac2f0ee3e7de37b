#include "Delaunay/TopologyRepair.h"

#include "Embedding/CornerReader.h"
#include "Embedding/Distance.h"
#include "Features/SpareSites.h"
#include "Support/SortUnique.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace remesh
{
namespace
{
constexpr int ringsKept = 2; // of triangles around places from which no site is taken

/** Keeps the farthest of the vertices it is shown from their sites, in R^d. */
class FarthestVertex
{
public:
  explicit FarthestVertex(const VertexPlaces& places)
    : m_places(places)
    , m_reader(places.surface)
    , m_point(static_cast<std::size_t>(places.surface.dimension))
    , m_farthest(m_point.size())
  {
  }

  void begin() { m_largest = -1.0; }
  bool found() const { return m_largest >= 0.0; }
  const std::vector<double>& place() const { return m_farthest; }
  /** The piece that was shown with it, and its place there. */
  std::pair<Offset, Offset> vertex() const { return m_vertex; }

  void show(Offset piece, Offset vertex)
  {
    const int d = m_places.surface.dimension;
    const auto corners = m_reader.facet(m_places.diagram.facets[piece]);
    const std::array<double, 3> b = m_places.at(piece, vertex);
    for (int k = 0; k < d; ++k)
    {
      m_point[k] = b[0] * corners[0][k] + b[1] * corners[1][k] + b[2] * corners[2][k];
    }
    const double* site = m_places.sites.site(m_places.diagram.sites[piece]);
    const double squared = squaredDistance<Eigen::Dynamic>(m_point.data(), site, d);
    if (squared > m_largest)
    {
      m_largest = squared;
      m_farthest = m_point;
      m_vertex = { piece, vertex };
    }
  }

private:
  const VertexPlaces& m_places;
  CornerReader<Eigen::Dynamic> m_reader;
  std::vector<double> m_point;
  std::vector<double> m_farthest;
  std::pair<Offset, Offset> m_vertex;
  double m_largest = -1.0;
};

/** The component beyond a side of a piece, or noIndex on an edge of its facet. */
Index componentBeyond(
  const Diagram& diagram, const Components& components, Offset piece, Index across)
{
  return across < 0 ? noIndex : components.ofPiece[diagram.pieceOf(diagram.facets[piece], across)];
}

/** The vertices of a component's pieces whose sides are towards `wanted(before, after)`. */
template <class Wanted>
void showVertices(const Diagram& diagram, const Components& components, Index component,
  FarthestVertex& farthest, const Wanted& wanted)
{
  const auto beyond = [&](Offset piece, Index across)
  { return componentBeyond(diagram, components, piece, across); };
  farthest.begin();
  for (Offset p = components.pieceBegin[component]; p < components.pieceBegin[component + 1]; ++p)
  {
    const Offset piece = components.pieces[p];
    for (Offset v = diagram.vertexBegin[piece]; v < diagram.vertexBegin[piece + 1]; ++v)
    {
      if (wanted(beyond(piece, diagram.acrossIncoming(piece, v)), beyond(piece, diagram.across[v])))
      {
        farthest.show(piece, v);
      }
    }
  }
}

/** Adds a site at the farthest vertex shown, unless there is one. */
bool addSite(const Diagram& diagram, const Components& components, const FarthestVertex& farthest,
  Refinement& refinement)
{
  if (!farthest.found())
  {
    return false;
  }
  const auto [piece, vertex] = farthest.vertex();
  Triple meeting{ components.ofPiece[piece],
    componentBeyond(diagram, components, piece, diagram.across[vertex]),
    componentBeyond(diagram, components, piece, diagram.acrossIncoming(piece, vertex)) };
  std::sort(meeting.begin(), meeting.end());
  const bool isNew = refinement.meetings.insert(meeting).second;
  if (isNew)
  {
    refinement.added.insert(
      refinement.added.end(), farthest.place().begin(), farthest.place().end());
  }
  return isNew;
}

std::vector<Index> countUses(const Dual& dual, Index numberOfVertices)
{
  std::vector<Index> uses(static_cast<std::size_t>(numberOfVertices), 0);
  for (const Triple& triangle : dual.triangles)
  {
    for (const Index vertex : triangle)
    {
      ++uses[vertex];
    }
  }
  return uses;
}
}

Refinement refineTopology(const VertexPlaces& places, const Components& components,
  const Dual& dual, const Certificate& certificate, bool cutTips)
{
  Refinement refinement;
  std::vector<char> taken(static_cast<std::size_t>(components.count()), 0);
  FarthestVertex farthest(places);
  const auto refine = [&](Index component, Index neighbor)
  {
    showVertices(places.diagram, components, component, farthest,
      [&](Index before, Index after)
      { return neighbor == noIndex || before == neighbor || after == neighbor; });
    addSite(places.diagram, components, farthest, refinement);
  };
  const std::vector<Index> uses = countUses(dual, components.count());
  const auto lessUsed = [&](Index a, Index b) { return uses[b] < uses[a] ? b : a; };
  // A cell of a repeated triangle and no other has two neighbours, one of none has one.
  const auto isTip = [&](Index component, Index mostUses)
  {
    return cutTips && uses[component] <= mostUses &&
      components.sites[component] >= places.sites.fixed;
  };
  for (const auto& [a, b, c] : certificate.vertices)
  {
    if (!taken[a] && !taken[b] && !taken[c])
    {
      taken[a] = taken[b] = taken[c] = 1;
      const Index least = lessUsed(lessUsed(a, b), c);
      if (isTip(least, 1))
      {
        refinement.removed.push_back(components.sites[least]);
      }
      else
      {
        refine(least, noIndex);
      }
    }
  }
  for (const Index cell : certificate.cells)
  {
    if (!taken[cell])
    {
      taken[cell] = 1;
      if (isTip(cell, 0))
      {
        refinement.removed.push_back(components.sites[cell]);
      }
      else
      {
        refine(cell, noIndex);
      }
    }
  }
  for (const auto& [a, b] : certificate.edges)
  {
    if (!taken[a] && !taken[b])
    {
      taken[a] = taken[b] = 1;
      refine(a, b);
    }
  }
  sortUnique(refinement.removed);
  return refinement;
}

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

Refinement refineTriangles(const VertexPlaces& places, const Components& components,
  const Dual& dual, const std::vector<Index>& triangles)
{
  Refinement refinement;
  std::vector<char> taken(static_cast<std::size_t>(components.count()), 0);
  FarthestVertex farthest(places);
  for (const Index t : triangles)
  {
    const auto& [a, b, c] = dual.triangles[t];
    if (taken[a] || taken[b] || taken[c])
    {
      continue;
    }
    showVertices(places.diagram, components, a, farthest,
      [b = b, c = c](Index before, Index after)
      { return (after == b && before == c) || (after == c && before == b); });
    if (addSite(places.diagram, components, farthest, refinement))
    {
      taken[a] = taken[b] = taken[c] = 1;
    }
  }
  return refinement;
}

namespace
{
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
std::vector<Index> takeApart(const std::vector<Index>& candidates, const Components& components,
  const Dual& dual, const Sites& sites, std::size_t wanted, SpareSites& spare)
{
  const std::vector<std::vector<Index>> neighbors =
    neighborsOf(candidates, components, dual, sites.count());
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
std::vector<Index> findDonors(const Components& components, const Dual& dual,
  const std::vector<char>& distances, const CellSums& sums, const Sites& sites, std::size_t wanted,
  SpareSites& spare)
{
  constexpr std::size_t choice = 8; // of candidates for each: sites have six neighbours
  const std::vector<char> nearest = distancesOfSites(components, distances, sites.count());
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
  return takeApart(donors, components, dual, sites, wanted, spare);
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

void addWhereEnergyIs(
  const VertexPlaces& places, const Components& components, Offset count, Refinement& refinement)
{
  std::vector<Index> byEnergy(static_cast<std::size_t>(components.count()));
  std::iota(byEnergy.begin(), byEnergy.end(), Index(0));
  std::stable_sort(byEnergy.begin(), byEnergy.end(),
    [&](Index a, Index b) { return components.energy[a] > components.energy[b]; });
  FarthestVertex farthest(places);
  for (std::size_t k = 0; k < byEnergy.size() && count > 0; ++k)
  {
    showVertices(
      places.diagram, components, byEnergy[k], farthest, [](Index, Index) { return true; });
    count -= addSite(places.diagram, components, farthest, refinement) ? 1 : 0;
  }
}

Revision reviseSites(const VertexPlaces& places, const Components& components, const Dual& dual,
  const Certificate& failures, const CellSums& sums, Refinement refinement, Offset wanted,
  Index addedBefore, Sites& sites, bool keepAdded)
{
  auto& added = refinement.added;
  auto& removed = refinement.removed;
  const auto d = static_cast<std::size_t>(sites.dimension);
  SpareSites spare(places.surface, sites);
  sortUnique(removed);
  removed.erase(std::remove_if(removed.begin(), removed.end(),
                  [&](Index site) { return !spare.take(sites.site(site)); }),
    removed.end());
  const Offset surplus = components.count() + static_cast<Offset>(added.size() / d) -
    static_cast<Offset>(removed.size()) - wanted;
  if (surplus < 0)
  {
    addWhereEnergyIs(places, components, -surplus, refinement);
  }
  else if (surplus > 0)
  {
    std::vector<char> distances = distancesToFailures(
      components, dual, failures, sites.count() - (keepAdded ? addedBefore : 0));
    for (Index k = 0; k < components.count(); ++k) // those that go already are no donors
    {
      const bool goes = std::binary_search(removed.begin(), removed.end(), components.sites[k]);
      distances[k] = goes ? 0 : distances[k];
    }
    const std::vector<Index> donors = findDonors(
      components, dual, distances, sums, sites, static_cast<std::size_t>(surplus), spare);
    const std::size_t missing = static_cast<std::size_t>(surplus) - donors.size();
    added.resize(added.size() - std::min(added.size(), missing * d));
    removed.insert(removed.end(), donors.begin(), donors.end());
  }
  const Index firstAdded = sites.count() - addedBefore;
  const auto last = static_cast<Index>(
    std::count_if(removed.begin(), removed.end(), [&](Index site) { return site >= firstAdded; }));
  removeSites(removed, sites);
  sites.coordinates.insert(sites.coordinates.end(), added.begin(), added.end());
  return { static_cast<Index>(added.size() / d), static_cast<Index>(removed.size()), last };
}

std::vector<Index> sitesAroundAdded(
  const Components& components, const Dual& dual, Index numberOfSites, Index addedBefore)
{
  const std::vector<char> nearest = distancesOfSites(components,
    distancesToFailures(components, dual, Certificate(), numberOfSites - addedBefore),
    numberOfSites);
  std::vector<Index> around;
  for (Index i = 0; i < numberOfSites; ++i)
  {
    if (nearest[i] <= ringsKept)
    {
      around.push_back(i);
    }
  }
  return around;
}
}
