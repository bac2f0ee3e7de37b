#include "Voronoi/DiagramPoints.h"

#include <algorithm>
#include <array>

namespace remesh
{
namespace
{
/**
 * What tells a vertex from all others: its place (edge or facet) and the sites that meet there,
 * ascending; a crossing on an edge has noIndex first.
 */
struct VertexKey
{
  Index place;
  Triple sites;
  Offset vertex;

  bool sameAs(const VertexKey& other) const
  {
    return this->place == other.place && this->sites == other.sites;
  }
  bool operator<(const VertexKey& other) const
  {
    return this->place != other.place ? this->place < other.place
      : this->sites != other.sites    ? this->sites < other.sites
                                      : this->vertex < other.vertex;
  }
};

/** Gives one point to each run of equal keys, with the place of the first vertex of the run. */
void numberKeys(std::vector<VertexKey>& keys, const Diagram& diagram,
  const std::vector<Index>& facetOfVertex, DiagramPoints& result)
{
  std::sort(keys.begin(), keys.end());
  for (std::size_t k = 0; k < keys.size(); ++k)
  {
    const Offset vertex = keys[k].vertex;
    if (k == 0 || !keys[k].sameAs(keys[k - 1]))
    {
      const double* b = diagram.vertices[vertex].b;
      result.points.push_back({ facetOfVertex[vertex], { b[0], b[1], b[2] } });
    }
    result.ofVertex[vertex] = static_cast<Offset>(result.points.size()) - 1;
  }
}
}

DiagramPoints numberDiagramPoints(
  const SurfaceMesh& mesh, const EdgeTable& edges, const Diagram& diagram)
{
  DiagramPoints result;
  result.ofVertex.resize(diagram.vertices.size());
  result.points.resize(mesh.cornerPoints.size());
  std::vector<Index> facetOfVertex(diagram.vertices.size());
  std::vector<VertexKey> onEdges;
  std::vector<VertexKey> inFacets;
  for (Offset piece = 0; piece < diagram.numberOfPieces(); ++piece)
  {
    const Index facet = diagram.facets[piece];
    const Index site = diagram.sites[piece];
    const Offset begin = diagram.vertexBegin[piece];
    const Offset end = diagram.vertexBegin[piece + 1];
    for (Offset v = begin; v < end; ++v)
    {
      facetOfVertex[v] = facet;
      const DiagramVertex& vertex = diagram.vertices[v];
      const Index incoming = diagram.vertices[v == begin ? end - 1 : v - 1].across;
      const Index outgoing = vertex.across;
      if (incoming < 0 && outgoing < 0)
      {
        const int k = -1 - outgoing; // the corner where the facet's edge k starts
        const Index corner = mesh.facetCorners[facet][k];
        result.points[corner] = { facet, { vertex.b[0], vertex.b[1], vertex.b[2] } };
        result.ofVertex[v] = corner;
      }
      else if (incoming < 0 || outgoing < 0)
      {
        const Index other = std::max(incoming, outgoing);
        const int k = -1 - std::min(incoming, outgoing);
        onEdges.push_back({ edges.facetEdges[facet][k],
          { noIndex, std::min(site, other), std::max(site, other) }, v });
      }
      else
      {
        VertexKey key{ facet, { site, incoming, outgoing }, v };
        std::sort(key.sites.begin(), key.sites.end());
        inFacets.push_back(key);
      }
    }
  }
  numberKeys(onEdges, diagram, facetOfVertex, result);
  numberKeys(inFacets, diagram, facetOfVertex, result);
  return result;
}
}
