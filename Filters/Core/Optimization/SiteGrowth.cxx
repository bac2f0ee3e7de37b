#include "Optimization/SiteGrowth.h"

#include "Embedding/Distance.h"
#include "Optimization/SiteOrder.h"
#include "Voronoi/CellNeighbors.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

namespace remesh
{
namespace
{
constexpr double mostOwed = 2.0;     // sites by which a row of cells may have too many or too few
constexpr double mostLacking = 0.05; // extra sites for each coarse one

struct CoarseCells
{
  const Sites& sites;
  std::vector<Index> patches;                ///< n
  std::vector<std::vector<Index>> neighbors; ///< n, those of the same patch
  /** n, new sites that belong there less those that there are; fixed sites: none. */
  std::vector<double> owed;

  bool isFixed(Index site) const { return site < this->sites.fixed; }
  double distance2(Index a, Index b) const
  {
    return squaredDistance<Eigen::Dynamic>(
      this->sites.site(a), this->sites.site(b), this->sites.dimension);
  }
};

Status findNeighbors(const Diagram& diagram, const RunControl& control, CoarseCells& cells)
{
  cells.neighbors.resize(cells.patches.size());
  return forEachCell(diagram, cells.sites.count(), control,
    [&](Index site, const std::vector<Index>& around)
    {
      std::copy_if(around.begin(), around.end(), std::back_inserter(cells.neighbors[site]),
        [&](Index other) { return cells.patches[other] == cells.patches[site]; });
    });
}

/** Of each cell, what the sites are to be spread evenly over. */
std::vector<double> measureCells(
  const EmbeddedSurface& surface, const Diagram& diagram, Index numberOfSites)
{
  std::vector<double> measures(static_cast<std::size_t>(numberOfSites), 0.0);
  for (Offset p = 0; p < diagram.numberOfPieces(); ++p)
  {
    measures[diagram.sites[p]] +=
      diagram.integrals[p].fraction() * surface.constants[diagram.facets[p]].siteMeasure();
  }
  return measures;
}

/**
 * A middle counts by halves for its two cells. Beside fixed sites, which may be closer together
 * than others, nothing is known to be owed; half of their cells goes to fixed ones again.
 */
void findOwed(
  const std::vector<double>& measures, const std::vector<Offset>& counts, CoarseCells& cells)
{
  std::vector<double> units(counts.size(), 0.0); // measure for each new site
  for (Index i = 0; i < cells.sites.count(); ++i)
  {
    units[cells.patches[i]] += (cells.isFixed(i) ? 0.5 : 1.0) * measures[i];
  }
  for (std::size_t p = 0; p < units.size(); ++p)
  {
    units[p] /= static_cast<double>(std::max(counts[p], Offset(1)));
  }
  cells.owed.assign(cells.patches.size(), 0.0);
  for (Index i = cells.sites.fixed; i < cells.sites.count(); ++i)
  {
    const std::vector<Index>& around = cells.neighbors[i];
    if (std::none_of(
          around.begin(), around.end(), [&](Index other) { return cells.isFixed(other); }))
    {
      cells.owed[i] =
        measures[i] / units[cells.patches[i]] - 1.0 - 0.5 * static_cast<double>(around.size());
    }
  }
}

/** Collects the free sites of one patch, cell by cell. */
class PatchGrowth
{
public:
  explicit PatchGrowth(const CoarseCells& cells)
    : m_cells(cells)
  {
    m_sites.dimension = cells.sites.dimension;
  }

  /** The site of a free cell, and its middles with fixed and with later sites. */
  void addCell(Index site)
  {
    this->add({ site }, std::numeric_limits<double>::infinity());
    m_partners.clear();
    std::copy_if(m_cells.neighbors[site].begin(), m_cells.neighbors[site].end(),
      std::back_inserter(m_partners),
      [&](Index other) { return m_cells.isFixed(other) || other > site; });
    const auto nearer = [&](Index a, Index b)
    { return m_cells.distance2(site, a) < m_cells.distance2(site, b); };
    m_owed += m_cells.owed[site];
    for (; m_owed < -mostOwed && !m_partners.empty(); m_owed += 1.0)
    {
      m_partners.erase(std::min_element(m_partners.begin(), m_partners.end(), nearer));
    }
    m_owed = std::max(m_owed, -mostOwed); // or it would be paid far away
    for (const Index other : m_partners)
    {
      this->add({ site, other }, m_cells.distance2(site, other));
    }
    if (m_owed > mostOwed && m_cells.neighbors[site].size() > 1)
    {
      this->addBetweenThree(site);
    }
    m_owed = std::min(m_owed, mostOwed);
  }

  Index numberOfSites() const { return m_sites.count(); }
  Offset numberLacking() const { return m_lacking; }

  /** Leaves out the middles of the shortest pairs. */
  void shrinkTo(Index count)
  {
    std::vector<Index> kept(static_cast<std::size_t>(this->numberOfSites()));
    std::iota(kept.begin(), kept.end(), 0);
    std::stable_sort(
      kept.begin(), kept.end(), [&](Index a, Index b) { return m_lengths2[a] > m_lengths2[b]; });
    kept.resize(static_cast<std::size_t>(count));
    std::sort(kept.begin(), kept.end());
    m_sites = inOrder(m_sites, kept);
  }

  const Sites& sites() const { return m_sites; }

private:
  /** The mean of some sites. */
  void add(std::initializer_list<Index> corners, double length2)
  {
    const auto size = static_cast<double>(corners.size());
    for (int k = 0; k < m_sites.dimension; ++k)
    {
      double sum = 0.0;
      for (const Index corner : corners)
      {
        sum += m_cells.sites.site(corner)[k];
      }
      m_sites.coordinates.push_back(sum / size);
    }
    m_lengths2.push_back(length2);
  }

  /** Towards the farthest neighbour, and the one nearest to that. */
  void addBetweenThree(Index site)
  {
    const std::vector<Index>& around = m_cells.neighbors[site];
    const Index far = *std::max_element(around.begin(), around.end(),
      [&](Index a, Index b) { return m_cells.distance2(site, a) < m_cells.distance2(site, b); });
    const auto fromFar = [&](Index other) {
      return other == far ? std::numeric_limits<double>::infinity() : m_cells.distance2(far, other);
    };
    const Index next = *std::min_element(
      around.begin(), around.end(), [&](Index a, Index b) { return fromFar(a) < fromFar(b); });
    this->add({ site, far, next }, m_cells.distance2(site, far));
    ++m_lacking;
  }

  const CoarseCells& m_cells;
  Sites m_sites;
  std::vector<double> m_lengths2; ///< of the pairs, squared; infinite for coarse sites
  std::vector<Index> m_partners;  ///< scratch
  double m_owed = 0.0;            ///< by the cells so far
  Offset m_lacking = 0;           ///< sites that middles were too few for
};

/** The free sites, patch by patch; of one patch along the curve that they were drawn on. */
std::vector<Index> freeSitesByPatch(const CoarseCells& cells)
{
  std::vector<Index> order(static_cast<std::size_t>(cells.sites.count() - cells.sites.fixed));
  std::iota(order.begin(), order.end(), cells.sites.fixed);
  std::stable_sort(order.begin(), order.end(),
    [&](Index a, Index b) { return cells.patches[a] < cells.patches[b]; });
  return order;
}
}

Status growSites(const EmbeddedSurface& surface, const Sites& sites, const Diagram& diagram,
  const RunControl& control, std::vector<Offset>& counts, Sites& grown)
{
  CoarseCells cells{ sites, {}, {}, {} };
  for (Index i = 0; i < sites.count(); ++i)
  {
    cells.patches.push_back(surface.patches.patchOf(sites.site(i)));
  }
  if (Status status = findNeighbors(diagram, control.silent(), cells); !status.ok())
  {
    return status;
  }
  findOwed(measureCells(surface, diagram, sites.count()), counts, cells);

  std::vector<Offset> left = counts;
  std::vector<double> coordinates;
  Offset lacking = 0;
  const std::vector<Index> order = freeSitesByPatch(cells);
  for (std::size_t k = 0; k < order.size();)
  {
    const Index patch = cells.patches[order[k]];
    PatchGrowth growth(cells);
    for (; k < order.size() && cells.patches[order[k]] == patch; ++k)
    {
      growth.addCell(order[k]);
    }
    lacking += growth.numberLacking();
    if (growth.numberOfSites() > counts[patch])
    {
      growth.shrinkTo(static_cast<Index>(counts[patch]));
    }
    const Sites along = inOrder(growth.sites(), orderInSpace(growth.sites(), control.silent()));
    if (control.cancelled())
    {
      return Status::cancelled();
    }
    coordinates.insert(coordinates.end(), along.coordinates.begin(), along.coordinates.end());
    left[patch] -= along.count();
  }
  if (static_cast<double>(lacking) <= mostLacking * static_cast<double>(order.size()))
  {
    counts = std::move(left);
    grown.coordinates.insert(grown.coordinates.end(), coordinates.begin(), coordinates.end());
  }
  return Status::success();
}
}
