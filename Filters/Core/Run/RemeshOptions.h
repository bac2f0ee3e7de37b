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
  /** Whether a quarter of the first sites is spread before the others join them (FirstSites.h). */
  bool coarseStart = true;
  int lloydIterations = 5;
  QuasiNewtonOptions quasiNewton;
  /** False: the given sites stay as they are. No steps move them, and no repair changes them. */
  bool optimize = true;
  VertexPlacement placement = VertexPlacement::Fit;
  /** Sites to start from instead of sampling; n x d, scaled units of the surface. */
  Sites initialSites;
  /** Whether sites are added or removed until the mesh has `numberOfSites` vertices. */
  bool exactNumber = false;
  /**
   * How many vertices the mesh may have beyond the wanted number, if it takes them to get the
   * topology of the surface.
   */
  Offset maximumExtraPoints = 0;
  /**
   * With more components than this for each site, copies of a vertex counted once, the cells have
   * fallen apart: the run ends at its first diagram, and sets `fallsApart`.
   */
  double maxComponents = std::numeric_limits<double>::infinity();
  /** The largest distance of the mesh's feature curves from the surface's; unit of the points. */
  double maxCurveError = std::numeric_limits<double>::infinity();
  /** Whether features get more points where they bend. False: by their length in R^d alone. */
  bool curvesFollowBends = true;
  /** False: the diagram, and which component a piece is of, are freed as soon as nothing reads
   * them.
   */
  bool keepDiagram = true;
  /** The processes that share integrals and distances; nullptr: this process does it all. */
  Ranks* ranks = nullptr;
};
}

#endif
