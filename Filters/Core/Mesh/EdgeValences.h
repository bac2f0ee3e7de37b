/**
 * @file EdgeValences.h
 * @brief How many triangles each edge of a mesh has, without a table of all edges.
 */
#ifndef remesh_EdgeValences_h
#define remesh_EdgeValences_h

#include "Support/RunControl.h"
#include "Support/Types.h"

#include <utility>
#include <vector>

namespace remesh
{
/** An edge by its ends, the lower first, and the number of its triangles. */
using EdgeValence = std::pair<std::pair<Index, Index>, Index>;

struct EdgeValences
{
  Offset edges = 0;
  std::vector<EdgeValence> irregular; ///< those that have not just two triangles, ascending

  /** The number of triangles of an edge of the mesh. O(log of the irregular ones). */
  Index of(Index a, Index b) const;
  Offset numberOfNonManifold() const;
};

/**
 * Lists the edges in windows of their lower vertex, each of which looks at all triangles: a mesh of
 * a million points takes some megabytes a thread. O(T) but for the edges of a vertex, which are
 * sorted, and up to 64 looks at T; in parallel.
 *
 * @return nothing counted when cancelled.
 */
EdgeValences countEdgeValences(
  const std::vector<Triple>& triangles, Index numberOfVertices, const RunControl& control);
}

#endif
