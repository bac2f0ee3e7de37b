#include "Optimization/SiteGrowth.h"

#include "Embedding/Distance.h"
#include "Optimization/SiteOrder.h"
#include "Support/Grouping.h"
#include "Voronoi/NeighborSearch.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>

namespace remesh
{
namespace
{
constexpr double maxDebt = 2.0; // sites that a row of cells may have too many or too few

/** Free sites by patch, in their order. */
std::vector<std::vector<Index>> freeSitesByPatch(
  const Sites& sites, const std::vector<Index>& patches, Index numberOfPatches)
{
  std::vector<std::vector<Index>> free(static_cast<std::size_t>(numberOfPatches));
  for (Index i = sites.fixed; i < sites.count(); ++i)
  {
    free[patches[i]].push_back(i);
  }
  return free;
}

/** The sites that have grown in one patch. */
struct GrownSites
{
  Sites sites;
  std::vector<std::array<Index, 2>> parents; ///< n, the sites each is the middle of; or twice one
};

/** Collects what grows in one patch, cell by cell. */
class PatchGrowth
{
public:
  explicit PatchGrowth(const CoarseCells& cells)
    : m_cells(cells)
  {
  }

  /** The site of a cell that grows, and its middles with all but those that grew before. */
  void addCell(Index site)
  {
    const std::vector<Index>& around = m_cells.neighbors[site];
    m_pairs.push_back({ site, site });
    m_partners.clear();
    std::copy_if(around.begin(), around.end(), std::back_inserter(m_partners),
      [&](Index other) { return !m_cells.grows[other] || other > site; });
    const auto nearer = [&](Index a, Index b)
    { return m_cells.distance2(site, a) < m_cells.distance2(site, b); };
    m_debt += m_cells.due[site] - 1.0 - 0.5 * static_cast<double>(around.size());
    for (; m_debt < -maxDebt && !m_partners.empty(); m_debt += 1.0)
    {
      m_partners.erase(std::min_element(m_partners.begin(), m_partners.end(), nearer));
    }
    m_debt = std::clamp(m_debt, -maxDebt, maxDebt); // or it would be paid far away
    for (const Index other : m_partners)
    {
      m_pairs.push_back({ site, other });
    }
  }

  /** At most so many: without the middles of the shortest pairs. */
  GrownSites grown(std::size_t most)
  {
    if (m_pairs.size() > most)
    {
      std::stable_sort(m_pairs.begin(), m_pairs.end(),
        [&](const auto& a, const auto& b) { return this->length2(a) > this->length2(b); });
      m_pairs.resize(most);
    }
    GrownSites result;
    result.sites.dimension = m_cells.sites.dimension;
    for (const auto& [first, second] : m_pairs)
    {
      const double* const a = m_cells.sites.site(first);
      const double* const b = m_cells.sites.site(second);
      for (int k = 0; k < m_cells.sites.dimension; ++k)
      {
        result.sites.coordinates.push_back(0.5 * (a[k] + b[k]));
      }
    }
    result.parents = m_pairs;
    return result;
  }

private:
  /** By which pairs are compared. */
  double length2(const std::array<Index, 2>& pair) const
  {
    return pair[0] == pair[1] ? std::numeric_limits<double>::infinity()
                              : m_cells.distance2(pair[0], pair[1]) * m_cells.scales[pair[0]];
  }

  const CoarseCells& m_cells;
  std::vector<std::array<Index, 2>> m_pairs;
  std::vector<Index> m_partners; ///< scratch
  double m_debt = 0.0;           ///< sites that the cells so far should have more
};

/** A drawn site that there may be a place for. */
struct Candidate
{
  Index site = noIndex;
  Index cell = noIndex; ///< the coarse one
  double gap = 0.0;     ///< squared distance from what has grown, scaled
  bool wanted = false;
};

/** Marks as many in each cell as are due to it and have not grown. Sorts them by cells. */
void chooseInCells(
  const CoarseCells& cells, const GrownSites& grown, std::vector<Candidate>& candidates)
{
  std::sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b)
    { return std::tie(a.cell, b.gap, a.site) < std::tie(b.cell, a.gap, b.site); });
  std::vector<double> left = cells.due;
  for (const auto& [first, second] : grown.parents)
  {
    left[first] -= 0.5;
    left[second] -= 0.5;
  }
  double debt = 0.0;
  for (auto next = candidates.begin(); next != candidates.end();)
  {
    const Index cell = next->cell;
    debt += left[cell];
    const double least = cells.grows[cell] ? maxDebt : 0.5; // regular cells have no gaps
    for (; next != candidates.end() && next->cell == cell; ++next)
    {
      next->wanted = debt >= least;
      debt -= next->wanted ? 1.0 : 0.0;
    }
    debt = std::clamp(debt, -maxDebt, maxDebt);
  }
}

/**
 * Adds so many drawn sites to those that have grown: the wanted ones first, the farthest first.
 * Cell by cell, as the coarse sites are near in memory to the facets that they were drawn from.
 */
Sites addCandidates(std::vector<Candidate>& candidates, std::size_t count, const Sites& drawn,
  const GrownSites& grown)
{
  std::sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b)
    { return std::tie(b.wanted, b.gap, a.site) < std::tie(a.wanted, a.gap, b.site); });
  candidates.resize(count);
  Sites sites = grown.sites;
  std::vector<Index> cells;
  std::transform(grown.parents.begin(), grown.parents.end(), std::back_inserter(cells),
    [](const std::array<Index, 2>& parents) { return parents[0]; });
  for (const Candidate& candidate : candidates)
  {
    const double* const site = drawn.site(candidate.site);
    sites.coordinates.insert(sites.coordinates.end(), site, site + drawn.dimension);
    cells.push_back(candidate.cell);
  }
  std::vector<Index> order(cells.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](Index a, Index b) { return cells[a] < cells[b]; });
  return inOrder(sites, order);
}

/** Finds the free sites of one patch after the other. */
class PatchGrower
{
public:
  PatchGrower(const Sites& drawn, const CoarseCells& cells)
    : m_drawn(drawn)
    , m_cells(cells)
    , m_search(cells.sites)
  {
  }

  /**
   * Where nothing grows, the drawn sites.
   *
   * @param own drawn sites of the patch.
   * @param coarseSites of the patch.
   */
  Status grow(const std::vector<Index>& own, const std::vector<Index>& coarseSites,
    const RunControl& control, Sites& sites) const
  {
    PatchGrowth growth(m_cells);
    for (const Index site : coarseSites)
    {
      if (m_cells.grows[site])
      {
        growth.addCell(site);
      }
    }
    const GrownSites grown = growth.grown(own.size());
    if (grown.parents.empty())
    {
      sites = inOrder(m_drawn, own);
      return Status::success();
    }
    std::vector<Candidate> candidates;
    if (!this->findCandidates(own, grown, control, candidates))
    {
      return Status::cancelled();
    }
    chooseInCells(m_cells, grown, candidates);
    sites = addCandidates(candidates, own.size() - grown.parents.size(), m_drawn, grown);
    return Status::success();
  }

private:
  bool findCandidates(const std::vector<Index>& own, const GrownSites& grown,
    const RunControl& control, std::vector<Candidate>& candidates) const
  {
    const NeighborSearch grownSearch(grown.sites);
    candidates.resize(own.size());
    return forEachItem(static_cast<Offset>(own.size()), control,
      [&](Offset k)
      {
        const double* const site = m_drawn.site(own[k]);
        const Index nearest = grownSearch.nearest(site);
        const double gap =
          squaredDistance<Eigen::Dynamic>(site, grown.sites.site(nearest), m_drawn.dimension);
        candidates[k] = { own[k], m_search.nearest(site),
          gap * m_cells.scales[grown.parents[nearest][0]], false };
      });
  }

  const Sites& m_drawn;
  const CoarseCells& m_cells;
  NeighborSearch m_search; ///< of the coarse sites
};
}

Status growSites(const EmbeddedSurface& surface, const CoarseTessellation& coarse,
  const RunControl& control, Sites& sites)
{
  const std::vector<Index> patches = patchesOf(surface, sites);
  CoarseCells cells{ coarse.sites, patchesOf(surface, coarse.sites), {}, {}, {}, {} };
  const Index numberOfPatches = 1 +
    std::max(*std::max_element(patches.begin(), patches.end()),
      *std::max_element(cells.patches.begin(), cells.patches.end()));
  const auto drawn = freeSitesByPatch(sites, patches, numberOfPatches);
  const auto coarseSites = freeSitesByPatch(coarse.sites, cells.patches, numberOfPatches);
  std::vector<Offset> wanted;
  std::transform(drawn.begin(), drawn.end(), std::back_inserter(wanted),
    [](const std::vector<Index>& own) { return static_cast<Offset>(own.size()); });
  if (Status status = findCoarseCells(surface, coarse, wanted, control, cells); !status.ok())
  {
    return status;
  }

  const PatchGrower grower(sites, cells);
  Sites result;
  result.dimension = sites.dimension;
  result.fixed = sites.fixed;
  result.coordinates.assign(sites.coordinates.data(), sites.site(sites.fixed));
  for (Index patch = 0; patch < numberOfPatches; ++patch)
  {
    Sites grown;
    if (Status status = grower.grow(drawn[patch], coarseSites[patch], control, grown); !status.ok())
    {
      return status;
    }
    result.coordinates.insert(
      result.coordinates.end(), grown.coordinates.begin(), grown.coordinates.end());
  }
  sites = std::move(result);
  return Status::success();
}
}
