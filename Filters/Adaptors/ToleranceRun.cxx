#include "Adaptors/ToleranceRun.h"

#include "Mesh/Extent.h"
#include "MeshDistance.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace remesh
{
namespace
{
constexpr Offset pilotPoints = 2000;
constexpr int pilotIterations = 10;
constexpr Offset roughSamples = 20000;
constexpr Offset mostParts = 200000;    // for the bound that is reported
constexpr int mostRuns = 4;             // whole ones, before refinement
constexpr double enough = 0.95;         // of the points that features ask for
constexpr double wellWithin = 0.8;      // of the tolerance: fewer points will do
constexpr double fewestAtOnce = 0.3;    // of the points, in one descent
constexpr Offset mostGrowth = 4;        // of the points, in refinement where creases are left out
constexpr int mostSearches = 4;         // with ever more creases
constexpr double leastTolerance = 1e-7; // of the diagonal: single precision

/** The whole run, with one number of points after the other. */
struct ToleranceRun
{
  NumberRequest request;
  RemeshOptions options;
  ToleranceOptions tolerance;
  bool extraIsOnePercent;
  NumberOutcome& outcome;

  /** Whole runs with fewer points, one after the other. */
  struct Descent
  {
    Offset from = 0;                                   ///< number of points of the run before
    Index dropped = std::numeric_limits<Index>::max(); ///< its creases
    bool isOver = false;
  } descent = {};

  PreparedSurface& prepared = outcome.prepared;
  RemeshResult& result = outcome.result;

  const Features* features() const
  {
    return this->prepared.features ? &*this->prepared.features : nullptr;
  }

  void setNumber(Offset number, RemeshOptions& with) const
  {
    with.numberOfSites = number;
    if (this->extraIsOnePercent)
    {
      with.maximumExtraPoints = number / 100;
    }
  }

  /** A run with so many points. */
  Status make(Offset number, RemeshOptions with, const RunControl& control)
  {
    this->request.preparation.numberOfSites = number;
    this->setNumber(number, with);
    return remeshWithNumber(this->request, with, control, this->outcome);
  }

  Status measure(const DistanceOptions& how, const RunControl& control, TwoSidedDistance& distance)
  {
    return measureTwoSidedDistance(
      trianglesOf(this->result), trianglesOf(this->prepared.mesh), how, control, distance);
  }

  /** A rough mesh, and from its number of points that for the next one. */
  Status pilot(RunControl control, Offset& number)
  {
    RemeshOptions rough = this->options;
    rough.quasiNewton.iterations = std::min(pilotIterations, rough.quasiNewton.iterations);
    TwoSidedDistance distance;
    Status status = this->make(number, rough, control.part(0.0, 0.8));
    control.enterPhase("Distance", 0.8, 1.0);
    if (status.ok())
    {
      status = this->measure(roughly(), control, distance);
    }
    number = numberForTolerance({ number, std::max(distance.forward.mean, distance.backward.mean),
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

  Index droppedCreases() const { return this->features() ? this->features()->droppedEdges : 0; }

  /**
   * The number for another whole run, or 0: more points while the features take most of them, as
   * more creases count where points are denser; else fewer, while the last run was well within the
   * tolerance, but not so few that creases are lost.
   *
   * @param share what the last run reached of the tolerance.
   */
  Offset numberAfter(double share)
  {
    const Offset least =
      numberForTolerance({ 0, 0.0, this->result.neededFeaturePoints }, this->tolerance);
    const Offset number = this->request.preparation.numberOfSites;
    const Index dropped = this->droppedCreases();
    if (number < enough * least)
    {
      this->descent.isOver = true;
      return least;
    }
    if (this->descent.isOver)
    {
      return 0;
    }
    if (dropped > this->descent.dropped)
    {
      this->descent.isOver = true;
      return this->descent.from;
    }
    if (share > wellWithin || number <= least)
    {
      return 0;
    }
    this->descent = { number, dropped, false };
    return std::max(least, static_cast<Offset>(std::max(fewestAtOnce, share) * number));
  }

  Status approach(Offset number, RunControl control)
  {
    this->descent = Descent{};
    for (int run = 0; run < mostRuns && number > 0; ++run)
    {
      control = control.part(0.0, 1.0);
      this->setNumber(number, this->options); // and of what goes on from there
      Status status = this->make(number, this->options, control.part(0.0, 0.6));
      TwoSidedDistance distance;
      control.enterPhase("Distance", 0.6, 0.7);
      if (status.ok())
      {
        status = this->measure(roughly(), control, distance);
      }
      if (!status.ok())
      {
        return status;
      }
      number = this->numberAfter(distance.maximum() / this->tolerance.tolerance);
      control = control.part(0.7, 1.0);
    }
    return Status::success();
  }

  /**
   * Whole runs, and refinement from there. Where creases are too small for the points, they are
   * refined as round ones, which can take many times as many: then again, with that many from the
   * beginning.
   */
  Status search(Offset number, RunControl control, ToleranceOutcome& reached)
  {
    const auto numberNow = [this]() { return Offset(this->result.components.count()); };
    for (int search = 1;; ++search)
    {
      Status status = this->approach(number, control.part(0.0, 0.5));
      const bool isLast = search == mostSearches || this->droppedCreases() == 0;
      ToleranceOptions limited = this->tolerance;
      if (!isLast)
      {
        limited.mostPoints = std::min(limited.mostPoints, mostGrowth * numberNow());
      }
      if (status.ok())
      {
        status = refineToTolerance(this->prepared.mesh, this->prepared.surface, this->options,
          limited, control.part(0.5, 0.9), this->result, this->features(), reached);
      }
      if (!status.ok() || isLast || reached == ToleranceOutcome::Kept ||
        numberNow() >= this->tolerance.mostPoints)
      {
        return status;
      }
      const Offset doubled = 2 * this->request.preparation.numberOfSites;
      number = std::min(std::max(numberNow(), doubled), this->tolerance.mostPoints);
      control = control.part(0.9, 1.0);
    }
  }

  /** What was reached. A bound that was proven in refinement holds, however far this one comes. */
  Status report(ToleranceOutcome reached, const RunControl& control)
  {
    TwoSidedDistance& distance = this->result.distance.emplace();
    if (Status status = this->measure(this->closely(), control, distance); !status.ok())
    {
      return status;
    }
    if (reached == ToleranceOutcome::Kept)
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
    if (reached == ToleranceOutcome::TooManyPoints)
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

Status remeshWithin(const ToleranceRequest& tolerance, NumberRequest request, RemeshOptions options,
  const RunControl& control, NumberOutcome& outcome)
{
  PreparedSurface& prepared = outcome.prepared;
  ToleranceRun run{ std::move(request), std::move(options), {}, tolerance.extraIsOnePercent,
    outcome };
  run.options.exactNumber = false;
  run.tolerance.mostPoints = tolerance.mostPoints;
  Offset number = std::min(pilotPoints, tolerance.mostPoints);
  run.request.preparation.numberOfSites = number;
  if (Status status = prepareSurface(
        run.request.input, run.request.preparation, control.part(0.0, 0.03), prepared);
      !status.ok())
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
  ToleranceOutcome reached = ToleranceOutcome::Stuck;
  if (status.ok())
  {
    status = run.search(number, control.part(0.1, 0.95), reached);
  }
  RunControl last = control.part(0.95, 1.0);
  last.enterPhase("Distance", 0.0, 1.0);
  return status.ok() ? run.report(reached, last) : status;
}
}
