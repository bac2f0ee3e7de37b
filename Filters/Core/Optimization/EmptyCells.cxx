#include "Optimization/EmptyCells.h"

#include "Optimization/FixedSites.h"
#include "Optimization/Sampling.h"
#include "Support/Random.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr int maxRounds = 8;
constexpr std::uint64_t firstStream = 16; // apart from those of Sampling.cxx

/** Mass of each facet times the mean energy density of the cells at its corners. */
std::vector<double> energyOfFacets(
  const EmbeddedSurface& surface, const std::vector<Index>& owners, const CellSums& sums)
{
  std::vector<double> weights(surface.constants.size());
  for (std::size_t f = 0; f < weights.size(); ++f)
  {
    double density = 0.0;
    for (const Index corner : surface.facetCorners[f])
    {
      const Index owner = owners[corner];
      density += sums.mass[owner] > 0.0 ? sums.energy[owner] / sums.mass[owner] : 0.0;
    }
    weights[f] = surface.constants[f].mass * density;
  }
  return weights;
}
}

Status integrateAndFill(const Relaxation& relaxation, const RunControl& control)
{
  auto& [voronoi, surface, seed, sites, sums, convergence, emptyCells] = relaxation;
  for (int round = 0;; ++round)
  {
    // Further rounds are rare and must not let the progress fall.
    if (Status status = voronoi.integrate(sites, round == 0 ? control : control.silent(), sums);
        !status.ok())
    {
      return status;
    }
    holdFixedSites(sites, sums);
    emptyCells = countEmptyFree(sites, sums);
    if (emptyCells == 0 || round == maxRounds)
    {
      return Status::success();
    }
    const std::vector<double> weights = energyOfFacets(surface, voronoi.owners(), sums);
    if (std::all_of(weights.begin(), weights.end(), [](double w) { return !(w > 0.0); }))
    {
      return Status::success(); // every site sits on all of its cell: nothing to gain
    }
    const FacetSampler sampler(surface, weights);
    const std::uint64_t stream =
      firstStream + 3 * static_cast<std::uint64_t>(voronoi.evaluations());
    for (Index i = sites.fixed; i < sites.count(); ++i)
    {
      if (sums.isEmpty(i))
      {
        sampler.draw(uniform01(seed, i, stream), uniform01(seed, i, stream + 1),
          uniform01(seed, i, stream + 2), sites.site(i));
      }
    }
  }
}
}
