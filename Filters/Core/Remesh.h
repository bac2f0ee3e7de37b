/**
 * @file Remesh.h
 * @brief The whole pipeline on one page.
 *
 * surface -> sites -> Lloyd -> quasi-Newton -> restricted Voronoi diagram -> components -> dual
 * -> vertices placed
 *
 * With features, the sites on them come first and stay (Features/), as far apart as the others will
 * be (CurveSampling.h), and so many that curves close to each other are kept apart
 * (CurveSeparation.h); the others are drawn patch by patch, and the patches' duals are sewn
 * together along the curves (Delaunay/Collar.h). Their vertices are fitted to the curves
 * (CurveFit.h).
 *
 * Where the dual is not proven to be like the surface (Delaunay/Certificate.h), or triangles are
 * flipped, sites are moved there; where a cell reaches a feature curve, its site joins the curve;
 * and the end is run again.
 */
#ifndef remesh_Remesh_h
#define remesh_Remesh_h

#include "Run/RemeshOptions.h"
#include "Run/RemeshResult.h"

namespace remesh
{
/**
 * Runs the pipeline on an embedded surface. Deterministic in surface and options.
 *
 * @param features along which `mesh` was cut open, or nullptr. If there are several patches, they
 *        must be separated in `surface`.
 */
Status remesh(const SurfaceMesh& mesh, const EmbeddedSurface& surface, const RemeshOptions& options,
  RunControl control, RemeshResult& result, const Features* features = nullptr);

/**
 * Ends a run again, from the diagram on, after its sites were moved or others added behind them.
 * Repairs leave all sites alone that they need not change, so that the mesh stays as it is
 * elsewhere.
 *
 * @param result of the run, with the same surface, options and features.
 */
Status completeMesh(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const RemeshOptions& options, RunControl control, RemeshResult& result,
  const Features* features = nullptr);
}

#endif
