#include "Adaptors/ToleranceRun.h"

#include "Adaptors/MemoryCheck.h"
#include "Mesh/Extent.h"
#include "MeshDistance.h"

#include <algorithm>
#include <sstream>

namespace remesh
{
namespace
{
constexpr Offset pilotPoints = 2000;
constexpr int pilotIterations = 10;
constexpr Offset roughSamples = 20000;
constexpr Offset mostParts = 200000; // for the bound that is reported
constexpr int mostDescents = 3;
constexpr double wellWithin = 0.8;      // of the tolerance: fewer points will do
constexpr double fewestAtOnce = 0.3;    // of the points, in one descent
constexpr double leastTolerance = 1e-7; // of the diagonal: single precision

/** The whole run, with one number of points after the other. */
struct ToleranceRun
{
  vtkPolyData* input;
  PreparationRequest request;
  RemeshOptions options;
  ToleranceOptions tolerance;
  PreparedSurface& prepared;
  RemeshResult& result;

  const Features* features() const
  {
    return this->prepared.features ? &*this->prepared.features : nullptr;
  }

  Status prepare(Offset number, const RunControl& control)
  {
    this->options.numberOfSites = this->request.numberOfSites = number;
    Status status = prepareSurface(this->input, this->request, control, this->prepared);
    return status.ok() ? checkMemory(number, this->prepared.surface.dimension,
                           this->options.quasiNewton.historyLength)
                       : status;
  }

  Status make(const RemeshOptions& with, const RunControl& control)
  {
    return remesh(
      this->prepared.mesh, this->prepared.surface, with, control, this->result, this->features());
  }

  Status measure(const DistanceOptions& how, const RunControl& control, TwoSidedDistance& distance)
  {
    return measureTwoSidedDistance(
      trianglesOf(this->result), trianglesOf(this->prepared.mesh), how, control, distance);
  }

  /** A rough mesh, and the number for the next one. The surface is prepared for the former. */
  Status pilot(RunControl control, Offset& number)
  {
    RemeshOptions rough = this->options;
    rough.quasiNewton.iterations = std::min(pilotIterations, rough.quasiNewton.iterations);
    TwoSidedDistance distance;
    Status status = this->make(rough, control.part(0.0, 0.8));
    control.enterPhase("Distance", 0.8, 1.0);
    if (status.ok())
    {
      status = this->measure(roughly(), control, distance);
    }
    number = numberForTolerance(
      { this->options.numberOfSites, std::max(distance.forward.mean, distance.backward.mean),
        this->result.neededFeaturePoints },
      this->tolerance);
    return status;
  }

  /** Samples alone. */
  static DistanceOptions roughly()
  {
    DistanceOptions how;
    how.numberOfSamples = roughSamples;
    how.boundTolerance = -1.0;
    return how;
  }

  DistanceOptions closely() const
  {
    DistanceOptions how;
    how.negligible = 0.05 * this->tolerance.tolerance;
    how.maximumParts = mostParts;
    return how;
  }

  /** Whole runs with fewer points, while the last one was well within the tolerance. */
  Status descend(Offset number, RunControl control)
  {
    const Offset least =
      numberForTolerance({ 0, 0.0, this->result.neededFeaturePoints }, this->tolerance);
    for (int descent = 0;; ++descent)
    {
      control = control.part(0.0, 1.0);
      Status status = this->prepare(number, control.part(0.0, 0.05));
      if (status.ok())
      {
        status = this->make(this->options, control.part(0.05, 0.6));
      }
      TwoSidedDistance distance;
      control.enterPhase("Distance", 0.6, 0.7);
      if (status.ok())
      {
        status = this->measure(roughly(), control, distance);
      }
      const double share = distance.maximum() / this->tolerance.tolerance;
      if (!status.ok() || descent == mostDescents || share > wellWithin || number <= least)
      {
        return status;
      }
      number = std::max(least, static_cast<Offset>(std::max(fewestAtOnce, share) * number));
      control = control.part(0.7, 1.0);
    }
  }

  /** What was reached. A bound that was proven in refinement holds, however far this one comes. */
  Status report(ToleranceOutcome outcome, const RunControl& control)
  {
    TwoSidedDistance& distance = this->result.distance.emplace();
    if (Status status = this->measure(this->closely(), control, distance); !status.ok())
    {
      return status;
    }
    if (outcome == ToleranceOutcome::Kept)
    {
      for (OneSidedDistance* side : { &distance.forward, &distance.backward })
      {
        side->maximumBound = std::min(side->maximumBound, this->tolerance.tolerance);
      }
      return Status::success();
    }
    std::ostringstream warning;
    warning << "The distance is " << distance.maximumBound() << ", above the tolerance of "
            << this->tolerance.tolerance << ": ";
    if (outcome == ToleranceOutcome::TooManyPoints)
    {
      warning << "it takes more than the " << this->tolerance.mostPoints << " points allowed.";
    }
    else
    {
      warning << "more points do not help.";
    }
    if (!this->features())
    {
      warning << " Keeping features may.";
    }
    this->prepared.warnings.push_back(warning.str());
    return Status::success();
  }
};
}

Status remeshWithin(const ToleranceRequest& tolerance, vtkPolyData* input,
  PreparationRequest request, RemeshOptions options, const RunControl& control,
  PreparedSurface& prepared, RemeshResult& result)
{
  ToleranceRun run{ input, std::move(request), std::move(options), {}, prepared, result };
  run.options.exactNumber = false;
  run.tolerance.mostPoints = tolerance.mostPoints;
  Offset number = std::min(pilotPoints, tolerance.mostPoints);
  if (Status status = run.prepare(number, control.part(0.0, 0.03)); !status.ok())
  {
    return status;
  }
  const double diagonal = boundingBoxDiagonal(prepared.mesh);
  run.tolerance.tolerance = tolerance.tolerance * (tolerance.isAbsolute ? 1.0 : diagonal);
  if (!(run.tolerance.tolerance >= leastTolerance * diagonal))
  {
    std::ostringstream message;
    message << "The distance tolerance is " << run.tolerance.tolerance
            << "; it must be at least 1e-7 of the bounding box's diagonal, which is " << diagonal
            << ".";
    return Status::invalid(message.str());
  }
  run.options.mostCurveError = 0.25 * run.tolerance.tolerance;
  Status status = run.pilot(control.part(0.03, 0.1), number);
  if (status.ok())
  {
    status = run.descend(number, control.part(0.1, 0.6));
  }
  ToleranceOutcome outcome = ToleranceOutcome::Stuck;
  if (status.ok())
  {
    status = refineToTolerance(prepared.mesh, prepared.surface, run.options, run.tolerance,
      control.part(0.6, 0.95), result, run.features(), outcome);
  }
  RunControl last = control.part(0.95, 1.0);
  last.enterPhase("Distance", 0.0, 1.0);
  return status.ok() ? run.report(outcome, last) : status;
}
}
