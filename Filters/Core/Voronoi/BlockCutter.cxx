#include "Voronoi/BlockCutter.h"

namespace remesh
{
namespace
{
/** What is done with a facet; of shared ones, by how many pairs of corners have the same owner. */
enum Kind
{
  amongThree,
  betweenTwo,
  traced, ///< alone, as many sites shared it before, or in many dimensions
  whole
};
}

template <int D>
BlockCutter<D>::BlockCutter(const CutTask& task)
  : m_task(task)
  , m_integration(task.surface, task.sites, task.lists, task.ownership.owners(), task.centers,
      task.instructions)
  , m_batches(task.surface, task.sites, task.lists, task.ownership.owners(), m_integration.packs(),
      task.instructions)
  , m_decomposition(task.surface, task.sites, task.lists, task.ownership.owners(), task.decisions)
  , m_accumulator(task.surface, task.sites)
{
}

/** In a list for each kind: one after the other, the processor can foresee what is done. */
template <int D>
void BlockCutter<D>::sortFacets(Index begin, Index end)
{
  const std::vector<Index>& owners = m_task.ownership.owners();
  const bool inBatches = m_batches.serves();
  Index* next[4];
  for (int kind = 0; kind < 4; ++kind)
  {
    m_facets[kind].resize(static_cast<std::size_t>(end - begin));
    next[kind] = m_facets[kind].data();
  }
  for (Index facet = begin; facet < end; ++facet)
  {
    const Triple& corners = m_task.surface.facetCorners[facet];
    const Index a = owners[corners[0]];
    const Index b = owners[corners[1]];
    const Index c = owners[corners[2]];
    const int equal = (a == b) + (b == c) + (c == a);
    const bool alone = !inBatches || m_task.centers[facet] != noIndex;
    *next[equal == 3 ? whole : alone ? traced : equal]++ = facet;
  }
  for (int kind = 0; kind < 4; ++kind)
  {
    m_facets[kind].resize(static_cast<std::size_t>(next[kind] - m_facets[kind].data()));
  }
}

template <int D>
void BlockCutter<D>::addWholeFacets()
{
  const std::vector<Index>& facets = m_facets[whole];
  const Index* end = facets.data() + facets.size();
  for (const Index* first = facets.data(); first != end;)
  {
    const Index owner = this->ownerOf(*first);
    const Index* last = first;
    while (last != end && this->ownerOf(*last) == owner)
    {
      ++last;
    }
    this->addWholeFacets(first, last, owner);
    first = last;
  }
}

template <int D>
void BlockCutter<D>::addWholeFacets(const Index* begin, const Index* end, Index owner)
{
  if (D != Eigen::Dynamic || m_task.surface.dimension < manyDimensions)
  {
    m_accumulator.addWholeFacets(begin, end, owner);
    return;
  }
  const std::vector<double>& squared = m_task.ownership.squared();
  for (const Index* next = begin; next != end; ++next)
  {
    const Index facet = *next;
    const Triple& corners = m_task.surface.facetCorners[facet];
    const double h[3] = { squared[corners[0]], squared[corners[1]], squared[corners[2]] };
    m_accumulator.add(facet, owner, integrateWholeFacet(m_task.surface.constants[facet], h));
  }
}

template <int D>
PieceIntegral BlockCutter<D>::integralOf(Index facet, const FacetPiece& piece, bool whole) const
{
  const FacetTiling& tiling = m_decomposition.tiling();
  const FacetConstants& constants = m_task.surface.constants[facet];
  return whole ? integrateWholeFacet(constants, tiling.site(piece.slot).h)
               : integratePiece(tiling, constants, piece.polygon, piece.slot);
}

template <int D>
void BlockCutter<D>::addSharedFacet(Index facet)
{
  if (m_integration.integrate(facet))
  {
    m_integration.forEachPart(m_task.surface.constants[facet],
      [&](Index site, const PieceIntegral& part) { m_accumulator.add(facet, site, part); });
    return;
  }
  m_decomposition.gather(facet);
  m_decomposition.tile();
  for (const FacetPiece& piece : m_decomposition)
  {
    m_accumulator.add(
      facet, m_decomposition.tiling().site(piece.slot).id, this->integralOf(facet, piece, false));
  }
}

template <int D>
void BlockCutter<D>::integrate(Offset begin, Offset end, BlockSums& sums)
{
  m_accumulator.begin(sums);
  m_decomposition.beginBlock();
  this->sortFacets(static_cast<Index>(begin), static_cast<Index>(end));
  this->addWholeFacets();
  const auto add = [this](Index site, const double(*values)[lanes], int lane)
  { m_accumulator.addColumn(site, values, lane); };
  std::vector<Index>& others = m_facets[traced];
  m_batches.integrate(m_facets[betweenTwo], 2, add, others);
  m_batches.integrate(m_facets[amongThree], 3, add, others);
  for (const Index facet : others)
  {
    this->addSharedFacet(facet);
  }
  m_accumulator.finish();
}

template <int D>
void BlockCutter<D>::decompose(
  Offset begin, Offset end, const KeptPieces* kept, BlockSums& sums, DiagramBlock& pieces)
{
  m_accumulator.begin(sums);
  m_decomposition.beginBlock();
  for (auto facet = static_cast<Index>(begin); facet < end; ++facet)
  {
    if (kept && kept->keeps(facet))
    {
      kept->forEachPiece(facet,
        [&](Index site, const PieceIntegral& integral)
        { m_accumulator.add(facet, site, integral); });
      continue;
    }
    const bool whole = this->ownerOfAll(facet) != noIndex;
    m_decomposition.gather(facet);
    m_decomposition.tile();
    m_decomposition.fixFirstVertices();
    for (const FacetPiece& piece : m_decomposition)
    {
      const FacetTiling& tiling = m_decomposition.tiling();
      const Index site = tiling.site(piece.slot).id;
      const PieceIntegral integral = this->integralOf(facet, piece, whole);
      m_accumulator.add(facet, site, integral);
      pieces.add(facet, site, integral, piece.polygon, tiling);
    }
  }
  m_accumulator.finish();
}

template class BlockCutter<3>;
template class BlockCutter<6>;
template class BlockCutter<Eigen::Dynamic>;
}
