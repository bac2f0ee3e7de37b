#include "Delaunay/Dual.h"

#include "Mesh/EdgeTable.h"

#include <algorithm>

namespace remesh
{
namespace
{
/** The triangles of all points where three cells meet, as often as they come. */
std::vector<Triple> collectTriangles(const Diagram& diagram, const Components& components)
{
  std::vector<Triple> triangles;
  for (Offset piece = 0; piece < diagram.numberOfPieces(); ++piece)
  {
    const Index site = diagram.sites[piece];
    const Offset begin = diagram.vertexBegin[piece];
    const Offset end = diagram.vertexBegin[piece + 1];
    for (Offset v = begin; v < end; ++v)
    {
      const Index incoming = diagram.vertices[v == begin ? end - 1 : v - 1].across;
      const Index outgoing = diagram.vertices[v].across;
      if (incoming > site && outgoing > site)
      {
        const Index facet = diagram.facets[piece];
        triangles.push_back(
          { components.ofPiece[piece], components.ofPiece[diagram.pieceOf(facet, incoming)],
            components.ofPiece[diagram.pieceOf(facet, outgoing)] });
      }
    }
  }
  return triangles;
}

/**
 * Keeps the first of the triangles on the same three vertices.
 *
 * @return those of which there were more.
 */
std::vector<Triple> removeRepeated(std::vector<Triple>& triangles)
{
  struct Key
  {
    Triple sorted;
    std::size_t position;
    bool operator<(const Key& other) const
    {
      return this->sorted != other.sorted ? this->sorted < other.sorted
                                          : this->position < other.position;
    }
  };
  std::vector<Key> keys(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    keys[t] = { triangles[t], t };
    std::sort(keys[t].sorted.begin(), keys[t].sorted.end());
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Triple> twins;
  std::vector<char> repeated(triangles.size(), 0);
  for (std::size_t k = 1; k < keys.size(); ++k)
  {
    if (keys[k].sorted == keys[k - 1].sorted)
    {
      repeated[keys[k].position] = 1;
      twins.push_back(keys[k].sorted);
    }
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (!repeated[t])
    {
      triangles[kept++] = triangles[t];
    }
  }
  triangles.resize(kept);
  return twins;
}

/** For each vertex, the number of its triangles. */
std::vector<Index> countUses(const std::vector<Triple>& triangles, Index numberOfVertices)
{
  std::vector<Index> uses(static_cast<std::size_t>(numberOfVertices), 0);
  for (const Triple& triangle : triangles)
  {
    for (const Index vertex : triangle)
    {
      ++uses[vertex];
    }
  }
  return uses;
}

/** See Dual::defects. */
std::vector<Index> findDefects(const std::vector<Triple>& triangles,
  const std::vector<Triple>& twins, const EdgeTable& edges, const std::vector<Index>& uses)
{
  const auto lessUsed = [&](Index a, Index b) { return uses[b] < uses[a] ? b : a; };
  std::vector<Index> defects;
  std::vector<std::pair<Index, Index>> hinges; // edges that a repeated triangle makes crowded
  for (const auto& [a, b, c] : twins)
  {
    defects.push_back(lessUsed(lessUsed(a, b), c));
    hinges.insert(hinges.end(), { { a, b }, { b, c }, { a, c } });
  }
  std::sort(hinges.begin(), hinges.end());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::pair<Index, Index> edge = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      if (edges.valence(edges.facetEdges[t][k]) > 2 &&
        !std::binary_search(hinges.begin(), hinges.end(), edge))
      {
        defects.push_back(lessUsed(edge.first, edge.second));
      }
    }
  }
  std::sort(defects.begin(), defects.end());
  defects.erase(std::unique(defects.begin(), defects.end()), defects.end());
  return defects;
}
}

Dual buildDual(const Diagram& diagram, const Components& components)
{
  Dual dual;
  dual.triangles = collectTriangles(diagram, components);
  const std::vector<Triple> twins = removeRepeated(dual.triangles);
  dual.repeated = static_cast<Offset>(twins.size());

  const EdgeTable edges = buildEdgeTable(dual.triangles);
  const std::vector<Index> uses = countUses(dual.triangles, components.count());
  dual.defects = findDefects(dual.triangles, twins, edges, uses);
  for (Index edge = 0; edge < edges.numberOfEdges(); ++edge)
  {
    dual.numberOfNonManifoldEdges += edges.valence(edge) > 2;
  }
  const auto used = static_cast<Offset>(uses.size()) - std::count(uses.begin(), uses.end(), 0);
  dual.eulerCharacteristic =
    used - edges.numberOfEdges() + static_cast<Offset>(dual.triangles.size());
  return dual;
}

std::vector<Index> countNeighbors(const Diagram& diagram, Index numberOfSites)
{
  std::vector<std::pair<Index, Index>> pairs;
  for (Offset piece = 0; piece < diagram.numberOfPieces(); ++piece)
  {
    for (Offset v = diagram.vertexBegin[piece]; v < diagram.vertexBegin[piece + 1]; ++v)
    {
      if (diagram.vertices[v].across > diagram.sites[piece])
      {
        pairs.emplace_back(diagram.sites[piece], diagram.vertices[v].across);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<Index> counts(static_cast<std::size_t>(numberOfSites), 0);
  for (const auto& [a, b] : pairs)
  {
    ++counts[a];
    ++counts[b];
  }
  return counts;
}
}
