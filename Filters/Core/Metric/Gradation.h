/**
 * @file Gradation.h
 * @brief Limits how fast the sizes of a metric grow along a surface, and how fast they turn.
 *
 * From one point to another a distance l of units away, no size in any direction may be larger than
 * that at the first point times growth^l. Where it is, the metric at the second point is
 * intersected with that of the first one, grown (F. Alauzet, "Size gradation control of anisotropic
 * meshes", 2010). A direction that turns is limited by that, too: what is long at one point and
 * short at the other is short at both.
 *
 * Beside a layer that bends, sizes along it grow from what chords of the layer allow to what they
 * were given, within few units: so fast that no mesh has the lengths of the metric as limited. So
 * they grow less there (`GradationLimits::bends`).
 */
#ifndef remesh_Gradation_h
#define remesh_Gradation_h

#include "Mesh/EdgeTable.h"
#include "Metric/MetricField.h"

namespace remesh
{
struct GradationLimits
{
  /**
   * Above 1, of sizes over one unit. (measured, a torus whose sizes grow 5-fold over one unit where
   * edges are long: with 2, edges of 0.980 instead of 0.998 within [1/sqrt 2, sqrt 2].)
   */
  double growth = 5.0;
  double unit = 1.0; ///< length in the metric
  /**
   * V, at least 1, or empty: by how much straight edges already limit the metric. Where they
   * do, edges are much shorter than they were asked to be, and sizes may grow over one unit by at
   * most 2 + (growth - 2) / bend^2. Bends below 3 have no effect; others fade by a factor of 2 over
   * each unit, so that growth does not jump.
   */
  std::vector<float> bends;
};

/**
 * Rounds over all points, each from what its neighbours had before, until nothing changes.
 *
 * @return false when cancelled. Parallel, deterministic. O(V) for each round.
 */
[[nodiscard]] bool limitGrowth(const SurfaceMesh& mesh, const EdgeTable& edges,
  const GradationLimits& limits, const RunControl& control, MetricField& metric);
}

#endif
