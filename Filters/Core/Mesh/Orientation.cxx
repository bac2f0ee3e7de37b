/**
 * @file Orientation.cxx
 *
 * For each facet not yet visited, in order:
 * 1. Collect its shell breadth first through manifold edges, and note for each facet whether it
 *    must be turned to agree with the first. Two facets agree if they run along their common edge
 *    in opposite directions. A visited neighbour that disagrees makes the shell one-sided.
 * 2. A one-sided shell turns nothing. Else, if more area would be turned than kept, turn the rest.
 */
#include "Mesh/Orientation.h"

#include "Support/Grouping.h"

#include <algorithm>

namespace remesh
{
namespace
{
/** Whether a facet runs along its edge from the lower point to the higher. */
bool ascends(const std::vector<Triple>& facetPoints, Index facet, int side)
{
  return facetPoints[facet][side] < facetPoints[facet][(side + 1) % 3];
}

int sideOf(const EdgeTable& edges, Index facet, Index edge)
{
  const Triple& sides = edges.facetEdges[facet];
  return sides[0] == edge ? 0 : (sides[1] == edge ? 1 : 2);
}

class ShellWalker
{
public:
  ShellWalker(const std::vector<Triple>& facetPoints, const EdgeTable& edges)
    : m_facetPoints(facetPoints)
    , m_edges(edges)
    , m_visited(facetPoints.size(), 0)
    , m_flipped(facetPoints.size(), 0)
  {
  }

  bool visited(Index facet) const { return m_visited[facet] != 0; }
  const std::vector<Index>& shell() const { return m_shell; }
  std::vector<unsigned char>& flipped() { return m_flipped; }

  /** Fills `shell` with the shell of this facet; false if it is one-sided. */
  bool walk(Index first)
  {
    m_shell.assign(1, first);
    m_visited[first] = 1;
    bool consistent = true;
    std::size_t next = 0;
    while (next < m_shell.size()) // which grows
    {
      const Index facet = m_shell[next++];
      for (int k = 0; k < 3; ++k)
      {
        consistent &= this->cross(facet, k);
      }
    }
    return consistent;
  }

private:
  /** Visits the neighbour across an edge; false if it was visited and disagrees. */
  bool cross(Index facet, int side)
  {
    const Index edge = m_edges.facetEdges[facet][side];
    if (m_edges.valence(edge) != 2)
    {
      return true;
    }
    const Offset begin = m_edges.edgeFacetsBegin[edge];
    const Index left = m_edges.edgeFacets[begin];
    const Index neighbour = left == facet ? m_edges.edgeFacets[begin + 1] : left;
    const bool sameDirection = ascends(m_facetPoints, facet, side) ==
      ascends(m_facetPoints, neighbour, sideOf(m_edges, neighbour, edge));
    const unsigned char wanted = m_flipped[facet] ^ static_cast<unsigned char>(sameDirection);
    if (m_visited[neighbour])
    {
      return m_flipped[neighbour] == wanted;
    }
    m_visited[neighbour] = 1;
    m_flipped[neighbour] = wanted;
    m_shell.push_back(neighbour);
    return true;
  }

  const std::vector<Triple>& m_facetPoints;
  const EdgeTable& m_edges;
  std::vector<unsigned char> m_visited;
  std::vector<unsigned char> m_flipped;
  std::vector<Index> m_shell;
};

/** Whether the flipped facets of a shell have the larger share of its area. */
bool mostIsFlipped(const std::vector<Index>& shell, const std::vector<unsigned char>& flipped,
  const std::vector<double>& areas)
{
  constexpr double tie = 1e-12; // well above the rounding of the sums
  double kept = 0.0;
  double turned = 0.0;
  for (const Index facet : shell)
  {
    (flipped[facet] ? turned : kept) += areas[facet];
  }
  return turned > kept * (1.0 + tie);
}
}

bool isOriented(
  const std::vector<Triple>& facetPoints, const EdgeTable& edges, const RunControl& control)
{
  return countItems(edges.numberOfEdges(), control.silent(),
           [&](Offset k)
           {
             const auto edge = static_cast<Index>(k);
             if (edges.valence(edge) != 2)
             {
               return false;
             }
             const Index* facets = edges.edgeFacets.data() + edges.edgeFacetsBegin[edge];
             return ascends(facetPoints, facets[0], sideOf(edges, facets[0], edge)) ==
               ascends(facetPoints, facets[1], sideOf(edges, facets[1], edge));
           }) == 0;
}

Orientation findOrientation(const std::vector<Triple>& facetPoints, const EdgeTable& edges,
  const std::vector<double>& facetAreas)
{
  Orientation result;
  ShellWalker walker(facetPoints, edges);
  std::vector<unsigned char>& flipped = walker.flipped();
  for (std::size_t first = 0; first < facetPoints.size(); ++first)
  {
    if (walker.visited(static_cast<Index>(first)))
    {
      continue;
    }
    const bool twoSided = walker.walk(static_cast<Index>(first));
    result.orientable &= twoSided;
    const unsigned char keep = twoSided ? 1 : 0;
    const unsigned char turn = twoSided && mostIsFlipped(walker.shell(), flipped, facetAreas);
    for (const Index facet : walker.shell())
    {
      flipped[facet] = (flipped[facet] & keep) ^ turn;
      result.numberOfFlipped += flipped[facet];
    }
  }
  result.flipped.swap(flipped);
  return result;
}
}
