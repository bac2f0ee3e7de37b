/**
 * @file DiagramUpdate.cxx
 *
 * Runs of facets that keep their pieces move as a whole, to where they are among the others': those
 * that move back from the last on, those that move forth from the first on. So no run is written
 * over before it has moved, whatever the changes are.
 */
#include "Voronoi/DiagramUpdate.h"

#include "Support/Parallel.h"
#include "Voronoi/DiagramBlocks.h"

#include <algorithm>
#include <utility>

namespace remesh
{
namespace
{
/** Values that stay together. */
struct Run
{
  Index from;
  Index to;
  Index count;
};

/** @param runs ascending; of all values that are kept. */
template <class Value>
void moveRuns(const std::vector<Run>& runs, std::size_t size, std::vector<Value>& values)
{
  values.resize(std::max(values.size(), size));
  const auto begin = values.begin();
  for (auto run = runs.rbegin(); run != runs.rend(); ++run)
  {
    if (run->to > run->from)
    {
      std::copy_backward(
        begin + run->from, begin + run->from + run->count, begin + run->to + run->count);
    }
  }
  for (const Run& run : runs)
  {
    if (run.to < run.from)
    {
      std::copy(begin + run.from, begin + run.from + run.count, begin + run.to);
    }
  }
  values.resize(size);
}

class Update
{
public:
  Update(const KeptPieces& kept, Diagram& changes, const RunControl& control, Diagram& diagram)
    : m_kept(kept)
    , m_control(control)
    , m_changes(changes)
    , m_diagram(diagram)
    , m_facets(static_cast<Index>(changes.facetBegin.size()) - 1)
  {
  }

  Status run()
  {
    if (Status status = this->findPlaces(); !status.ok())
    {
      return status;
    }
    this->findRuns();
    m_diagram.vertexBegin.swap(m_vertexBegin);
    m_diagram.facetBegin.swap(m_facetBegin);
    this->take(&Diagram::weights, m_pieceRuns);
    this->take(&Diagram::energies, m_pieceRuns);
    this->take(&Diagram::facets, m_pieceRuns);
    this->take(&Diagram::sites, m_pieceRuns);
    this->take(&Diagram::across, m_vertexRuns);
    m_changes = Diagram{};
    return this->renumber() ? Status::success() : Status::cancelled();
  }

private:
  /** Where the pieces of each facet, and their vertices, are afterwards. */
  Status findPlaces()
  {
    m_facetBegin.assign(static_cast<std::size_t>(m_facets) + 1, 0);
    std::size_t vertices = 0;
    for (Index facet = 0; facet < m_facets; ++facet)
    {
      const Diagram& source = m_kept.keeps(facet) ? m_diagram : m_changes;
      const Index first = source.facetBegin[facet];
      const Index last = source.facetBegin[facet + 1];
      m_facetBegin[facet + 1] = m_facetBegin[facet] + last - first;
      vertices += static_cast<std::size_t>(source.vertexBegin[last] - source.vertexBegin[first]);
    }
    if (Status status = checkNumberOfVertices(vertices); !status.ok())
    {
      return status;
    }
    m_vertexBegin.reserve(static_cast<std::size_t>(m_facetBegin.back()) + 1);
    m_vertexBegin.push_back(0);
    for (Index facet = 0; facet < m_facets; ++facet)
    {
      const Diagram& source = m_kept.keeps(facet) ? m_diagram : m_changes;
      for (Index p = source.facetBegin[facet]; p < source.facetBegin[facet + 1]; ++p)
      {
        m_vertexBegin.push_back(
          m_vertexBegin.back() + source.vertexBegin[p + 1] - source.vertexBegin[p]);
      }
    }
    return Status::success();
  }

  void findRuns()
  {
    for (Index facet = 0; facet < m_facets; ++facet)
    {
      const Index first = facet;
      while (facet < m_facets && m_kept.keeps(facet))
      {
        ++facet;
      }
      if (facet > first)
      {
        const Index from = m_diagram.facetBegin[first];
        const Index end = m_diagram.facetBegin[facet];
        const Index to = m_facetBegin[first];
        m_pieceRuns.push_back({ from, to, end - from });
        m_vertexRuns.push_back({ m_diagram.vertexBegin[from], m_vertexBegin[to],
          m_diagram.vertexBegin[end] - m_diagram.vertexBegin[from] });
      }
    }
  }

  /** One array; what is not in the runs comes from the changes, in the same order. */
  template <class Value>
  void take(std::vector<Value> Diagram::*array, const std::vector<Run>& runs)
  {
    std::vector<Value>& values = m_diagram.*array;
    std::vector<Value>& changes = m_changes.*array;
    Offset kept = 0;
    for (const Run& run : runs)
    {
      kept += run.count;
    }
    moveRuns(runs, static_cast<std::size_t>(kept) + changes.size(), values);
    auto next = changes.begin();
    Offset at = 0;
    for (const Run& run : runs)
    {
      std::copy(next, next + (run.to - at), values.begin() + at);
      next += run.to - at;
      at = Offset(run.to) + run.count;
    }
    std::copy(next, changes.end(), values.begin() + at);
    changes = std::vector<Value>();
  }

  /** Sites by their later ids; those of the changes have theirs. */
  bool renumber()
  {
    const std::vector<Index>& later = m_kept.later();
    return forEachRange(Blocks::cut(m_facets, 1024, 4096), m_control,
      [&](Offset begin, Offset end)
      {
        for (auto facet = static_cast<Index>(begin); facet < end; ++facet)
        {
          const Index first = m_diagram.facetBegin[facet];
          const Index last = m_kept.keeps(facet) ? m_diagram.facetBegin[facet + 1] : first;
          for (Index p = first; p < last; ++p)
          {
            m_diagram.sites[p] = later[m_diagram.sites[p]];
          }
          for (Index v = m_diagram.vertexBegin[first]; v < m_diagram.vertexBegin[last]; ++v)
          {
            const Index across = m_diagram.across[v];
            m_diagram.across[v] = across < 0 ? across : later[across];
          }
        }
      });
  }

  const KeptPieces& m_kept;
  const RunControl& m_control;
  Diagram& m_changes;
  Diagram& m_diagram;
  Index m_facets;
  std::vector<Index> m_facetBegin;
  std::vector<Index> m_vertexBegin;
  std::vector<Run> m_pieceRuns;
  std::vector<Run> m_vertexRuns;
};
}

Status updateDiagram(
  const KeptPieces& kept, Diagram& changes, const RunControl& control, Diagram& diagram)
{
  return Update(kept, changes, control, diagram).run();
}
}
