/**
 * @file DistanceBound.h
 * @brief How far fitted vertices may be from the surface.
 */
#ifndef remesh_DistanceBound_h
#define remesh_DistanceBound_h

#include "Placement/FitSystem.h"

namespace remesh
{
/**
 * The fit counts how far the surface is from the mesh, not how far the mesh goes beyond it: behind
 * a rim that is thinner than the triangles are long, a vertex that goes far out makes the triangles
 * that fall away to the rim come closer, and is punished by nothing. So vertices go back on their
 * ways as far as it takes that:
 *
 * - none is farther from the surface than the surface was from the mesh anywhere at the start, or
 *   than it was itself;
 * - a sixth of its squared distance, which is the mean over the triangles around it of what it
 *   alone moves them, is no more than the mean square of their distances at the start, in addition
 * to its own then. Less than the whole mesh's root mean square is never too far.
 *
 * (measured: without the second, 0.3 % of the vertices of a coarse scan are more than that; with a
 * third instead of a sixth, 7 %, and the fit is 1 % farther from the surface.)
 *
 * @param start K, where the fit began.
 * @param errors there.
 * @param positions K; changed.
 * @return false when cancelled.
 * Cost: of each vertex, a search among the facets of its cell and those around it. Parallel,
 * deterministic.
 */
[[nodiscard]] bool boundDistances(const FitTask& task, const std::vector<Point3>& start,
  const FitErrors& errors, const RunControl& control, std::vector<Point3>& positions);
}

#endif
