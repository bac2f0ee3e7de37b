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
  joins.bits.resize(static_cast<std::size_t>(surface.numberOfFacets()));
  const std::vector<char> onBorder = findBorder(surface, joins.edges);
  LowestItems firstFacets(onBorder.size());
  const RunControl silent = control.silent();
  const bool done = forEachItem(surface.numberOfFacets(), silent,
                      [&](Offset facet)
                      {
                        for (const Index corner : surface.facetCorners[facet])
                        {
                          firstFacets.add(static_cast<std::size_t>(corner), facet);
                        }
                      }) &&
    forEachItem(surface.numberOfFacets(), silent,
      [&](Offset facet)
      {
        unsigned bits = 0;
        for (int k = 0; k < 3; ++k)
        {
          const auto corner = static_cast<std::size_t>(surface.facetCorners[facet][k]);
          const bool inner = joins.edges.valence(joins.edges.facetEdges[facet][k]) == 2;
          const bool counts = !onBorder[corner] && firstFacets[corner] == facet;
          bits |= (inner ? 1U : 0U) << k | (counts ? 8U : 0U) << k;
        }
        joins.bits[facet] = static_cast<unsigned char>(bits);
      });
  if (!done)
  {
    joins = FacetJoins{};
  }
  return joins;
}
}
