/**
 * @file CellDisks.cxx
 *
 * Faces - edges + vertices, where what several pieces share is counted in parts that add up to one:
 * a side by the two pieces beside it, a crossing on an edge by the four around it, a meeting of
 * three inside a facet by the three. A corner of the surface counts in the first of its facets.
 * What lies on the border of the cell is not counted.
 */
#include "Delaunay/CellDisks.h"

#include "Support/DisjointSets.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr Index whole = 12; // in which shares are counted
constexpr Index ofTwo = whole / 2;
constexpr Index ofThree = whole / 3;
constexpr Index ofFour = whole / 4;

class DiskFinder
{
public:
  explicit DiskFinder(const CellComplex& cells)
    : m_joins(cells.joins)
    , m_diagram(cells.diagram)
    , m_components(cells.components)
    , m_seams(cells.seams)
    , m_inSeam(static_cast<std::size_t>(m_components.count()), 0)
    , m_isPinched(m_inSeam.size(), 0)
    , m_hasCollar(m_inSeam.size(), 0)
    , m_fromCollar(m_inSeam.size(), 0)
    , m_parts(m_seams ? m_diagram.sites.size() + m_inSeam.size() : 0)
  {
    this->prepareSeams();
  }

  bool isDisk(Index component)
  {
    Index sum = m_fromCollar[component];
    bool ofOneSite = true;
    const Offset begin = m_components.pieceBegin[component];
    const Offset end = m_components.pieceBegin[component + 1];
    for (Offset p = begin; p < end; ++p)
    {
      const Index piece = m_components.pieces[p];
      sum += this->pieceShare(component, piece);
      ofOneSite =
        ofOneSite && m_diagram.sites[piece] == m_diagram.sites[m_components.pieces[begin]];
    }
    const Index parts = ofOneSite && !m_inSeam[component] ? 1 : this->countParts(component);
    return sum == whole * parts && (parts == 1 || m_isPinched[component]);
  }

private:
  /** The collar of each vertex on features, and where its cell in the patches meets it. */
  void prepareSeams()
  {
    if (!m_seams)
    {
      return;
    }
    for (std::size_t p = 0; p < m_seams->components.size(); ++p)
    {
      if (const Index component = m_seams->components[p]; component != noIndex)
      {
        const CollarShape shape = m_seams->collars[p];
        m_inSeam[component] = 1;
        m_hasCollar[component] = shape != CollarShape::None;
        m_fromCollar[component] += shape == CollarShape::Disk ? whole : 0;
      }
    }
    m_seams->forEachPinch([&](Index component, const Pinch&) { m_isPinched[component] = 1; });
    for (const Contact& contact : m_seams->contacts)
    {
      m_fromCollar[m_components.ofPiece[contact.piece]] += ofTwo * (contact.innerEnds - 2);
      m_contacts.push_back(contact.piece);
    }
    std::sort(m_contacts.begin(), m_contacts.end());
  }

  bool isOwn(Index component, Index facet, Index site) const
  {
    const Offset piece = m_diagram.pieceOf(facet, site);
    return piece >= 0 && m_components.ofPiece[piece] == component;
  }

  /** All that a piece adds: of a whole facet, the surface tells it. */
  Index pieceShare(Index component, Index piece) const
  {
    const Index facet = m_diagram.facets[piece];
    if (m_diagram.hasOnePiece(facet))
    {
      return this->facetShare(facet);
    }
    Index sum = whole;
    for (Offset v = m_diagram.vertexBegin[piece]; v < m_diagram.vertexBegin[piece + 1]; ++v)
    {
      sum += this->sideShare(component, piece, m_diagram.across[v]);
      sum += this->vertexShare(
        component, piece, m_diagram.acrossIncoming(piece, v), m_diagram.across[v]);
    }
    return sum;
  }

  Index facetShare(Index facet) const
  {
    Index sum = whole;
    for (int k = 0; k < 3; ++k)
    {
      sum += whole * m_joins.countsCorner(facet, k) - ofTwo * m_joins.isInnerSide(facet, k);
    }
    return sum;
  }

  /** @param side -1 - k. */
  bool isInside(Index facet, Index side) const { return m_joins.isInnerSide(facet, -1 - side); }

  Index sideShare(Index component, Index piece, Index across) const
  {
    const Index facet = m_diagram.facets[piece];
    const bool inner =
      across < 0 ? this->isInside(facet, across) : this->isOwn(component, facet, across);
    return inner ? -ofTwo : 0;
  }

  Index vertexShare(Index component, Index piece, Index incoming, Index outgoing) const
  {
    const Index facet = m_diagram.facets[piece];
    if (incoming < 0 && outgoing < 0)
    {
      return m_joins.countsCorner(facet, -1 - outgoing) ? whole : 0;
    }
    if (incoming >= 0 && outgoing >= 0)
    {
      return this->isOwn(component, facet, incoming) && this->isOwn(component, facet, outgoing)
        ? ofThree
        : 0;
    }
    return this->isInside(facet, std::min(incoming, outgoing)) &&
        this->isOwn(component, facet, std::max(incoming, outgoing))
      ? ofFour
      : 0;
  }

  /** The piece of the same site beyond a side on an edge, or another one's within the facet. */
  Offset pieceBeyond(Index piece, Index across) const
  {
    const Index facet = m_diagram.facets[piece];
    if (across >= 0)
    {
      return m_diagram.pieceOf(facet, across);
    }
    if (!this->isInside(facet, across))
    {
      return -1;
    }
    const EdgeTable& edges = m_joins.edges;
    const Index edge = edges.facetEdges[facet][-1 - across];
    const Index* around = edges.edgeFacets.data() + edges.edgeFacetsBegin[edge];
    return m_diagram.pieceOf(around[around[0] == facet ? 1 : 0], m_diagram.sites[piece]);
  }

  /** Walks from piece to piece, and through the collar. */
  Index countParts(Index component)
  {
    const auto collar = static_cast<Index>(m_diagram.numberOfPieces()) + component;
    const Offset begin = m_components.pieceBegin[component];
    const Offset end = m_components.pieceBegin[component + 1];
    for (Offset p = begin; p < end; ++p)
    {
      const Index piece = m_components.pieces[p];
      for (Offset v = m_diagram.vertexBegin[piece]; v < m_diagram.vertexBegin[piece + 1]; ++v)
      {
        // A lower one; from a higher one, this piece is met.
        const auto other = static_cast<Index>(this->pieceBeyond(piece, m_diagram.across[v]));
        if (other >= 0 && other < piece && m_components.ofPiece[other] == component)
        {
          m_parts.unite(piece, other);
        }
      }
      if (std::binary_search(m_contacts.begin(), m_contacts.end(), piece))
      {
        m_parts.unite(piece, collar);
      }
    }
    Index parts = m_hasCollar[component] && m_parts.isLowest(collar) ? 1 : 0;
    for (Offset p = begin; p < end; ++p)
    {
      parts += m_parts.isLowest(m_components.pieces[p]);
    }
    return parts;
  }

  const FacetJoins& m_joins;
  const Diagram& m_diagram;
  const Components& m_components;
  const Seams* m_seams;
  std::vector<char> m_inSeam; ///< components of vertices on features
  std::vector<char> m_isPinched;
  std::vector<char> m_hasCollar;
  std::vector<Index> m_fromCollar; ///< components: what the collar adds
  std::vector<Index> m_contacts;   ///< pieces that meet their own collar, ascending
  /** Of pieces, and of each component's collar behind them: fewer than a diagram has vertices. */
  DisjointSets m_parts;
};
}

Status findDisks(const CellComplex& cells, const RunControl& control, std::vector<char>& isDisk)
{
  DiskFinder finder(cells);
  const Index count = cells.components.count();
  isDisk.resize(static_cast<std::size_t>(count));
  const bool done = forEachItem(Blocks::cut(count, 256, 4096), control,
    [&](Offset k) { isDisk[k] = finder.isDisk(static_cast<Index>(k)); });
  return done ? Status::success() : Status::cancelled();
}
}
