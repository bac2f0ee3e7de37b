/**
 * @file EdgeTable.h
 * @brief The undirected topological edges of a surface and the facets around each.
 */
#ifndef remesh_EdgeTable_h
#define remesh_EdgeTable_h

#include "Mesh/SurfaceMesh.h"
#include "Support/RunControl.h"

#include <algorithm>

namespace remesh
{
/** Edge k of a facet joins its points k and (k + 1) % 3. */
struct EdgeTable
{
  std::vector<Triple> facetEdges;             ///< F x 3, edge ids
  std::vector<Index> edgeFacetsBegin = { 0 }; ///< E + 1, into `edgeFacets`
  std::vector<Index> edgeFacets;              ///< facets around each edge, ascending

  Index numberOfEdges() const { return static_cast<Index>(this->edgeFacetsBegin.size()) - 1; }
  Index valence(Index edge) const
  {
    return this->edgeFacetsBegin[edge + 1] - this->edgeFacetsBegin[edge];
  }

  /** Which of the facet's sides the edge is; 3 if none. */
  int sideOf(Index facet, Index edge) const
  {
    const Triple& own = this->facetEdges[facet];
    return static_cast<int>(std::find(own.begin(), own.end(), edge) - own.begin());
  }
};

/**
 * Edges numbered in the order in which the facets meet them.
 *
 * @param facetPoints F x 3, F <= maximumIndex / 3, ids from 0 (of points, or of corners: then the
 *        edges are those of the embedded surface, cut open along its creases).
 * @param control asked for cancellation; the table of a cancelled run is empty.
 * Cost: O(F log k) time, k the most facets around a point, in parallel; O(F + highest id) memory.
 */
EdgeTable buildEdgeTable(
  const std::vector<Triple>& facetPoints, const RunControl& control = RunControl());
}

#endif
