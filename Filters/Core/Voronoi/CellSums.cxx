#include "Voronoi/CellSums.h"

#include "Support/BlockedVectors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace remesh
{
namespace
{
constexpr int scalars = 2; // mass, energy

/** For each site, its entries (block, slot) in the order of the blocks. */
struct EntriesOfSites
{
  struct Entry
  {
    Index block;
    Index slot;
  };
  std::vector<Offset> begin; ///< n + 1
  std::vector<Entry> entries;

  EntriesOfSites(const std::vector<BlockSums>& blocks, Index numberOfSites)
    : begin(static_cast<std::size_t>(numberOfSites) + 2, 0)
  {
    // Count two places up, scan, then fill: each start ends up one place down, where it belongs.
    for (const BlockSums& block : blocks)
    {
      for (const Index site : block.sites)
      {
        ++this->begin[static_cast<std::size_t>(site) + 2];
      }
    }
    for (std::size_t k = 2; k < this->begin.size(); ++k)
    {
      this->begin[k] += this->begin[k - 1];
    }
    this->entries.resize(static_cast<std::size_t>(this->begin.back()));
    for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      for (std::size_t s = 0; s < blocks[b].sites.size(); ++s)
      {
        const auto site = static_cast<std::size_t>(blocks[b].sites[s]);
        this->entries[this->begin[site + 1]++] = { static_cast<Index>(b), static_cast<Index>(s) };
      }
    }
    this->begin.pop_back();
  }
};
}

template <int D>
BlockAccumulator<D>::BlockAccumulator(const EmbeddedSurface& surface, const Sites& sites)
  : m_surface(surface)
  , m_sites(sites)
  , m_corners(surface)
  , m_slots(static_cast<std::size_t>(sites.count()))
  , m_gathers(D == Eigen::Dynamic && surface.dimension >= manyDimensions)
{
}

template <int D>
void BlockAccumulator<D>::begin(BlockSums& sums)
{
  m_sums = &sums;
  m_sums->sites.clear();
  m_sums->values.clear();
  ++m_block;
}

/** Zeros for a site that the block meets for the first time. */
template <int D>
double* BlockAccumulator<D>::addSite(Index site)
{
  m_slots[site] = { m_block, static_cast<Index>(m_sums->sites.size()) };
  m_sums->sites.push_back(site);
  m_sums->values.resize(m_sums->values.size() + static_cast<std::size_t>(this->stride()));
  return m_sums->values.data() + m_sums->values.size() - this->stride();
}

template <int D>
void BlockAccumulator<D>::add(Index facet, Index site, const PieceIntegral& piece)
{
  const int d = this->dimension();
  const FacetConstants& constants = m_surface.constants[facet];
  double* values = this->valuesOf(site);
  values[0] += piece.fraction() * constants.mass;
  values[1] += piece.energy;
  if (m_gathers)
  {
    for (int k = 0; k < 3; ++k)
    {
      m_weights.push_back({ m_surface.facetCorners[facet][k], m_slots[site].place,
        piece.weights[k] * constants.mass });
    }
    return;
  }
  const auto [p0, p1, p2] = m_corners.facet(facet);
  using Coordinates = Eigen::Array<double, D, 1>;
  using Row = Eigen::Map<const Coordinates>;
  const Row x(m_sites.site(site), d);
  const double w0 = piece.weights[0] * constants.mass;
  const double w1 = piece.weights[1] * constants.mass;
  const double w2 = piece.weights[2] * constants.mass;
  Eigen::Map<Coordinates>(values + scalars, d) +=
    w0 * (Row(p0, d) - x) + w1 * (Row(p1, d) - x) + w2 * (Row(p2, d) - x);
}

template <int D>
void BlockAccumulator<D>::addWholeFacets(const Index* begin, const Index* end, Index site)
{
  using Coordinates = Eigen::Array<double, D, 1>;
  using Row = Eigen::Map<const Coordinates>;
  const int d = this->dimension();
  const Row x(m_sites.site(site), d);
  double* values = this->valuesOf(site);
  Eigen::Map<Coordinates> moments(values + scalars, d);
  Coordinates moment = moments; // in registers meanwhile
  double mass = values[0];
  double energy = values[1];
  Coordinates offset(d);
  for (const Index* facet = begin; facet != end; ++facet)
  {
    const FacetConstants& constants = m_surface.constants[*facet];
    const auto [p0, p1, p2] = m_corners.facet(*facet);
    offset = (Row(p0, d) + Row(p1, d) + Row(p2, d)) * (1.0 / 3.0) - x;
    const double* e = constants.edge2;
    mass += constants.mass;
    energy += constants.mass * (offset.matrix().squaredNorm() + (e[0] + e[1] + e[2]) / 36.0);
    moment += constants.mass * offset;
  }
  values[0] = mass;
  values[1] = energy;
  moments = moment;
}

template <int D>
void BlockAccumulator<D>::finish()
{
  const auto place = [](const CornerWeight& w) { return std::make_pair(w.corner, w.slot); };
  // Stable: equal places are summed in the order of the facets.
  std::stable_sort(m_weights.begin(), m_weights.end(),
    [&](const CornerWeight& a, const CornerWeight& b) { return place(a) < place(b); });
  for (auto next = m_weights.begin(); next != m_weights.end();)
  {
    const CornerWeight& first = *next;
    double weight = 0.0;
    for (; next != m_weights.end() && place(*next) == place(first); ++next)
    {
      weight += next->weight;
    }
    const Index site = m_sums->sites[first.slot];
    const double* p = m_corners.corner(first.corner);
    const double* x = m_sites.site(site);
    double* moment = this->valuesOf(site) + scalars;
    for (int k = 0; k < this->dimension(); ++k)
    {
      moment[k] += weight * (p[k] - x[k]);
    }
  }
  m_weights.clear();
}

template class BlockAccumulator<3>;
template class BlockAccumulator<6>;
template class BlockAccumulator<Eigen::Dynamic>;

void beginSums(Index numberOfSites, int dimension, CellSums& sums)
{
  const auto n = static_cast<std::size_t>(numberOfSites);
  sums.mass.assign(n, 0.0);
  sums.energy.assign(n, 0.0);
  sums.moment.assign(n * static_cast<std::size_t>(dimension), 0.0);
}

Status addBlocks(
  const std::vector<BlockSums>& blocks, int dimension, const RunControl& control, CellSums& sums)
{
  const auto d = static_cast<std::size_t>(dimension);
  const auto numberOfSites = static_cast<Index>(sums.mass.size());
  const EntriesOfSites table(blocks, numberOfSites);
  const bool done = forEachRange(Blocks::cut(numberOfSites, 256, 4096), control,
    [&](Offset first, Offset last)
    {
      for (Offset site = first; site < last; ++site)
      {
        double* moment = sums.moment.data() + static_cast<std::size_t>(site) * d;
        for (Offset e = table.begin[site]; e < table.begin[site + 1]; ++e)
        {
          const auto [block, slot] = table.entries[e];
          const double* values =
            blocks[block].values.data() + static_cast<std::size_t>(slot) * (scalars + d);
          sums.mass[site] += values[0];
          sums.energy[site] += values[1];
          for (std::size_t k = 0; k < d; ++k)
          {
            moment[k] += values[scalars + k];
          }
        }
      }
    });
  return done ? Status::success() : Status::cancelled();
}

Status finishSums(int dimension, const RunControl& control, CellSums& sums)
{
  const auto n = static_cast<Offset>(sums.mass.size());
  const BlockedVectors energies(n, 1, control);
  sums.totalEnergy = energies.sum([&](std::size_t k) { return sums.energy[k]; });
  const BlockedVectors moments(n, dimension, control);
  const double squared =
    moments.sum([&](std::size_t k) { return sums.moment[k] * sums.moment[k]; });
  sums.gradientNorm = 2.0 * std::sqrt(squared);
  return energies.complete() && moments.complete() ? Status::success() : Status::cancelled();
}
}
