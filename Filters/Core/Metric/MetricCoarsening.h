/**
 * @file MetricCoarsening.h
 * @brief A surface of fewer points with about the same lengths along it.
 *
 * Only the shapes of the facets count, not where they are: it works on any metric.
 *
 * 1. The facets around a point are laid out in a plane: their angles add up to a full turn there
 *    (to what they are, at the border).
 * 2. The point is removed. The hole is filled with the triangles that join one of its corners to
 * all others; the corner is taken for which the worst triangle is best.
 * 3. Again for all points, until none can go: sides do not become longer than a limit, nor
 * triangles worse than they were, unless they are good.
 *
 * Sides where other than two facets meet stay, and so do corners of the border, points around which
 * angles are far from a full turn, and surfaces' topology.
 *
 * Source: H.-T. D. Liu and others, "Surface simplification using intrinsic error metrics", ACM TOG
 * 42, 2023. Cost: O(F), one thread. Deterministic.
 */
#ifndef remesh_MetricCoarsening_h
#define remesh_MetricCoarsening_h

#include "Metric/MetricLaplacian.h"

namespace remesh
{
/** Where a removed point is: a mean of three of the points that were left then. */
struct RemovedPoint
{
  Index point;
  Triple others;
  std::array<float, 3> weights; ///< from 0, their sum is 1
};

struct CoarseSurface
{
  std::vector<Index> points;         ///< of the surface before, ascending
  std::vector<Triple> facetPoints;   ///< ids into `points`
  std::vector<TargetShape> shapes;   ///< of these facets
  std::vector<RemovedPoint> removed; ///< of the surface before, in the order of removal

  /** Values at all points of the surface before, from those at its points. V x d. */
  Rows prolonged(const Rows& values) const;
};

/**
 * @param longest side that may be made, a length in the metric.
 * @return false when cancelled.
 */
[[nodiscard]] bool coarsen(
  const ShapedFacets& surface, double longest, const RunControl& control, CoarseSurface& coarse);
}

#endif
