/**
 * @file CreaseGraph.h
 * @brief Which feature edges meet at which points, and how they turn there.
 */
#ifndef remesh_CreaseGraph_h
#define remesh_CreaseGraph_h

#include "Features/FeatureEdges.h"

#include <array>
#include <vector>

namespace remesh
{
struct CreaseGraph
{
  const SurfaceMesh& mesh;
  std::vector<std::array<Index, 2>> ends; ///< E, points of each edge, as its first facet has them
  std::vector<char> droppable;            ///< E, creases that are not given; empty without options
  std::vector<Offset> begin;              ///< V + 1, into `around`
  std::vector<Index> around;              ///< feature edges at each point, ascending

  Index degree(Index point) const
  {
    return static_cast<Index>(this->begin[point + 1] - this->begin[point]);
  }
  /** Feature k at a point. */
  Index at(Index point, Index k) const { return this->around[this->begin[point] + k]; }
  Index other(Index edge, Index point) const
  {
    return this->ends[edge][this->ends[edge][0] == point ? 1 : 0];
  }
  double length(Index edge) const;

  /** By how much the two features of a point of degree 2 turn there; radians, 0 to pi. */
  double turn(Index point) const;

  /** Sets `begin` and `around`, for these kinds (E). O(V + E). */
  void listAround(const std::vector<FeatureKind>& kinds);
};

/** O(F). The mesh must outlive it. */
CreaseGraph makeCreaseGraph(
  const SurfaceMesh& mesh, const EdgeTable& edges, const std::vector<FeatureKind>& kinds);

/** The same, and what may be dropped. */
CreaseGraph makeCreaseGraph(const SurfaceMesh& mesh, const EdgeTable& edges,
  const FeatureOptions& options, const std::vector<FeatureKind>& kinds);
}

#endif
