#include "Pipeline/NumberRun.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <tuple>
#include <utility>

namespace remesh
{
namespace
{
constexpr int maxWidenings = 2;            // of the radius over which normals are smoothed
constexpr double maxParts = 1.1;           // of cells, for each
constexpr double shareOfPreparation = 0.1; // of the progress of a run
constexpr double shareOfOthers = 0.4;      // of the progress, left to runs that may follow
constexpr double shareOfSmoothed = 0.1;    // likewise, where one will as a rule not

// What sites take at least, in bytes:
constexpr double vectors = 5.0;      // of n x d doubles: sites, trial, two moments, tree
constexpr double otherBytes = 600.0; // of each site: neighbours, sums, owners and the like

/** Asked before a run begins: later, the system may end it. `historyLength`: of the optimiser. */
Status checkMemory(Offset numberOfSites, int dimension, int historyLength, double memory)
{
  const double perCoordinate = vectors * sizeof(double) + historyBytes * (historyLength + 1);
  const double needed =
    static_cast<double>(numberOfSites) * (dimension * perCoordinate + otherBytes);
  if (!(memory > 0.0) || needed <= memory)
  {
    return Status::success();
  }
  const auto gigabytes = [](double bytes)
  { return std::to_string(static_cast<Offset>(std::ceil(bytes / 1e9))); };
  return { StatusCode::OutOfMemory,
    std::to_string(numberOfSites) + " points in " + std::to_string(dimension) +
      " dimensions need about " + gigabytes(needed) + " GB of memory; this machine has " +
      gigabytes(memory) + "." };
}

struct NumberRun
{
  RunRequest request;
  RunOutcome& outcome;
  bool mayEndEarly = false; ///< whether a run shall, where cells fall apart
  double filled = 0.0;      ///< how much of the progress the last run took
  RemeshResult::Seconds seconds = outcome.result.seconds; ///< of all runs, earlier ones, too
  int evaluations = outcome.result.evaluations;           ///< likewise

  /** The caller's sites, or a check that as many as are asked for can be held. */
  Status takeSites(const RunControl& control)
  {
    PreparedSurface& prepared = this->outcome.prepared;
    RemeshOptions& options = this->request.options;
    if (this->request.sites)
    {
      const Status status =
        placeSites(*this->request.sites, control, prepared, this->outcome.given);
      options.initialSites = std::move(this->outcome.given.sites);
      return status;
    }
    return options.numberOfSites <= maximumIndex
      ? checkMemory(options.numberOfSites, prepared.surface.dimension,
          historyWithin(prepared.surface, options.numberOfSites, options.quasiNewton.historyLength),
          this->request.memory)
      : Status::success(); // the core has its own word for that
  }

  /** Nothing is split for sites that are refused then. */
  bool canHoldSites() const
  {
    return this->request.sites ||
      (this->request.options.numberOfSites <= maximumIndex &&
        checkMemory(this->request.options.numberOfSites, 6, 0, this->request.memory).ok());
  }

  bool mayWiden() const
  {
    const PreparationRequest& preparation = this->request.preparation;
    return this->request.options.optimize &&
      this->request.options.lloydIterations + this->request.options.quasiNewton.iterations > 0 &&
      !this->request.sites && preparation.coordinates.empty() &&
      !(preparation.smoothingRadius >= 0.0);
  }

  /** Whether estimated normals were left as they are, of the run's own accord. */
  bool staysSharp() const
  {
    return this->request.preparation.mayStaySharp && this->outcome.prepared.smoothingRadius == 0.0;
  }

  /** Whether estimated normals are smoothed over less than the mean spacing of the sites in R^d. */
  bool mayBeWrinkled() const
  {
    const PreparedSurface& prepared = this->outcome.prepared;
    double area = 0.0;
    for (Index facet = 0; facet < prepared.surface.numberOfFacets(); ++facet)
    {
      area += prepared.surface.embeddedArea(facet);
    }
    const double spacing = prepared.surface.unit *
      std::sqrt(area / static_cast<double>(this->request.preparation.numberOfSites));
    return prepared.smoothingRadius && *prepared.smoothingRadius < spacing;
  }

  /** One run with normals smoothed `smoothing` times as far as usual. */
  Status make(double smoothing, const RunControl& control)
  {
    RemeshResult& result = this->outcome.result;
    result = RemeshResult{};
    const auto start = std::chrono::steady_clock::now();
    this->request.preparation.smoothing = smoothing;
    this->request.preparation.mayRefine &= this->canHoldSites();
    PreparedSurface& prepared = this->outcome.prepared;
    const double prepares = this->request.sites ? 0.5 * shareOfPreparation : shareOfPreparation;
    Status status =
      prepareSurface(this->request.preparation, control.part(0.0, prepares), prepared);
    if (status.ok())
    {
      status = this->takeSites(control.part(prepares, shareOfPreparation));
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    this->outcome.intakeSeconds += elapsed.count();
    if (status.ok())
    {
      const bool endsEarly = this->mayEndEarly && this->mayBeWrinkled();
      this->request.options.maxComponents =
        endsEarly ? maxParts : std::numeric_limits<double>::infinity();
      const double others = this->staysSharp() && this->mayWiden() ? shareOfSmoothed
        : endsEarly || smoothing > 1.0                             ? shareOfOthers
                                                                   : 0.0;
      this->filled = 1.0 - others;
      status = remesh({ prepared.mesh, prepared.surface, prepared.featuresOrNone(),
                        this->request.options, prepared.metricOrNone() },
        control.part(shareOfPreparation, this->filled), result);
    }
    this->seconds += result.seconds;
    this->evaluations += result.evaluations;
    return status;
  }

  /** Whether the topology is lost, or takes more points than there may be. */
  bool losesTopologyOrNumber() const
  {
    const RemeshResult& result = this->outcome.result;
    return result.topology.lost() || result.hasTooManyVertices(this->request.options);
  }

  Verdict verdict() const { return verdictOf(this->outcome.result, this->request.options); }

  /** Whether the mesh has faults that smoother normals may mend. */
  bool hasFaults() const
  {
    const Verdict verdict = this->verdict();
    return this->losesTopologyOrNumber() ||
      verdict.inverted + verdict.strays + verdict.refilled > 0;
  }

  /** Makes another mesh, too, by `make()`, and keeps it if it is better than the last one. */
  template <class Make>
  Status compareWith(const Make& make)
  {
    const Verdict lastVerdict = this->verdict();
    PreparedSurface lastPrepared = std::move(this->outcome.prepared);
    RemeshResult last = std::move(this->outcome.result);
    const Status status = withinMemory(make); // of two or three surfaces and results now
    if (status.code == StatusCode::Cancelled || (status.ok() && this->verdict() < lastVerdict))
    {
      return status;
    }
    this->outcome.result = std::move(last);
    this->outcome.prepared = std::move(lastPrepared);
    return Status::success();
  }

  /**
   * Runs with the normals as they are, if they may stay, and where these do not do with smoothed
   * ones, with one radius after the other, as far as they help.
   */
  Status makeWithRadii(const RunControl& control)
  {
    if (!this->mayWiden())
    {
      return this->make(1.0, control);
    }
    RunControl rest = control;
    for (int widening = 0;; ++widening)
    {
      this->mayEndEarly = widening < maxWidenings;
      const Status status = this->make(std::ldexp(1.0, widening), rest);
      rest = rest.part(this->filled, 1.0);
      const bool fallsApart = this->outcome.result.fallsApart;
      const bool wasSharp = this->staysSharp();
      this->request.preparation.mayStaySharp = false;
      if (status.ok() && wasSharp && (fallsApart || this->hasFaults()))
      {
        const auto makeSmoothed = [&]() { return this->makeWithRadii(rest); };
        return fallsApart ? makeSmoothed() : this->compareWith(makeSmoothed);
      }
      if (!status.ok() || !fallsApart)
      {
        const auto makeFirst = [&]()
        {
          this->mayEndEarly = false;
          return this->make(1.0, rest);
        };
        const bool compares = status.ok() && widening > 0 && this->losesTopologyOrNumber();
        return compares ? this->compareWith(makeFirst) : status;
      }
    }
  }
};

/** The number of points that the metric asks for. */
Status takeUnitNumber(const RunControl& control, RunRequest& request)
{
  Offset number = 0;
  const Status status = findUnitNumber(
    request.preparation, request.unit.complexity, control, number, request.preparation.metricUnit);
  request.options.numberOfSites = number;
  request.preparation.numberOfSites = number;
  if (request.tolerance.extraIsOnePercent)
  {
    request.options.maximumExtraPoints = number / 100;
  }
  return status;
}
}

Status remeshWithNumber(RunRequest request, const RunControl& control, RunOutcome& outcome)
{
  Status status = request.unit.isUnit ? takeUnitNumber(control, request) : Status::success();
  if (!status.ok())
  {
    return status;
  }
  NumberRun run{ std::move(request), outcome };
  status = run.makeWithRadii(control);
  outcome.result.seconds = run.seconds;
  outcome.result.evaluations = run.evaluations;
  return status;
}
}
