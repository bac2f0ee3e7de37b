/**
 * @file TestDuals.h
 * @brief The dual of a diagram, and the topology of a list of triangles by definition.
 */
#ifndef remesh_TestDuals_h
#define remesh_TestDuals_h

#include "Delaunay/Dual.h"
#include "Delaunay/FacetJoins.h"
#include "TestDiagrams.h"

#include <set>

namespace remesh::test
{
struct DualOf
{
  FacetJoins joins;
  Components components;
  Dual dual;

  Point3 vertex(Index component) const { return this->components.centroids[component]; }
};

inline DualOf dualOf(
  const SurfaceMesh& mesh, const EmbeddedSurface& surface, const Computed& result)
{
  DualOf made;
  made.joins = joinFacets(surface, buildEdgeTable(mesh.facetPoints), RunControl());
  CHECK(findComponents(
    { mesh, { surface, result.sites, result.diagram }, made.joins.edges, result.owners },
    RunControl(), made.components)
          .ok());
  CHECK(buildDual(result.diagram, made.components, RunControl(), made.dual).ok());
  return made;
}

struct Shape
{
  int borderEdges = 0;    ///< one triangle
  int crowdedEdges = 0;   ///< three triangles or more
  int twistedEdges = 0;   ///< two triangles that go the same way
  int brokenVertices = 0; ///< triangles around it are neither one closed nor one open fan
  int pieces = 0;         ///< connected through vertices
  int vertices = 0;

  bool isManifold() const
  {
    return this->crowdedEdges == 0 && this->twistedEdges == 0 && this->brokenVertices == 0;
  }
};

/** Whether the edges opposite to a vertex form one path or one loop. */
inline bool isFan(const std::vector<std::pair<Index, Index>>& link)
{
  std::map<Index, Index> next;
  std::set<Index> ends;
  for (const auto& [a, b] : link)
  {
    if (!next.emplace(a, b).second || !ends.insert(b).second)
    {
      return false;
    }
  }
  Index start = link.front().first;
  for (const auto& [a, b] : link)
  {
    start = ends.count(a) ? start : a;
  }
  std::size_t steps = 0;
  Index at = start;
  while (steps < link.size() && next.count(at))
  {
    at = next[at];
    ++steps;
    if (at == start)
    {
      break;
    }
  }
  return steps == link.size();
}

inline Shape shapeOf(const std::vector<Triple>& triangles)
{
  std::map<std::pair<Index, Index>, std::pair<int, int>> edges; // upward and downward
  std::map<Index, std::vector<std::pair<Index, Index>>> links;
  std::map<Index, Index> parents;
  const auto find = [&](Index vertex)
  {
    parents.emplace(vertex, vertex);
    while (parents[vertex] != vertex)
    {
      vertex = parents[vertex];
    }
    return vertex;
  };
  for (const Triple& triangle : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index a = triangle[k];
      const Index b = triangle[(k + 1) % 3];
      auto& [up, down] = edges[std::minmax(a, b)];
      ++(a < b ? up : down);
      links[a].emplace_back(b, triangle[(k + 2) % 3]);
      parents[find(a)] = find(b);
    }
  }
  Shape shape;
  shape.vertices = static_cast<int>(links.size());
  for (const auto& [ends, uses] : edges)
  {
    shape.borderEdges += uses.first + uses.second == 1;
    shape.crowdedEdges += uses.first + uses.second > 2;
    shape.twistedEdges += uses.first == 2 || uses.second == 2;
  }
  for (const auto& [vertex, link] : links)
  {
    shape.brokenVertices += !isFan(link);
    shape.pieces += find(vertex) == vertex;
  }
  return shape;
}

/** Positive if closed triangles face outward. */
inline double enclosedVolume(const DualOf& dual)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : dual.dual.triangles)
  {
    sum += dual.vertex(a).dot(dual.vertex(b).cross(dual.vertex(c))) / 6.0;
  }
  return sum;
}
}

#endif
