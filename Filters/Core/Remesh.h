/**
 * @file Remesh.h
 * @brief The whole pipeline on one page.
 *
 * surface -> sites -> Lloyd -> quasi-Newton -> restricted Voronoi diagram -> components -> dual
 *
 * Where the dual is no manifold in a few places, sites are moved there, and the end is run again.
 */
#ifndef remesh_Remesh_h
#define remesh_Remesh_h

#include "Delaunay/Components.h"
#include "Delaunay/Dual.h"
#include "Delaunay/SurfaceLocation.h"
#include "Embedding/EmbeddedSurface.h"
#include "Optimization/Convergence.h"
#include "Optimization/QuasiNewton.h"
#include "Optimization/Sampling.h"
#include "Voronoi/CellSums.h"
#include "Voronoi/Diagram.h"

namespace remesh
{
struct RemeshOptions
{
  Offset numberOfSites = 10000;
  SamplingMethod sampling = SamplingMethod::Stratified;
  std::uint64_t seed = 0;
  int lloydIterations = 5;
  QuasiNewtonOptions quasiNewton;
  /** False: the given sites are final, whatever their cells. */
  bool optimize = true;
  /** Sites to start from instead of sampling; n x d, scaled units of the surface. */
  Sites initialSites;
};

/** Everything in the scaled units of the embedded surface, but what is in R^3. */
struct RemeshResult
{
  Sites sites;
  CellSums sums;
  Diagram diagram;
  EdgeTable edges;
  Components components;
  std::vector<SurfaceLocation> locations; ///< of the components
  Dual dual;
  std::vector<Index> numbersOfNeighbors; ///< n
  Convergence convergence;
  Index emptyCells = 0;
  Index movedSites = 0; ///< to where the dual was no manifold; `convergence` ends before that
  int evaluations = 0;

  struct Seconds
  {
    double sampling = 0.0;
    double lloyd = 0.0;
    double newton = 0.0;
    double repair = 0.0;
    double diagram = 0.0;
  } seconds; ///< wall time of the phases
};

/** Runs the pipeline on an embedded surface. Deterministic in surface and options. */
Status remesh(const SurfaceMesh& mesh, const EmbeddedSurface& surface, const RemeshOptions& options,
  RunControl control, RemeshResult& result);
}

#endif
