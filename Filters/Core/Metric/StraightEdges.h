/**
 * @file StraightEdges.h
 * @brief A metric as straight edges meet it: averaged over edges of unit length.
 *
 * Where a metric turns, grows or bends within the length of an edge, no edge along a direction has
 * the length that the metric at its middle says: a chord of a layer that bends leaves it by its
 * sagitta, and is long then. The limited metric says what edges really are.
 *
 * 1. At each point, in directions that are even in the limited metric so far, an edge is laid along
 *    the surface, straight, so far to both sides that it has half a unit there, in the given
 *    metric. At the border it goes on in the metric there.
 * 2. The limited metric is the ellipse in which these edges are nearest to one unit, by least
 *    squares.
 * 3. Twice more, from that ellipse.
 */
#ifndef remesh_StraightEdges_h
#define remesh_StraightEdges_h

#include "Mesh/EdgeTable.h"
#include "Metric/MetricField.h"

namespace remesh
{
/**
 * @param unit the length in the metric that edges of the mesh will have.
 * @param limited receives the metric; its normals are those of `metric`.
 * @return false when cancelled. Parallel, deterministic. O(V k), k the facets that an edge crosses.
 */
[[nodiscard]] bool limitToStraightEdges(const SurfaceMesh& mesh, const EdgeTable& edges,
  const MetricField& metric, double unit, const RunControl& control, MetricField& limited);
}

#endif
