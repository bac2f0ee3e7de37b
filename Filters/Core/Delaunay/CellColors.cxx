#include "Delaunay/CellColors.h"

#include "Support/SortUnique.h"

#include <algorithm>
#include <utility>

namespace remesh
{
namespace
{
/** Vertices by the number of their neighbours that are left (step 1). */
class DegreeQueue
{
public:
  explicit DegreeQueue(const Groups& neighbors)
    : m_degrees(neighbors.begins.size() - 1)
  {
    for (std::size_t v = 0; v < m_degrees.size(); ++v)
    {
      m_degrees[v] = neighbors.begins[v + 1] - neighbors.begins[v];
      this->put(static_cast<Index>(v));
    }
  }

  bool isTaken(Index vertex) const { return m_degrees[vertex] == taken; }

  /** One with the fewest neighbours left: of those the one that was put last. */
  Index take()
  {
    for (std::size_t degree = m_least;; ++degree)
    {
      std::vector<Index>& vertices = m_buckets[degree];
      while (!vertices.empty())
      {
        const Index vertex = vertices.back();
        vertices.pop_back();
        if (m_degrees[vertex] == static_cast<Offset>(degree)) // else it was put elsewhere since
        {
          m_degrees[vertex] = taken;
          m_least = degree;
          return vertex;
        }
      }
    }
  }

  void loseNeighbor(Index vertex)
  {
    --m_degrees[vertex];
    this->put(vertex);
  }

private:
  static constexpr Offset taken = -1;

  void put(Index vertex)
  {
    const auto degree = static_cast<std::size_t>(m_degrees[vertex]);
    if (degree >= m_buckets.size())
    {
      m_buckets.resize(degree + 1);
    }
    m_buckets[degree].push_back(vertex);
    m_least = std::min(m_least, degree);
  }

  std::vector<Offset> m_degrees;
  std::vector<std::vector<Index>> m_buckets;
  std::size_t m_least = 0;
};

/** The vertices in the order in which they are taken away. */
std::vector<Index> smallestFirst(const Groups& neighbors)
{
  DegreeQueue queue(neighbors);
  std::vector<Index> order(neighbors.begins.size() - 1);
  for (Index& next : order)
  {
    next = queue.take();
    for (Offset k = neighbors.begins[next]; k < neighbors.begins[next + 1]; ++k)
    {
      if (const Index other = neighbors.items[k]; !queue.isTaken(other))
      {
        queue.loseNeighbor(other);
      }
    }
  }
  return order;
}

using Pair = std::pair<Index, Index>;

/** Each pair of different vertices once, the lower first, ascending. */
template <class VertexOf>
std::vector<Pair> findPairs(
  const Diagram& diagram, const Components& components, const Dual& dual, const VertexOf& vertexOf)
{
  std::vector<Pair> pairs;
  pairs.reserve(3 * dual.triangles.size());
  const auto join = [&](Index site, Index other)
  {
    const Pair pair = std::minmax({ vertexOf(site), vertexOf(other) });
    if (pair.first != pair.second)
    {
      pairs.push_back(pair);
    }
  };
  for (Offset piece = 0; piece < diagram.numberOfPieces(); ++piece)
  {
    const Index site = diagram.sites[piece];
    for (Offset v = diagram.vertexBegin[piece]; v < diagram.vertexBegin[piece + 1]; ++v)
    {
      if (diagram.across[v] > site) // seen from one side
      {
        join(site, diagram.across[v]);
      }
    }
  }
  for (const Triple& triangle : dual.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      join(components.sites[triangle[k]], components.sites[triangle[(k + 1) % 3]]);
    }
  }
  sortUnique(pairs);
  return pairs;
}

/** From each pair both ways. */
Groups groupPairs(const std::vector<Pair>& pairs, Index numberOfVertices)
{
  Groups neighbors;
  std::vector<Offset> places(static_cast<std::size_t>(numberOfVertices) + 1, 0);
  for (const auto& [a, b] : pairs)
  {
    ++places[a];
    ++places[b];
  }
  scanCounts(places);
  neighbors.begins = places;
  neighbors.items.resize(2 * pairs.size());
  for (const auto& [a, b] : pairs)
  {
    neighbors.items[places[a]++] = b;
    neighbors.items[places[b]++] = a;
  }
  return neighbors;
}
}

std::vector<int> colorGraph(const Groups& neighbors)
{
  const std::vector<Index> order = smallestFirst(neighbors);
  std::vector<int> colors(order.size(), -1);
  std::vector<Offset> uses;   // of each colour
  std::vector<Index> usedFor; // the last vertex that has a neighbour of the colour
  for (auto vertex = order.rbegin(); vertex != order.rend(); ++vertex)
  {
    for (Offset k = neighbors.begins[*vertex]; k < neighbors.begins[*vertex + 1]; ++k)
    {
      if (const int color = colors[neighbors.items[k]]; color >= 0)
      {
        usedFor[color] = *vertex;
      }
    }
    int best = -1;
    for (std::size_t color = 0; color < uses.size(); ++color)
    {
      if (usedFor[color] != *vertex && (best < 0 || uses[color] < uses[best]))
      {
        best = static_cast<int>(color);
      }
    }
    if (best < 0)
    {
      best = static_cast<int>(uses.size());
      uses.push_back(0);
      usedFor.push_back(noIndex);
    }
    ++uses[best];
    colors[*vertex] = best;
  }
  return colors;
}

std::vector<int> colorCells(const Diagram& diagram, const Components& components, const Dual& dual,
  Index numberOfSites, const FeatureSites* features)
{
  const auto vertexOf = [&](Index site) { return features ? features->mergedSite(site) : site; };
  std::vector<int> colors =
    colorGraph(groupPairs(findPairs(diagram, components, dual, vertexOf), numberOfSites));
  for (Index site = 0; site < numberOfSites; ++site)
  {
    colors[site] = colors[vertexOf(site)];
  }
  return colors;
}
}
