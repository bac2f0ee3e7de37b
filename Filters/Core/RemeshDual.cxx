#include "RemeshDual.h"

#include "Delaunay/FeatureRepair.h"
#include "Delaunay/TopologyRepair.h"
#include "Embedding/Embedding.h"
#include "Features/FeatureGraph.h"
#include "Optimization/FixedSites.h"
#include "Optimization/Lloyd.h"
#include "Voronoi/RestrictedVoronoi.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace remesh
{
namespace
{
constexpr int mostRepairs = 32;      // in each stage
constexpr int mostIdleRepairs = 8;   // since one that was better than all before
constexpr int settledRepairs = 2;    // later ones change nothing but what they must
constexpr int roundsBetweenCuts = 4; // of tips
constexpr double mostFailures = 0.1; // of the vertices; with more, there is no use in going on
constexpr int mostRefinements = 10;  // rounds in which free sites may join curves
/** Settling after later ones only brings others to the curves. */
constexpr int settledRefinements = 1;
constexpr int mostAdjustments = 6;
constexpr int settledAdjustments = 2; // later ones change nothing but what they must
constexpr int settlingSteps = 2;      // of Lloyd, after each
constexpr int mostSmoothings = 2;     // in the end, if sites were changed without such steps

/** The dual of the diagram, and whether it is proven to be like the surface. */
Status dualize(const Task& task, const std::vector<Index>& owners, const RunControl& control,
  RemeshResult& result)
{
  Status status =
    findComponents(task.mesh, task.surface, result.sites, result.edges, result.diagram, owners,
      control.step(0, 3), result.components, task.features ? &result.featureSites : nullptr);
  if (status.ok() && task.features)
  {
    result.seams = sewAlongFeatures(result.diagram, result.components, task.mesh, task.surface,
      *task.features, result.stations, result.featureSites, result.sites);
  }
  if (status.ok())
  {
    status = buildDual(result.diagram, result.components, control.step(1, 3), result.dual,
      task.features ? &result.seams : nullptr);
  }
  if (status.ok() && task.features)
  {
    status = dropHangingTriangles(result.components, result.seams, control, result.dual);
  }
  if (status.ok())
  {
    status = certify(task.surface, result.edges, result.diagram, result.components, result.dual,
      task.features ? &result.seams : nullptr, control.step(2, 3), result.topology.certificate);
  }
  return status;
}

/** What else is told of the cells. */
Status describeCells(const Task& task, const RunControl& control, RemeshResult& result)
{
  if (Status status = countNeighbors(result.diagram, result.components, result.sites.count(),
        control, result.numbersOfNeighbors);
      !status.ok())
  {
    return status;
  }
  return locateOnSurface(task.mesh, result.diagram, result.components, control, result.locations);
}

/** The exact diagram of the sites and its dual. */
Status diagramAndDual(const Task& task, const RunControl& control, RemeshResult& result)
{
  std::vector<Index> owners;
  {
    // Begun afresh, the diagram depends on the sites alone, and not on the way they came; ended
    // here, its lists and sums make room for the dual.
    RestrictedVoronoi voronoi(task.surface);
    if (Status status =
          voronoi.decompose(result.sites, control.step(0, 2), result.sums, result.diagram);
        !status.ok())
    {
      return status;
    }
    result.emptyCells = countEmptyFree(result.sites, result.sums);
    result.evaluations += voronoi.evaluations();
    owners = voronoi.owners();
  }
  return dualize(task, owners, control.step(1, 2), result);
}

/** The surface's edges, as it is cut, and its topology. */
Status knowSurface(const Task& task, const RunControl& control, RemeshResult& result)
{
  result.edges = task.features ? buildCutEdgeTable(task.mesh, *task.features)
                               : buildEdgeTable(task.mesh.facetPoints, control);
  return control.cancelled() ? Status::cancelled()
                             : measureConnectivity(task.mesh.facetPoints,
                                 task.features ? task.features->edges : result.edges,
                                 task.mesh.numberOfPoints(), control, result.topology.surface);
}

/** A few Lloyd steps after sites were moved. */
Status settle(const EmbeddedSurface& surface, std::uint64_t seed, const RunControl& control,
  RemeshResult& result)
{
  RestrictedVoronoi voronoi(surface);
  Convergence apart; // not the optimisation's
  Status status = relaxLloyd(voronoi, surface, settlingSteps, seed, control, result.sites,
    result.sums, apart, result.emptyCells);
  roundToCaller(surface, result.sites);
  result.evaluations += voronoi.evaluations();
  return status;
}

/** What a state of the sites is made of. */
struct SiteState
{
  Sites sites;
  Stations stations;
  FeatureSites featureSites;
  Index addedSites = 0; ///< by repairs; about the last ones there are
  Offset extraPoints = 0;
};

/** How the topology is repaired, one after the other. */
enum class RepairStage
{
  Refine,       ///< add sites, take away others
  CutTips,      ///< now and then leave thin tips to the cells around them
  BeyondNumber, ///< add sites
  GivenUp
};

/** How many vertices there are too many or too few, and where the certificate fails; lower is
 * better. */
using Score = std::pair<Offset, Offset>;

/** What was mended how often, each with its own bound, and the best state so far. */
struct Repair
{
  int refinements = 0;
  int adjustments = 0;
  RepairStage stage = RepairStage::Refine;
  int rounds = 0;     ///< in this stage
  int idleRounds = 0; ///< in this stage, since one with fewer failures than all before
  Offset fewestFailures = std::numeric_limits<Offset>::max();
  Index addedSites = 0;
  Offset extraPoints = 0;
  bool unsettled = false; ///< sites were changed without Lloyd's steps after

  SiteState best;
  Score scoreOfBest = { std::numeric_limits<Offset>::max(), 0 };
};

void keepState(const RemeshResult& result, Repair& repair)
{
  repair.best = { result.sites, result.stations, result.featureSites, repair.addedSites,
    repair.extraPoints };
}

void restoreState(Repair& repair, RemeshResult& result)
{
  result.sites = repair.best.sites;
  result.stations = repair.best.stations;
  result.featureSites = repair.best.featureSites;
  repair.addedSites = repair.best.addedSites;
  repair.extraPoints = repair.best.extraPoints;
}

Score scoreOf(const RemeshOptions& options, const RemeshResult& result, const Repair& repair)
{
  const Offset beyond = result.components.count() - options.numberOfSites;
  return { options.exactNumber ? std::max({ Offset(0), -beyond, beyond - repair.extraPoints }) : 0,
    result.topology.certificate.violations() };
}

/** Keeps the state if it is the best so far. */
void keepBest(const RemeshOptions& options, const RemeshResult& result, Repair& repair)
{
  const Offset failures = result.topology.certificate.violations();
  repair.idleRounds = failures < repair.fewestFailures ? 0 : repair.idleRounds + 1;
  repair.fewestFailures = std::min(repair.fewestFailures, failures);
  if (const Score score = scoreOf(options, result, repair); score < repair.scoreOfBest)
  {
    repair.scoreOfBest = score;
    keepState(result, repair);
  }
}

/** Adds these sites, and others or none, so that the mesh has as many vertices as wanted. */
Index revise(
  Refinement refinement, Offset wanted, const Task& task, Repair& repair, RemeshResult& result)
{
  // Without hope for the topology at least the number shall be right.
  const Index kept = repair.stage == RepairStage::GivenUp ? 0 : repair.addedSites;
  const Revision revision =
    reviseSites({ task.surface, result.sites, result.diagram }, result.components, result.dual,
      result.topology.certificate, result.sums, std::move(refinement), wanted, kept, result.sites);
  repair.addedSites += revision.added;
  return revision.added + revision.removed;
}

/** The stage after this one; where most of the mesh fails only many more points help. */
RepairStage nextStage(const Task& task, const Repair& repair, Offset numberOfVertices)
{
  const Offset extra = task.options.maximumExtraPoints;
  const bool hopeless = static_cast<double>(repair.fewestFailures) >
    mostFailures * static_cast<double>(numberOfVertices);
  if (repair.stage == RepairStage::Refine && !hopeless)
  {
    return RepairStage::CutTips;
  }
  return repair.stage != RepairStage::BeyondNumber && extra > 0 &&
      (!hopeless || extra > repair.fewestFailures)
    ? RepairStage::BeyondNumber
    : RepairStage::GivenUp;
}

/** Sites for where the certificate fails. */
Index repairTopology(const Task& task, Repair& repair, RemeshResult& result)
{
  if (repair.stage == RepairStage::GivenUp)
  {
    return 0;
  }
  if (repair.rounds >= mostRepairs || repair.idleRounds > mostIdleRepairs)
  {
    repair.stage = nextStage(task, repair, result.components.count());
    repair.rounds = 0;
    repair.idleRounds = 0;
    if (result.topology.certificate.violations() < repair.scoreOfBest.second)
    {
      return repairTopology(task, repair, result);
    }
    restoreState(repair, result);
    return 1;
  }
  const bool cutTips =
    repair.stage == RepairStage::CutTips && repair.rounds % roundsBetweenCuts == 0;
  ++repair.rounds;
  Refinement refinement = refineTopology({ task.surface, result.sites, result.diagram },
    result.components, result.dual, result.topology.certificate, cutTips);
  const auto count = static_cast<Offset>(refinement.added.size()) / task.surface.dimension;
  const Offset extra = repair.stage == RepairStage::BeyondNumber
    ? std::min(count, task.options.maximumExtraPoints - repair.extraPoints)
    : 0;
  const Offset before = task.options.exactNumber ? task.options.numberOfSites + repair.extraPoints
                                                 : result.components.count();
  repair.extraPoints += extra;
  repair.idleRounds = extra > 0 ? 0 : repair.idleRounds;
  const Index touched = revise(std::move(refinement), before + extra, task, repair, result);
  if (touched == 0) // there are no sites to take away
  {
    repair.rounds = mostRepairs;
    return repairTopology(task, repair, result);
  }
  return touched;
}

/** What can be mended still, the first of these that finds anything. Returns sites touched. */
Index mend(const Task& task, Repair& repair, RemeshResult& result)
{
  if (task.features && repair.refinements < mostRefinements)
  {
    const Index touched = refineCurves(task.mesh, task.surface, *task.features, result.seams,
      result.stations, result.featureSites, result.sites);
    if (touched > 0)
    {
      ++repair.refinements;
      return touched;
    }
  }
  if (!result.topology.certificate.holds())
  {
    keepBest(task.options, result, repair);
    if (const Index touched = repairTopology(task, repair, result); touched > 0)
    {
      repair.adjustments = std::min(repair.adjustments, settledAdjustments);
      return touched;
    }
  }
  const Offset wanted = task.options.numberOfSites + repair.extraPoints;
  if (task.options.exactNumber && repair.adjustments < mostAdjustments &&
    result.components.count() != wanted)
  {
    ++repair.adjustments;
    return revise({}, wanted, task, repair, result);
  }
  return 0;
}

/** Diagram and dual, again and again while there is something to mend. */
Status mendAll(const Task& task, RunControl rest, Repair& repair, RemeshResult& result)
{
  const RemeshOptions& options = task.options;
  const bool mayRepair = options.optimize &&
    options.lloydIterations + options.quasiNewton.iterations > 0 &&
    (task.features || result.topology.surface.nonManifoldEdges == 0);
  for (;; rest = rest.step(1, 2)) // each round fills half of the progress that is left
  {
    Stopwatch watch;
    if (Status status = diagramAndDual(task, rest.step(0, 2), result); !status.ok())
    {
      return status;
    }
    result.seconds.diagram += watch.lap();
    const Index moved = mayRepair ? mend(task, repair, result) : 0;
    if (moved == 0)
    {
      break;
    }
    result.movedSites += moved;
    const bool repaired = repair.adjustments > settledAdjustments ||
      repair.stage != RepairStage::Refine || repair.rounds > settledRepairs;
    if (repaired || repair.refinements > settledRefinements)
    {
      repair.unsettled |= repaired;
      roundToCaller(task.surface, result.sites); // nothing is to change but what was touched
      continue;
    }
    if (Status status = settle(task.surface, options.seed, rest.silent(), result); !status.ok())
    {
      return status;
    }
    result.seconds.repair += watch.lap();
  }
  if (result.topology.certificate.holds() || scoreOf(options, result, repair) < repair.scoreOfBest)
  {
    return Status::success();
  }
  restoreState(repair, result);
  return diagramAndDual(task, rest.silent(), result);
}

/** Spreads the sites evenly where some were taken away, as far as nothing breaks. */
Status smooth(const Task& task, const RunControl& control, Repair& repair, RemeshResult& result)
{
  Stopwatch watch;
  bool broken = !repair.unsettled || !result.topology.certificate.holds();
  for (int round = 0; round < mostSmoothings && !broken; ++round)
  {
    const Index count = result.components.count();
    const std::size_t intrusions = result.seams.intrusions.size();
    keepState(result, repair);
    const std::vector<Index> staying =
      sitesAroundAdded(result.components, result.dual, result.sites.count(), repair.addedSites);
    Status status = settle(task.surface, task.options.seed, control, result);
    if (status.ok())
    {
      for (const Index site : staying)
      {
        std::copy_n(repair.best.sites.site(site), task.surface.dimension, result.sites.site(site));
      }
      status = diagramAndDual(task, control, result);
    }
    broken = !result.topology.certificate.holds() || result.components.count() != count ||
      result.seams.intrusions.size() > intrusions;
    if (status.ok() && broken)
    {
      restoreState(repair, result);
      status = diagramAndDual(task, control, result);
    }
    if (!status.ok())
    {
      return status;
    }
  }
  result.seconds.repair += watch.lap();
  return Status::success();
}
}

Status findDual(const Task& task, const RunControl& control, RemeshResult& result)
{
  Repair repair;
  Status status = knowSurface(task, control.silent(), result);
  if (status.ok())
  {
    status = mendAll(task, control, repair, result);
  }
  if (status.ok())
  {
    status = smooth(task, control.silent(), repair, result);
  }
  if (!status.ok())
  {
    return status;
  }
  result.wantedVertices = task.options.exactNumber
    ? task.options.numberOfSites
    : result.numberOfVertexSites() - result.emptyCells - repair.extraPoints;
  return describeCells(task, control.silent(), result);
}
}
