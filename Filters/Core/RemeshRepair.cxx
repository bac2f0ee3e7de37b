#include "RemeshRepair.h"

#include "Delaunay/FeatureRepair.h"
#include "Delaunay/TopologyRepair.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace remesh
{
namespace
{
constexpr int mostRepairs = 32;      // in each stage
constexpr int mostIdleRepairs = 8;   // since one that came nearer than all before
constexpr int settledRepairs = 2;    // later ones change nothing but what they must
constexpr int roundsBetweenCuts = 4; // of tips
constexpr double mostFailures = 0.1; // of the vertices; with more, there is no use in going on
constexpr int mostRefinements = 10;  // rounds in which free sites may join curves
/** Settling after later ones would only bring others to the curves. */
constexpr int settledRefinements = 4;
constexpr int mostAdjustments = 10;   // of the number of vertices
constexpr int settledAdjustments = 4; // later ones change nothing but what they must
constexpr int mostFlipRounds = 8;     // in which sites go to flipped triangles
constexpr double fewFlips = 5e-5;     // of the triangles: left to turned edges if these mend them
constexpr double noSides = 0.25;      // of the triangles flipped: as if sides were drawn by lot
constexpr int mostRepairsOfFlips = 4; // rounds to repair the topology after

/** Adds these sites, and others or none, so that the mesh has as many vertices as wanted. */
Index revise(Refinement refinement, const Certificate& failures, Offset wanted, const Task& task,
  Repair& repair, RemeshResult& result)
{
  // Without hope for the topology at least the number shall be right.
  const bool keepNone = repair.stage == RepairStage::GivenUp && repair.flipRounds == 0;
  const Index kept = keepNone ? 0 : repair.counts.addedSites;
  const Revision revision =
    reviseSites({ task.surface, result.sites, result.diagram }, result.components, result.dual,
      failures, result.sums, std::move(refinement), wanted, kept, result.sites);
  repair.counts.addedSites += revision.added;
  return revision.added + revision.removed;
}

/** Where so much of the mesh fails, other sites are no use: there are too few. */
bool isHopeless(Offset failures, const RemeshResult& result)
{
  return static_cast<double>(failures) >
    mostFailures * static_cast<double>(result.components.count());
}

/** The stage after this one; where most of the mesh fails only many more points help. */
RepairStage nextStage(const Task& task, const Repair& repair, const RemeshResult& result)
{
  const Offset extra = task.options.maximumExtraPoints;
  const bool hopeless = isHopeless(repair.fewestFailures, result);
  if (repair.stage == RepairStage::Refine && !hopeless)
  {
    return RepairStage::CutTips;
  }
  return repair.stage != RepairStage::BeyondNumber && extra > 0 &&
      (!hopeless || extra > repair.fewestFailures)
    ? RepairStage::BeyondNumber
    : RepairStage::GivenUp;
}

/** Curves where these reach them; the number of vertices is brought to what it shall be at once. */
Index repairCurves(const Task& task, const std::vector<Intrusion>& intrusions,
  const RunControl& control, Repair& repair, RemeshResult& result)
{
  const Offset before = result.featureSites.numberOfPoints();
  Refinement refinement;
  const Index touched = refineCurves(task.mesh, task.surface, *task.features, intrusions,
    result.sites, task.mostPointsOnFeatures(result.numberOfVertexSites()), control, result.stations,
    result.featureSites, refinement.removed);
  if (touched > 0)
  {
    const Offset joining = static_cast<Offset>(refinement.removed.size());
    const Offset onCurves = result.featureSites.numberOfPoints() - before;
    // What is new on curves is no vertex of the diagram yet.
    const Offset least = leastVertices(result);
    const Offset wanted = task.options.exactNumber
      ? std::max(task.options.numberOfSites - onCurves, least) + repair.counts.extraPoints
      : result.components.count() - joining;
    revise(std::move(refinement), result.topology.certificate, wanted, task, repair, result);
    replaceFixed(result.featureSites, result.sites);
  }
  return touched;
}

/**
 * Where cells of sites on features reach another feature, or the same one farther along, and the
 * certificate fails. Elsewhere their triangles with the collar are no harm.
 */
std::vector<Intrusion> failingEncroachments(const RemeshResult& result)
{
  const std::vector<Index> failing = failingComponents(result.topology.certificate);
  std::vector<Intrusion> found;
  std::copy_if(result.seams.encroachments.begin(), result.seams.encroachments.end(),
    std::back_inserter(found),
    [&](const Intrusion& intrusion)
    { return std::binary_search(failing.begin(), failing.end(), intrusion.component); });
  return found;
}

/**
 * Places on curves there, if that does not take more vertices than asked for and those that may be
 * added by now, or if they all do.
 */
Index repairEncroachments(
  const Task& task, const RunControl& control, Repair& repair, RemeshResult& result)
{
  const std::vector<Intrusion> found = failingEncroachments(result);
  std::set<std::pair<Index, Index>> sections; // each is divided once at most
  for (const Intrusion& intrusion : found)
  {
    sections.emplace(intrusion.curve, intrusion.section);
  }
  const Offset least = leastVertices(result);
  const Offset asked = task.options.numberOfSites;
  const Offset extra = repair.stage == RepairStage::BeyondNumber
    ? task.options.maximumExtraPoints - repair.counts.extraPoints
    : 0;
  const bool fits = !task.options.exactNumber || least > asked ||
    least + static_cast<Offset>(sections.size()) <= asked + extra;
  return fits && !found.empty() ? repairCurves(task, found, control, repair, result) : 0;
}

/** Whether this way of repairing has been tried as often as may be. */
bool stageEnds(const Repair& repair)
{
  return repair.flipRounds > 0
    ? repair.rounds >= mostRepairsOfFlips
    : repair.rounds >= mostRepairs || repair.idleRounds > mostIdleRepairs;
}

/**
 * The next stage begins with the best state.
 *
 * @return whether that is another than the one at hand.
 */
bool enterNextStage(const Task& task, Repair& repair, RemeshResult& result)
{
  const bool wasForFlips = repair.flipRounds > 0;
  repair.stage = wasForFlips ? RepairStage::GivenUp : nextStage(task, repair, result);
  repair.flipRounds = wasForFlips ? mostFlipRounds : 0;
  repair.rounds = 0;
  repair.idleRounds = 0;
  repair.wentBack = shareSites(result, repair) != repair.best.sites;
  restoreState(repair, result); // its counts, too, where the sites are the same
  return repair.wentBack;
}

/** Sites for where the certificate fails. */
Index repairTopology(
  const Task& task, const RunControl& control, Repair& repair, RemeshResult& result)
{
  if (repair.stage == RepairStage::GivenUp)
  {
    return 0;
  }
  if (stageEnds(repair))
  {
    return enterNextStage(task, repair, result) ? 1 : repairTopology(task, control, repair, result);
  }
  const bool cutTips =
    repair.stage == RepairStage::CutTips && repair.rounds % roundsBetweenCuts == 0;
  ++repair.rounds;
  Refinement refinement = refineTopology({ task.surface, result.sites, result.diagram },
    result.components, result.dual, result.topology.certificate, cutTips);
  const auto count = static_cast<Offset>(refinement.added.size()) / task.surface.dimension;
  const Offset extra = repair.stage == RepairStage::BeyondNumber && repair.flipRounds == 0
    ? std::min(count, task.options.maximumExtraPoints - repair.counts.extraPoints)
    : 0;
  const Offset before = wantedVertices(task.options, result, repair);
  repair.counts.extraPoints += extra;
  repair.idleRounds = extra > 0 ? 0 : repair.idleRounds;
  const Index touched = revise(
    std::move(refinement), result.topology.certificate, before + extra, task, repair, result);
  if (touched > 0)
  {
    return touched;
  }
  // There is nothing to add, or there are no sites to take away for it.
  if (const Index onCurves = repairEncroachments(task, control, repair, result); onCurves > 0)
  {
    return onCurves;
  }
  repair.rounds = mostRepairs;
  return repairTopology(task, control, repair, result);
}
}

std::vector<Index> flippedTriangles(
  const Task& task, FlipSteps steps, const RunControl& control, const RemeshResult& result)
{
  const std::vector<char> fixed = verticesOnFeatures(result.seams, result.components.count());
  const PlacementProblem problem{ task.mesh, task.surface, result.sites, result.diagram,
    result.components, result.dual.triangles, fixed, &result.seams.segments };
  const NearbySurface surface(problem);
  FlipSearch search(surface);
  std::vector<Index> flipped;
  Status status = search.find(result.dual.triangles, result.components.centroids, control, flipped);
  if (!status.ok() || flipped.empty())
  {
    return {};
  }
  if (flipped.size() > noSides * static_cast<double>(result.dual.triangles.size()))
  {
    return flipped; // no steps would be worth their time
  }
  std::vector<Point3> positions = result.components.centroids;
  std::vector<Triple> triangles = result.dual.triangles;
  FlipRepair repair;
  status = repairFlips(problem, surface, result.components.centroids, result.components.centroids,
    steps, control, search, triangles, positions, repair);
  if (!status.ok() || repair.flippedTriangles == 0)
  {
    return {};
  }
  status = search.find(triangles, positions, control, flipped);
  return status.ok() ? flipped : std::vector<Index>();
}

namespace
{
/** Whether two rounds of sites for flipped triangles have not even halved their number. */
bool helpsNoMore(const Repair& repair)
{
  const std::vector<Offset>& before = repair.flipsBefore;
  return before.size() >= 2 && 2 * repair.counts.flips > before[before.size() - 2];
}

/** Sites for where triangles are flipped; others are taken away. */
Index repairFlips(const Task& task, const RunControl& control, Repair& repair, RemeshResult& result)
{
  const std::vector<Index> flipped = flippedTriangles(task, FlipSteps::Move, control, result);
  repair.counts.flips = static_cast<Offset>(flipped.size());
  if (repair.flipRounds == 0 && !result.topology.certificate.holds())
  {
    repair.counts.flips = 0;
    if (scoreOf(task.options, result, repair) > repair.scoreOfBest)
    {
      return 0; // the best one is restored in the end
    }
    repair.scoreOfBest = worstScore; // flipped triangles were not counted yet
    repair.counts.flips = static_cast<Offset>(flipped.size());
  }
  keepBest(task.options, result, repair);
  if (repair.flipRounds >= mostFlipRounds || helpsNoMore(repair) ||
    isHopeless(repair.counts.flips, result))
  {
    return 0;
  }
  const double few = fewFlips * static_cast<double>(result.dual.triangles.size());
  const bool turnsMend = static_cast<double>(repair.counts.flips) <= few &&
    flippedTriangles(task, FlipSteps::MoveAndTurn, control, result).empty();
  if (flipped.empty() || turnsMend)
  {
    return 0;
  }
  ++repair.flipRounds;
  repair.flipsBefore.push_back(repair.counts.flips);
  repair.rounds = 0;
  repair.idleRounds = 0;
  repair.adjustments = std::min(repair.adjustments, settledAdjustments);
  Certificate failures;
  for (const Index t : flipped)
  {
    failures.vertices.push_back(result.dual.triangles[t]);
  }
  const Offset wanted = wantedVertices(task.options, result, repair);
  Refinement refinement = refineTriangles(
    { task.surface, result.sites, result.diagram }, result.components, result.dual, flipped);
  return refinement.added.empty()
    ? 0
    : revise(std::move(refinement), failures, wanted, task, repair, result);
}
}

Index mend(const Task& task, const RunControl& control, Repair& repair, RemeshResult& result)
{
  repair.wentBack = false;
  if (task.features && repair.refinements < mostRefinements)
  {
    if (const Index touched = repairCurves(task, result.seams.intrusions, control, repair, result);
        touched > 0)
    {
      ++repair.refinements;
      return touched;
    }
  }
  if (!result.topology.certificate.holds() && repair.stage != RepairStage::GivenUp)
  {
    repair.counts.flips = 0;
    keepBest(task.options, result, repair);
    if (const Index touched = repairTopology(task, control, repair, result); touched > 0)
    {
      repair.adjustments = std::min(repair.adjustments, settledAdjustments);
      return touched;
    }
  }
  const Offset wanted = wantedVertices(task.options, result, repair);
  if (task.options.exactNumber && repair.adjustments < mostAdjustments &&
    result.components.count() != wanted)
  {
    // Where cells reach several parts of the surface, others may come to do so with each that goes.
    keepIfBest(task.options, result, repair);
    ++repair.adjustments;
    if (const Index touched = revise({}, result.topology.certificate, wanted, task, repair, result);
        touched > 0)
    {
      return touched;
    }
  }
  return repairFlips(task, control, repair, result);
}

bool leavesUnsettled(const Repair& repair)
{
  return repair.othersStay || repair.adjustments > settledAdjustments ||
    repair.stage != RepairStage::Refine || repair.rounds > settledRepairs || repair.flipRounds > 0;
}

bool othersMustStay(const Repair& repair)
{
  return leavesUnsettled(repair) || repair.refinements > settledRefinements;
}
}
