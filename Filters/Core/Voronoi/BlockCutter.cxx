#include "Voronoi/BlockCutter.h"

namespace remesh
{
template <int D>
BlockCutter<D>::BlockCutter(const CutTask& task)
  : m_task(task)
  , m_integration(task.surface, task.sites, task.lists, task.ownership.owners(), task.centers,
      task.instructions)
  , m_decomposition(task.surface, task.sites, task.lists, task.ownership.owners(), task.decisions)
  , m_accumulator(task.surface, task.sites)
{
}

template <int D>
void BlockCutter<D>::addWholeFacets(Index begin, Index end, Index owner)
{
  if (D != Eigen::Dynamic || m_task.surface.dimension < manyDimensions)
  {
    m_accumulator.addWholeFacets(begin, end, owner);
    return;
  }
  const std::vector<double>& squared = m_task.ownership.squared();
  for (Index facet = begin; facet < end; ++facet)
  {
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
  for (auto facet = static_cast<Index>(begin); facet < end;)
  {
    const Index owner = this->ownerOfAll(facet);
    const Index first = facet++;
    if (owner == noIndex)
    {
      this->addSharedFacet(first);
      continue;
    }
    while (facet < end && this->ownerOfAll(facet) == owner)
    {
      ++facet;
    }
    this->addWholeFacets(first, facet, owner);
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
