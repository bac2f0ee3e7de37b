/**
 * @file RunRequest.h
 * @brief What is asked of the pipeline, and what comes out.
 */
#ifndef remesh_RunRequest_h
#define remesh_RunRequest_h

#include "Preparation/GivenSites.h"
#include "Preparation/SurfacePreparation.h"
#include "Remesh.h"

#include <optional>

namespace remesh
{
/** A distance of mesh and surface that is asked for instead of a number of points. */
struct ToleranceRequest
{
  double tolerance = 0.0;     ///< 0: none is asked for
  bool isAbsolute = false;    ///< in the unit of the points; else a fraction of the diagonal
  Offset maxPoints = 1000000; ///< the run ends there, with a warning
  /** Whether RemeshOptions::maximumExtraPoints is one percent of the number of each run. */
  bool extraIsOnePercent = false;
};

/** Edges of the length 1 in a metric are asked for. The metric gives the number of points then. */
struct UnitRequest
{
  bool isUnit = false;     ///< whether they are asked for
  double complexity = 0.0; ///< the area that the metric is scaled to; 0: it is not scaled
};

/** All that a run depends on. */
struct RunRequest
{
  PreparationRequest preparation;  ///< the run sets its `numberOfSites`
  RemeshOptions options;           ///< the run sets its `initialSites`, from `sites`
  ToleranceRequest tolerance;      ///< is not looked at if there are `sites`
  UnitRequest unit;                ///< instead of `options.numberOfSites`
  std::optional<GivenSites> sites; ///< to start from, instead of `options.numberOfSites`
  bool measuresDistance = true; ///< whether mesh and surface are compared; always for a tolerance
  double memory = 0.0;          ///< of the machine, bytes; 0: not known, so it is not checked

  /** Whether the number of sites is known; else the tolerance decides on it. */
  bool hasNumber() const { return this->sites || !(this->tolerance.tolerance > 0.0); }
};

/** All that a run has made. */
struct RunOutcome
{
  PreparedSurface prepared;   ///< the surface in R^d, and the warnings so far
  PlacedSites given;          ///< what was read of `sites`; the coordinates went into the options
  RemeshResult result;        ///< the mesh
  double intakeSeconds = 0.0; ///< wall time of the preparations of all runs
};
}

#endif
