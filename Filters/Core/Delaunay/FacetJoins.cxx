#include "Delaunay/FacetJoins.h"

#include "Support/Grouping.h"

#include <utility>

namespace remesh
{
namespace
{
/** C: whether each corner is on an edge of one facet. */
std::vector<char> findBorder(const EmbeddedSurface& surface, const EdgeTable& edges)
{
  std::vector<char> onBorder(static_cast<std::size_t>(surface.numberOfCorners()), 0);
  for (Index edge = 0; edge < edges.numberOfEdges(); ++edge)
  {
    if (edges.valence(edge) == 1)
    {
      const Index facet = edges.edgeFacets[edges.edgeFacetsBegin[edge]];
      const int k = edges.sideOf(facet, edge);
      onBorder[surface.facetCorners[facet][k]] = 1;
      onBorder[surface.facetCorners[facet][(k + 1) % 3]] = 1;
    }
  }
  return onBorder;
}
}

FacetJoins joinFacets(const EmbeddedSurface& surface, EdgeTable edges, const RunControl& control)
{
  FacetJoins joins;
  joins.edges = std::move(edges);
  joins.firstFacets.resize(static_cast<std::size_t>(surface.numberOfCorners()));
  joins.bits.resize(static_cast<std::size_t>(surface.numberOfFacets()));
  const std::vector<char> onBorder = findBorder(surface, joins.edges);
  LowestItems first(joins.firstFacets.size());
  const RunControl silent = control.silent();
  forEachItem(surface.numberOfFacets(), silent,
    [&](Offset facet)
    {
      for (const Index corner : surface.facetCorners[facet])
      {
        first.add(static_cast<std::size_t>(corner), facet);
      }
    }) &&
    forEachItem(surface.numberOfCorners(), silent,
      [&](Offset corner)
      {
        const auto key = static_cast<std::size_t>(corner);
        joins.firstFacets[key] = first.has(key) ? static_cast<Index>(first[key]) : noIndex;
      }) &&
    forEachItem(surface.numberOfFacets(), silent,
      [&](Offset facet)
      {
        unsigned bits = 0;
        for (int k = 0; k < 3; ++k)
        {
          const Index corner = surface.facetCorners[facet][k];
          const bool inner = joins.edges.valence(joins.edges.facetEdges[facet][k]) == 2;
          const bool counts = !onBorder[corner] && joins.firstFacets[corner] == facet;
          bits |= (inner ? 1U : 0U) << k | (counts ? 8U : 0U) << k;
        }
        joins.bits[facet] = static_cast<unsigned char>(bits);
      });
  return joins;
}
}
