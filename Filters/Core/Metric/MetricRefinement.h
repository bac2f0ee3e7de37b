/**
 * @file MetricRefinement.h
 * @brief Splits facets that are too large for the metric on them.
 *
 * 1. Edges are measured in the metric, whose logarithm is linear on each facet (V. Arsigny et al.,
 *    "Log-Euclidean metrics for fast and simple calculus on diffusion tensors", 2006).
 * 2. Split are those longer than half a unit, and those along which the metric changes by more than
 *    a factor, down to an eighth of a unit.
 * 3. So are the longest sides of facets around them, in the metric, until all fits
 *    (Refinement.h): facets of up to some 40 : 1 in the metric fall into pieces of good shape, that
 *    may be thin in R^3.
 * 4. After each round, edges between thin pieces of a facet are flipped in the metric
 *    (PieceFlips.h). A thin layer across the facets' sides needs far fewer pieces then.
 * 5. Facets that are longer and thinner than that are needles. Their sides are split first
 *    (Refinement.h): flips join the points on them to pieces thin across the layer, and few.
 */
#ifndef remesh_MetricRefinement_h
#define remesh_MetricRefinement_h

#include "Metric/MetricField.h"
#include "Refinement/Refinement.h"

namespace remesh
{
/**
 * @param unit a length in the metric, above 0: what an edge of the mesh will have.
 * @param maxFacets that the surface may come to have; the longest edges come first (Refinement.h).
 * @param refined receives the surface, where any facet is split.
 * @param refinedMetric receives its metric then: at the old points as it was.
 * @return whether any facet is split. O(F) for each of up to 24 rounds.
 */
bool refineForMetric(const SurfaceMesh& mesh, const Features* features, const MetricField& metric,
  double unit, Offset maxFacets, const RunControl& control, RefinedSurface& refined,
  MetricField& refinedMetric);

/** The metric's area of a surface, from shapes of its facets. */
double metricArea(const std::vector<TargetShape>& shapes);
}

#endif
