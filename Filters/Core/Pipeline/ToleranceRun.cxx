#include "Pipeline/ToleranceRun.h"

#include "Mesh/Extent.h"
#include "Pipeline/FinerCreases.h"
#include "Pipeline/NumberRun.h"
#include "Pipeline/ToleranceSearch.h"
#include "Run/MeshDistance.h"

#include <algorithm>
#include <sstream>

namespace remesh
{
namespace
{
constexpr Offset pilotPoints = 2000;
constexpr int pilotIterations = 10;
constexpr Offset roughSamples = 20000;
constexpr Offset maxPartsOfBound = 200000; // for the bound that is reported
constexpr int maxRuns = 4;                 // whole ones, before refinement
constexpr double enough = 0.95;            // of the points that features ask for
constexpr double wellWithin = 0.8;         // of the tolerance: fewer points will do
constexpr double minAtOnce = 0.3;          // of the points, in one descent
constexpr Offset maxGrowth = 2;            // of the points, before finer creases are looked for
constexpr double maxFarCells = 0.5;        // of those there were, where finer creases are kept
constexpr double minTolerance = 1e-7;      // of the diagonal: single precision

/** The whole run, with one number of points after the other. */
struct ToleranceRun
{
  RunRequest request;
  RunOutcome& outcome;

  ToleranceRequest& tolerance = request.tolerance; ///< from the first run on, in the points' unit
  PreparedSurface& prepared = outcome.prepared;
  RemeshResult& result = outcome.result;

  void setNumber(Offset number, RemeshOptions& with) const
  {
    with.numberOfSites = number;
    if (this->tolerance.extraIsOnePercent)
    {
      with.maximumExtraPoints = number / 100;
    }
  }

  /** A run with so many points. */
  Status make(Offset number, int newtonIterations, const RunControl& control)
  {
    this->request.preparation.numberOfSites = number;
    RunRequest run = this->request;
    this->setNumber(number, run.options);
    run.options.quasiNewton.iterations = newtonIterations;
    return remeshWithNumber(std::move(run), control, this->outcome);
  }

  Status measure(const DistanceOptions& how, const RunControl& control, TwoSidedDistance& distance)
  {
    return measureTwoSidedDistance(
      trianglesOf(this->result), trianglesOf(this->prepared.inputMesh()), how, control, distance);
  }

  /** A rough mesh, and from its distance the number of points for the next one. */
  Status pilot(RunControl control, Offset& number)
  {
    const int iterations = std::min(pilotIterations, this->request.options.quasiNewton.iterations);
    TwoSidedDistance distance;
    Status status = this->make(number, iterations, control.part(0.0, 0.8));
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

  /** Rough meshes, until one tells a number that can be relied on. */
  Status pilots(RunControl control, Offset& number)
  {
    for (Offset next = number; next > 0;)
    {
      const Offset at = number = next;
      if (Status status = this->pilot(control.part(0.0, 0.5), number); !status.ok())
      {
        return status;
      }
      next = pilotAfter(at, number, this->result.topology.lost());
      control = control.part(0.5, 1.0);
    }
    return Status::success();
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
    how.maximumParts = maxPartsOfBound;
    return how;
  }

  /** As many points as leave enough besides those that features need. */
  Offset numberBeside(Offset needed) const
  {
    return numberForTolerance({ 0, 0.0, needed }, this->tolerance);
  }

  /**
   * The number for another whole run, or 0: more points while the features take most of them, fewer
   * while the last run was well within the tolerance.
   *
   * @param share what the last run reached of the tolerance.
   */
  Offset numberAfter(double share) const
  {
    const Offset least = this->numberBeside(this->result.neededFeaturePoints);
    const Offset number = this->request.preparation.numberOfSites;
    if (number < enough * least)
    {
      return least;
    }
    return share > wellWithin || number <= least
      ? 0
      : std::max(least, static_cast<Offset>(std::max(minAtOnce, share) * number));
  }

  /** Whole runs with the same creases. */
  Status approach(Offset number, RunControl control)
  {
    for (int run = 0; run < maxRuns && number > 0; ++run)
    {
      control = control.part(0.0, 1.0);
      this->setNumber(number, this->request.options); // and of what goes on from there
      Status status =
        this->make(number, this->request.options.quasiNewton.iterations, control.part(0.0, 0.6));
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

  /** Refinement, until there are so many points. */
  Status refine(Offset many, const RunControl& control, ToleranceOutcome& reached)
  {
    return refineToTolerance(this->request, many, control, this->outcome, reached);
  }

  /**
   * Whole runs with finer creases; kept if half as many cells have a place beyond as before, with
   * no more than twice as many points.
   *
   * @return Cancelled, or success.
   */
  Status tryCreases(const FinerCreases& finer, Offset number, const RunControl& control,
    ToleranceOutcome& reached, bool& kept)
  {
    const RunRequest coarseRequest = this->request;
    const ToleranceOutcome coarseReached = reached;
    RunOutcome coarse = std::move(this->outcome);
    this->request.preparation.sitesForFeatures = finer.sites;
    const Status status = withinMemory(
      [&]()
      {
        const Status made = this->approach(number, control.part(0.0, 0.9));
        // No refinement: what is still far.
        return made.ok() ? this->refine(0, control.part(0.9, 1.0), reached) : made;
      });
    const Offset most =
      std::min(maxGrowth * coarse.result.components.count(), this->tolerance.maxPoints);
    kept = status.ok() && this->result.components.count() <= most &&
      reached.farCells.size() <= maxFarCells * coarseReached.farCells.size();
    if (!kept && status.code != StatusCode::Cancelled)
    {
      coarse.intakeSeconds = this->outcome.intakeSeconds; // of all runs
      coarse.result.seconds = this->result.seconds;
      coarse.result.evaluations = this->result.evaluations;
      this->outcome = std::move(coarse);
      this->request = coarseRequest;
      reached = coarseReached;
    }
    return status.code == StatusCode::Cancelled ? status : Status::success();
  }

  /** Creases to be tried, with as many points as leave enough besides them; else any number. */
  Status findCreases(const ToleranceOutcome& reached, const RunControl& control,
    FinerCreases& finer, Offset& taken) const
  {
    const Status status = withinMemory([&]()
      { return findFinerCreases(this->request, this->outcome, reached.farCells, control, finer); });
    taken = status.ok() && finer.sites > 0 ? this->numberBeside(finer.neededPoints)
                                           : this->tolerance.maxPoints;
    return status.code == StatusCode::Cancelled ? status : Status::success();
  }

  /**
   * Refinement, to the end or to twice as many points, and then whole runs with finer creases, if
   * these are the reason.
   *
   * @param goesOn whether another round may help.
   */
  Status refineOrTryCreases(const RunControl& control, ToleranceOutcome& reached, bool& goesOn)
  {
    goesOn = false;
    const Offset any = this->tolerance.maxPoints;
    if (this->prepared.dropped.edges == 0)
    {
      return this->refine(any, control, reached);
    }
    const Offset many = maxGrowth * this->result.components.count();
    Status status = this->refine(many, control.part(0.0, 0.2), reached);
    if (!status.ok() || reached.how == ToleranceOutcome::Kept)
    {
      return status;
    }
    FinerCreases finer;
    Offset taken = any;
    status = this->findCreases(reached, control.silent(), finer, taken);
    const bool mayGrow = reached.how == ToleranceOutcome::TooManyPoints;
    const Offset count = this->result.components.count();
    if (!status.ok() || taken >= any)
    {
      goesOn = mayGrow && count < any;
      return status;
    }
    if (mayGrow && count < taken)
    {
      status = this->refine(taken, control.part(0.2, 0.25), reached);
      if (!status.ok() || reached.how == ToleranceOutcome::Kept)
      {
        return status;
      }
    }
    status = this->tryCreases(finer, std::max(this->request.preparation.numberOfSites, taken),
      control.part(0.25, 0.3), reached, goesOn);
    return status.ok() && !goesOn && reached.how == ToleranceOutcome::TooManyPoints
      ? this->refine(any, control.part(0.3, 1.0), reached)
      : status;
  }

  /**
   * Whole runs, and refinement from there. Where creases are too small for the points, they are
   * refined as round ones, which can take many times as many: whenever those have doubled, finer
   * creases are looked for, and tried as soon as they take fewer.
   */
  Status search(Offset number, RunControl control, ToleranceOutcome& reached)
  {
    this->request.preparation.sitesForFeatures = number;
    Status status = this->approach(number, control.part(0.0, 0.3));
    for (bool goesOn = true; status.ok() && goesOn;)
    {
      control = control.part(0.3, 1.0);
      status = this->refineOrTryCreases(control, reached, goesOn);
    }
    return status;
  }

  /** What was reached. A bound that was proven in refinement holds, however far this one comes. */
  Status report(ToleranceOutcome::How reached, const RunControl& control)
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
      warning << "it takes more than the " << this->tolerance.maxPoints << " points allowed.";
    }
    else
    {
      warning << "more points do not help.";
    }
    if (!this->prepared.features)
    {
      warning << " Keeping features may.";
    }
    this->prepared.warnings.push_back(warning.str());
    return Status::success();
  }
};
}

Status remeshWithin(RunRequest request, const RunControl& control, RunOutcome& outcome)
{
  ToleranceRun run{ std::move(request), outcome };
  run.request.options.exactNumber = false;
  run.request.options.keepDiagram = true;
  PreparationRequest plain; // for the size alone
  plain.source = run.request.preparation.source;
  plain.mergeTolerance = run.request.preparation.mergeTolerance;
  plain.gaussMap = false;
  if (Status status = prepareSurface(plain, control.part(0.0, 0.03), run.prepared); !status.ok())
  {
    return status;
  }
  const double diagonal = boundingBoxDiagonal(run.prepared.mesh);
  run.tolerance.tolerance *= run.tolerance.isAbsolute ? 1.0 : diagonal;
  run.tolerance.isAbsolute = true;
  if (!(run.tolerance.tolerance >= minTolerance * diagonal))
  {
    std::ostringstream message;
    message << "The distance tolerance is " << run.tolerance.tolerance
            << "; it must be at least 1e-7 of the bounding box's diagonal, which is " << diagonal
            << ".";
    return Status::invalid(message.str());
  }
  run.request.options.maxCurveError = 0.25 * run.tolerance.tolerance;
  Offset number = std::min(pilotPoints, run.tolerance.maxPoints);
  Status status = run.pilots(control.part(0.03, 0.1), number);
  ToleranceOutcome reached;
  if (status.ok())
  {
    status = run.search(number, control.part(0.1, 0.95), reached);
  }
  RunControl last = control.part(0.95, 1.0);
  last.enterPhase("Distance", 0.0, 1.0);
  return status.ok() ? run.report(reached.how, last) : status;
}
}
