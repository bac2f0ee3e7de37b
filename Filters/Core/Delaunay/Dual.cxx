#include "Delaunay/Dual.h"

#include "Mesh/EdgeTable.h"

#include <algorithm>
#include <numeric>

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
        triangles.push_back({ components.ofPiece[piece],
          components.ofPiece[diagram.pieceOf(facet, incoming)],
          components.ofPiece[diagram.pieceOf(facet, outgoing)] });
      }
    }
  }
  return triangles;
}

/** Keeps the first of the triangles on the same three vertices; returns how many went. */
Offset removeRepeated(std::vector<Triple>& triangles)
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
  std::vector<char> repeated(triangles.size(), 0);
  for (std::size_t k = 1; k < keys.size(); ++k)
  {
    repeated[keys[k].position] = keys[k].sorted == keys[k - 1].sorted;
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (!repeated[t])
    {
      triangles[kept++] = triangles[t];
    }
  }
  const auto removed = static_cast<Offset>(triangles.size() - kept);
  triangles.resize(kept);
  return removed;
}
}

Dual buildDual(const Diagram& diagram, const Components& components)
{
  Dual dual;
  dual.triangles = collectTriangles(diagram, components);
  dual.repeated = removeRepeated(dual.triangles);

  const EdgeTable edges = buildEdgeTable(dual.triangles);
  std::vector<char> used(static_cast<std::size_t>(components.count()), 0);
  for (const Triple& triangle : dual.triangles)
  {
    for (const Index vertex : triangle)
    {
      used[vertex] = 1;
    }
  }
  for (Index edge = 0; edge < edges.numberOfEdges(); ++edge)
  {
    dual.numberOfNonManifoldEdges += edges.valence(edge) > 2;
  }
  dual.eulerCharacteristic = std::count(used.begin(), used.end(), char{ 1 }) -
    edges.numberOfEdges() + static_cast<Offset>(dual.triangles.size());
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
