/**
 * @file RemeshOptions.h
 * @brief What a run on an embedded surface is asked for.
 */
#ifndef remesh_RemeshOptions_h
#define remesh_RemeshOptions_h

#include "Optimization/QuasiNewton.h"
#include "Optimization/Sampling.h"
#include "Placement/Placement.h"
#include "Support/Ranks.h"

#include <cstdint>
#include <limits>

namespace remesh
{
struct RemeshOptions
{
  Offset numberOfSites = 10000;
  SamplingMethod sampling = SamplingMethod::Stratified;
  std::uint64_t seed = 0;
  /** Whether the first sites are grown from fewer, see FirstSites.h. */
  bool coarseStart = true;
  int lloydIterations = 5;
  QuasiNewtonOptions quasiNewton;
  /** False: the given sites are final, whatever their cells. */
  bool optimize = true;
  VertexPlacement placement = VertexPlacement::Fit;
  /** Sites to start from instead of sampling; n x d, scaled units of the surface. */
  Sites initialSites;
  /** Whether to take away or add sites until the mesh has `numberOfSites` vertices. */
  bool exactNumber = false;
  /**
   * By how many vertices the mesh may exceed the wanted number, where its topology cannot be that
   * of the surface otherwise.
   */
  Offset maximumExtraPoints = 0;
  /** With more components for each vertex's site, the run ends at its first diagram (`fallsApart`).
   */
  double mostComponents = std::numeric_limits<double>::infinity();
  /** How far curves of the mesh may be from those of the surface at most; unit of the points. */
  double mostCurveError = std::numeric_limits<double>::infinity();
  /** Whether features get more points where they bend; else embedded length alone decides. */
  bool curvesFollowBends = true;
  /** False: the diagram is freed when the vertices are placed, which leaves room for the rest. */
  bool keepDiagram = true;
  /** Among which the optimisation's integrals are divided; nullptr: this process does it all. */
  Ranks* ranks = nullptr;
};
}

#endif
