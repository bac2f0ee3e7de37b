#include "Optimization/CoarseCells.h"

#include "Embedding/Distance.h"
#include "Voronoi/CellNeighbors.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace remesh
{
namespace
{
constexpr double hexagonEnergy = 0.16037507477489604; // 5 / (18 sqrt(3)), over its area squared
/**
 * Of a cell's energy over that of a hexagon of its measure. A surface that is wrinkled within the
 * cell has more measure for its extent.
 */
constexpr double minEnergy = 0.95;
constexpr double maxEnergy = 1.25;
constexpr double maxOwed = 1.0; // sites too many or too few in a cell that grows

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

/** Returns what the sites are to be spread evenly over, and finds the scales. */
std::vector<double> measureCells(
  const EmbeddedSurface& surface, const Diagram& diagram, CoarseCells& cells)
{
  std::vector<double> measures(cells.patches.size(), 0.0);
  std::vector<double> areas(cells.patches.size(), 0.0);
  for (Offset p = 0; p < diagram.numberOfPieces(); ++p)
  {
    const Index facet = diagram.facets[p];
    const double fraction = diagram.weights[p].fraction();
    measures[diagram.sites[p]] += fraction * surface.siteMeasureOf(facet);
    areas[diagram.sites[p]] += fraction * surface.embeddedArea(facet);
  }
  cells.scales.resize(areas.size());
  std::transform(measures.begin(), measures.end(), areas.begin(), cells.scales.begin(),
    [](double measure, double area) { return area > 0.0 ? measure / area : 1.0; });
  return measures;
}

/**
 * Shares the sites out by measure. Of the cells of fixed sites, half goes to fixed ones again; but
 * as none grow there, they keep the sites that were drawn.
 */
void findDue(
  const std::vector<double>& measures, const std::vector<Offset>& wanted, CoarseCells& cells)
{
  cells.due = measures;
  std::vector<double> sums(wanted.size(), 0.0);
  for (Index i = 0; i < cells.sites.count(); ++i)
  {
    sums[cells.patches[i]] += (i < cells.sites.fixed ? 0.5 : 1.0) * cells.due[i];
  }
  for (Index i = 0; i < cells.sites.count(); ++i)
  {
    const double sum = sums[cells.patches[i]];
    cells.due[i] *= sum > 0.0 ? static_cast<double>(wanted[cells.patches[i]]) / sum : 0.0;
  }
}

void findGrowing(
  const std::vector<double>& measures, const std::vector<double>& energies, CoarseCells& cells)
{
  cells.grows.assign(cells.patches.size(), 0);
  for (Index i = cells.sites.fixed; i < cells.sites.count(); ++i)
  {
    const std::vector<Index>& around = cells.neighbors[i];
    const double energy = energies[i] / (hexagonEnergy * measures[i] * measures[i]);
    const double owed = cells.due[i] - 1.0 - 0.5 * static_cast<double>(around.size());
    cells.grows[i] = energy > minEnergy && energy < maxEnergy && std::abs(owed) < maxOwed &&
      std::none_of(
        around.begin(), around.end(), [&](Index other) { return other < cells.sites.fixed; });
  }
}
}

double CoarseCells::distance2(Index a, Index b) const
{
  return squaredDistance<Eigen::Dynamic>(
    this->sites.site(a), this->sites.site(b), this->sites.dimension);
}

std::vector<Index> patchesOf(const EmbeddedSurface& surface, const Sites& sites)
{
  std::vector<Index> patches(static_cast<std::size_t>(sites.count()));
  for (Index i = 0; i < sites.count(); ++i)
  {
    patches[i] = surface.patches.patchOf(sites.site(i));
  }
  return patches;
}

Status findCoarseCells(const EmbeddedSurface& surface, const CoarseTessellation& coarse,
  const std::vector<Offset>& wanted, const RunControl& control, CoarseCells& cells)
{
  if (Status status = findNeighbors(coarse.diagram, control, cells); !status.ok())
  {
    return status;
  }
  const std::vector<double> measures = measureCells(surface, coarse.diagram, cells);
  findDue(measures, wanted, cells);
  findGrowing(measures, coarse.sums.energy, cells);
  return Status::success();
}
}
