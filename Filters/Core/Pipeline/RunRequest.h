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
  double tolerance = 0.0;  ///< 0: none
  bool isAbsolute = false; ///< in the unit of the points; else a fraction of the diagonal
  Offset mostPoints = 1000000;
  /** Whether RemeshOptions::maximumExtraPoints is one percent of the number of each run. */
  bool extraIsOnePercent = false;
};

/** Edges of unit length in the metric, which gives the number of points. */
struct UnitRequest
{
  bool isUnit = false;
  double complexity = 0.0; ///< the area that the metric is scaled to; 0: as it is
};

struct RunRequest
{
  PreparationRequest preparation;  ///< its `numberOfSites` is set by the run
  RemeshOptions options;           ///< `initialSites` are those of `sites`
  ToleranceRequest tolerance;      ///< does not count where there are sites
  UnitRequest unit;                ///< instead of `options.numberOfSites`
  std::optional<GivenSites> sites; ///< to start from, instead of `options.numberOfSites`
  bool measuresDistance = true;    ///< a tolerance is measured in any case
  double memory = 0.0;             ///< of the machine, bytes; 0: not known, and not asked about

  bool hasNumber() const { return this->sites || !(this->tolerance.tolerance > 0.0); }
};

struct RunOutcome
{
  PreparedSurface prepared;
  PlacedSites given; ///< what was read; its sites are moved to the options of the run
  RemeshResult result;
  double intakeSeconds = 0.0; ///< wall time of the preparations
};
}

#endif
