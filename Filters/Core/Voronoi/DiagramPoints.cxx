/**
 * @file DiagramPoints.cxx
 *
 * A vertex in a facet is shared by pieces of that facet alone, one on an edge by pieces of the
 * facets around it: points are numbered place by place.
 * 1. Corners: the point of a corner has the corner's number.
 * 2. Edges, then facets, in blocks: collect the vertices there, sort them by the sites that meet,
 *    and number the different ones within the block.
 * 3. Scan the blocks' numbers of points, add each block's first number, and write the points.
 */
#include "Voronoi/DiagramPoints.h"

#include "Support/Grouping.h"

#include <algorithm>

namespace remesh
{
namespace
{
/** What tells a vertex from the others at its place: the sites that meet there, ascending. */
struct VertexKey
{
  Triple sites; ///< noIndex first on an edge
  Offset vertex;
  Offset piece;

  bool operator<(const VertexKey& other) const
  {
    return this->sites != other.sites ? this->sites < other.sites : this->vertex < other.vertex;
  }
};

/** Calls `visit(piece, vertex, incoming, outgoing)` for the vertices of a facet's pieces. */
template <class Visit>
void forEachVertex(const Diagram& diagram, Index facet, const Visit& visit)
{
  for (Offset piece = diagram.facetBegin[facet]; piece < diagram.facetBegin[facet + 1]; ++piece)
  {
    const Offset end = diagram.vertexBegin[piece + 1];
    Index incoming = diagram.across[end - 1];
    for (Offset v = diagram.vertexBegin[piece]; v < end; ++v)
    {
      const Index outgoing = diagram.across[v];
      visit(piece, v, incoming, outgoing);
      incoming = outgoing;
    }
  }
}

/** The vertices inside a facet. */
void collectInside(const Diagram& diagram, Index facet, std::vector<VertexKey>& keys)
{
  forEachVertex(diagram, facet,
    [&](Offset piece, Offset v, Index incoming, Index outgoing)
    {
      if (incoming >= 0 && outgoing >= 0)
      {
        VertexKey key{ { diagram.sites[piece], incoming, outgoing }, v, piece };
        std::sort(key.sites.begin(), key.sites.end());
        keys.push_back(key);
      }
    });
}

/** The vertices on an edge but its ends, in all facets around it. */
void collectOnEdge(
  const EdgeTable& edges, const Diagram& diagram, Index edge, std::vector<VertexKey>& keys)
{
  for (Offset k = edges.edgeFacetsBegin[edge]; k < edges.edgeFacetsBegin[edge + 1]; ++k)
  {
    const Index facet = edges.edgeFacets[k];
    forEachVertex(diagram, facet,
      [&](Offset piece, Offset v, Index incoming, Index outgoing)
      {
        const Index side = std::min(incoming, outgoing);
        const Index other = std::max(incoming, outgoing);
        if (side < 0 && other >= 0 && edges.facetEdges[facet][-1 - side] == edge)
        {
          const auto [lower, upper] = std::minmax(diagram.sites[piece], other);
          keys.push_back({ { noIndex, lower, upper }, v, piece });
        }
      });
  }
}

/** Numbers the points of one place after `firsts`, and appends the first vertex of each. */
void numberPlace(
  std::vector<VertexKey>& keys, std::vector<Offset>& ofVertex, std::vector<VertexKey>& firsts)
{
  std::sort(keys.begin(), keys.end());
  for (std::size_t k = 0; k < keys.size(); ++k)
  {
    if (k == 0 || keys[k].sites != keys[k - 1].sites)
    {
      firsts.push_back(keys[k]);
    }
    ofVertex[keys[k].vertex] = static_cast<Offset>(firsts.size()) - 1;
  }
}

/** The point at a vertex. */
DiagramPoint pointAt(const VertexPlaces& places, Offset piece, Offset vertex)
{
  const auto [b0, b1, b2] = places.at(piece, vertex);
  return { places.diagram.facets[piece], { b0, b1, b2 } };
}

/** Steps 2 and 3 for places [0, count), whose vertices are collected by `collect(place, keys)`. */
template <class Collect>
bool numberPlaces(const VertexPlaces& places, Index count, const RunControl& control,
  const Collect& collect, DiagramPoints& result)
{
  const Blocks blocks = Blocks::cut(count, 256, 1 << 16);
  std::vector<std::vector<VertexKey>> firsts(static_cast<std::size_t>(blocks.count()));
  const auto forEachPlace = [&](const auto& visit)
  {
    return forEachBlock(blocks.count(), control,
      [&](Offset block)
      {
        std::vector<VertexKey> keys;
        for (Offset place = blocks.begin(block); place < blocks.end(block); ++place)
        {
          keys.clear();
          collect(static_cast<Index>(place), keys);
          visit(block, keys);
        }
      });
  };
  if (!forEachPlace([&](Offset block, std::vector<VertexKey>& keys)
        { numberPlace(keys, result.ofVertex, firsts[block]); }))
  {
    return false;
  }
  std::vector<Offset> begins(firsts.size());
  std::transform(firsts.begin(), firsts.end(), begins.begin(),
    [](const std::vector<VertexKey>& points) { return static_cast<Offset>(points.size()); });
  const auto before = static_cast<Offset>(result.points.size());
  result.points.resize(static_cast<std::size_t>(before + scanCounts(begins)));
  const auto addBegin = [&](Offset block, const std::vector<VertexKey>& keys)
  {
    for (const VertexKey& key : keys)
    {
      result.ofVertex[key.vertex] += before + begins[block];
    }
  };
  const auto writePoints = [&](Offset block)
  {
    std::transform(firsts[block].begin(), firsts[block].end(),
      result.points.begin() + before + begins[block],
      [&](const VertexKey& first) { return pointAt(places, first.piece, first.vertex); });
  };
  return forEachPlace(addBegin) && forEachBlock(blocks.count(), control, writePoints);
}

/** Step 1. */
bool numberCorners(const SurfaceMesh& mesh, const VertexPlaces& places, const RunControl& control,
  DiagramPoints& result)
{
  LowestItems firsts(mesh.cornerPoints.size());
  const auto forEachCorner = [&](Offset facet, const auto& visit)
  {
    forEachVertex(places.diagram, static_cast<Index>(facet),
      [&](Offset piece, Offset v, Index incoming, Index outgoing)
      {
        if (incoming < 0 && outgoing < 0) // where the facet's edge -1 - outgoing starts
        {
          visit(mesh.facetCorners[facet][-1 - outgoing], piece, v);
        }
      });
  };
  result.points.resize(mesh.cornerPoints.size());
  return forEachItem(mesh.numberOfFacets(), control,
           [&](Offset facet)
           {
             forEachCorner(facet,
               [&](Index corner, Offset, Offset v)
               {
                 result.ofVertex[v] = corner;
                 firsts.add(corner, v);
               });
           }) &&
    forEachItem(mesh.numberOfFacets(), control,
      [&](Offset facet)
      {
        forEachCorner(facet,
          [&](Index corner, Offset piece, Offset v)
          {
            if (firsts[corner] == v)
            {
              result.points[corner] = pointAt(places, piece, v);
            }
          });
      });
}
}

Status numberDiagramPoints(const SurfaceMesh& mesh, const EdgeTable& edges,
  const VertexPlaces& places, const RunControl& control, DiagramPoints& result)
{
  const Diagram& diagram = places.diagram;
  result = DiagramPoints{};
  result.ofVertex.resize(diagram.across.size());
  const RunControl silent = control.silent();
  const bool done = numberCorners(mesh, places, silent, result) &&
    numberPlaces(
      places, edges.numberOfEdges(), silent,
      [&](Index edge, std::vector<VertexKey>& keys) { collectOnEdge(edges, diagram, edge, keys); },
      result) &&
    numberPlaces(
      places, mesh.numberOfFacets(), silent,
      [&](Index facet, std::vector<VertexKey>& keys) { collectInside(diagram, facet, keys); },
      result);
  return done ? Status::success() : Status::cancelled();
}
}
