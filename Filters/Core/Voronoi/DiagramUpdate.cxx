#include "Voronoi/DiagramUpdate.h"

#include "Support/Parallel.h"
#include "Voronoi/DiagramBlocks.h"

#include <utility>

namespace remesh
{
namespace
{
/** Where the pieces of each facet are, before and after. */
class Update
{
public:
  Update(const KeptPieces& kept, Diagram& changes, const RunControl& control, Diagram& diagram)
    : m_kept(kept)
    , m_control(control)
    , m_changes(changes)
    , m_diagram(diagram)
  {
    const auto facets = static_cast<Index>(changes.facetBegin.size() - 1);
    m_facetBegin.push_back(0);
    for (Index facet = 0; facet < facets; ++facet)
    {
      const Diagram& source = this->sourceOf(facet);
      m_facetBegin.push_back(
        m_facetBegin.back() + source.facetBegin[facet + 1] - source.facetBegin[facet]);
    }
  }

  Status run()
  {
    std::vector<Index> vertexBegin;
    if (Status status = this->placeVertices(vertexBegin); !status.ok())
    {
      return status;
    }
    const auto renumbered = [&](Index facet, Index site)
    { return site >= 0 && m_kept.keeps(facet) ? m_kept.later()[site] : site; };
    bool done = this->takeVertices(vertexBegin, renumbered);
    done = done && this->takePieces(&Diagram::sites, renumbered);
    done = done && this->takePieces(&Diagram::facets, [](Index, Index facet) { return facet; });
    done = done &&
      this->takePieces(
        &Diagram::integrals, [](Index, const PieceIntegral& integral) { return integral; });
    m_diagram.vertexBegin = std::move(vertexBegin);
    m_diagram.facetBegin = std::move(m_facetBegin);
    return done ? Status::success() : Status::cancelled();
  }

private:
  const Diagram& sourceOf(Index facet) const { return m_kept.keeps(facet) ? m_diagram : m_changes; }

  /** Calls `visit(facet, piece, source, its piece)` for all pieces. */
  template <class Visit>
  bool forEachPiece(const Visit& visit) const
  {
    const auto facets = static_cast<Offset>(m_changes.facetBegin.size()) - 1;
    return forEachRange(Blocks::cut(facets, 1024, 4096), m_control,
      [&](Offset begin, Offset end)
      {
        for (auto facet = static_cast<Index>(begin); facet < end; ++facet)
        {
          const Diagram& source = this->sourceOf(facet);
          const Index first = source.facetBegin[facet];
          for (Index piece = m_facetBegin[facet]; piece < m_facetBegin[facet + 1]; ++piece)
          {
            visit(facet, piece, source, first + piece - m_facetBegin[facet]);
          }
        }
      });
  }

  Status placeVertices(std::vector<Index>& vertexBegin) const
  {
    vertexBegin.assign(static_cast<std::size_t>(m_facetBegin.back()) + 1, 0);
    const bool done = this->forEachPiece([&](Index, Index piece, const Diagram& source, Index from)
      { vertexBegin[piece + 1] = source.vertexBegin[from + 1] - source.vertexBegin[from]; });
    std::size_t vertices = 0;
    for (const Index size : vertexBegin)
    {
      vertices += static_cast<std::size_t>(size);
    }
    if (Status status = checkNumberOfVertices(vertices); !status.ok())
    {
      return status;
    }
    for (std::size_t piece = 1; piece < vertexBegin.size(); ++piece)
    {
      vertexBegin[piece] += vertexBegin[piece - 1];
    }
    return done ? Status::success() : Status::cancelled();
  }

  template <class Later>
  bool takeVertices(const std::vector<Index>& vertexBegin, const Later& later)
  {
    std::vector<Index> across(static_cast<std::size_t>(vertexBegin.back()));
    const bool done = this->forEachPiece(
      [&](Index facet, Index piece, const Diagram& source, Index from)
      {
        const Index size = vertexBegin[piece + 1] - vertexBegin[piece];
        for (Index v = 0; v < size; ++v)
        {
          across[vertexBegin[piece] + v] =
            later(facet, source.across[source.vertexBegin[from] + v]);
        }
      });
    m_diagram.across = std::move(across);
    m_changes.across = {};
    return done;
  }

  /** One array with a value for each piece. */
  template <class Value, class Later>
  bool takePieces(std::vector<Value> Diagram::*array, const Later& later)
  {
    std::vector<Value> values(static_cast<std::size_t>(m_facetBegin.back()));
    const bool done =
      this->forEachPiece([&](Index facet, Index piece, const Diagram& source, Index from)
        { values[piece] = later(facet, (source.*array)[from]); });
    m_diagram.*array = std::move(values);
    m_changes.*array = std::vector<Value>();
    return done;
  }

  const KeptPieces& m_kept;
  const RunControl& m_control;
  Diagram& m_changes;
  Diagram& m_diagram;
  std::vector<Index> m_facetBegin;
};
}

Status updateDiagram(
  const KeptPieces& kept, Diagram& changes, const RunControl& control, Diagram& diagram)
{
  return Update(kept, changes, control, diagram).run();
}
}
