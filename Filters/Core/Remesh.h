/**
 * @file Remesh.h
 * @brief A run on an embedded surface, on one page.
 *
 * surface -> sites -> Lloyd -> quasi-Newton -> restricted Voronoi diagram -> components -> dual
 * -> vertices placed
 *
 * With features there is more:
 * - Sites on features come first, and stay (Features/). They are as far apart as the others will be
 *   (CurveSampling.h). Curves close to each other get more of them, to be kept apart
 *   (CurveSeparation.h).
 * - The other sites are drawn patch by patch.
 * - The duals of the patches are sewn together along the curves (Delaunay/Collar.h).
 * - Vertices on features are fitted to the curves (CurveFit.h).
 *
 * Repairs (Repair/) change sites where the dual is not proven to be homeomorphic to the surface
 * (Delaunay/Certificate.h), where triangles are inverted, and where a cell reaches a feature curve.
 * Then the diagram and its dual are made again there.
 */
#ifndef remesh_Remesh_h
#define remesh_Remesh_h

#include "Run/Task.h"

namespace remesh
{
/**
 * Makes the mesh. Deterministic in the task.
 *
 * @param task whose mesh was cut open along its features, if it has any. If there are several
 *        patches, they must be separated in its embedded surface (separatePatches).
 * @param result is replaced.
 */
Status remesh(const Task& task, RunControl control, RemeshResult& result);

/**
 * Does the end of a run again, from the diagram on, after the caller has moved sites or appended
 * new ones. Repairs change only the sites that they must, so that the mesh stays as it is
 * elsewhere.
 *
 * @param result of a run with the same surface, options and features; its sites are the input.
 */
Status completeMesh(const Task& task, RunControl control, RemeshResult& result);
}

#endif
