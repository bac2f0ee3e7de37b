#include "RemeshRepair.h"

#include "Delaunay/FeatureRepair.h"
#include "Delaunay/SiteRevision.h"
#include "Delaunay/TopologyRepair.h"
#include "Placement/StrayTriangles.h"
#include "RemeshFacing.h"
#include "Support/SortUnique.h"

#include <algorithm>
#include <iterator>
#include <limits>
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
constexpr int mostFlipRounds = 8; // in which sites, or places on curves, go to flipped triangles
constexpr double fewFlips = 5e-5; // of the triangles: left to turned edges
constexpr int mostRepairsOfFlips = 4; // rounds to repair the topology after

/** Sites where the certificate fails, or all that reach curves if more do than may; ascending. */
std::vector<Index> failingSites(const RemeshResult& result, std::size_t mostIntrusions)
{
  std::vector<Index> failing = failingComponents(result.topology.certificate);
  for (Index& component : failing)
  {
    component = result.components.sites[component];
  }
  if (result.seams.intrusions.size() > mostIntrusions)
  {
    for (const Intrusion& intrusion : result.seams.intrusions)
    {
      failing.push_back(intrusion.site);
    }
  }
  sortUnique(failing);
  return failing;
}

/** Adds these sites, and others or none, so that the mesh has as many vertices as wanted. */
Index revise(Refinement refinement, const Certificate& failures, Offset wanted, const Task& task,
  Repair& repair, RemeshResult& result)
{
  // Without hope for the topology at least the number shall be right.
  const bool keepNone = repair.stage == RepairStage::GivenUp && repair.flipRounds == 0;
  const Revision revision = reviseSites({ task.surface, result.sites, result.diagram },
    result.components, result.dual, failures, result.sums, std::move(refinement), wanted,
    repair.counts.addedSites, result.sites, !keepNone);
  repair.counts.addedSites += revision.added - revision.removedLast;
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
  if (repair.stage < RepairStage::Persist && !hopeless)
  {
    return repair.stage == RepairStage::Refine ? RepairStage::CutTips : RepairStage::Persist;
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
  const Offset vertices = std::max(task.options.numberOfSites, result.numberOfVertexSites());
  const Offset most = task.mostPointsOnFeatures(vertices, result.shareApart);
  Refinement refinement;
  const Index touched = refineCurves(task.featured(), intrusions, result.sites,
    result.curvesAreApart, most, control, result.featureSites, refinement.removed);
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

/** The sections of curves that these reach. */
Offset countSections(const std::vector<Intrusion>& intrusions)
{
  std::set<std::pair<Index, Index>> sections;
  for (const Intrusion& intrusion : intrusions)
  {
    sections.emplace(intrusion.curve, intrusion.section);
  }
  return static_cast<Offset>(sections.size());
}

/**
 * Places on curves there, if that does not take more vertices than asked for and those that may be
 * added by now, or if they all do.
 */
Index repairEncroachments(
  const Task& task, const RunControl& control, Repair& repair, RemeshResult& result)
{
  const std::vector<Intrusion> found = failingEncroachments(result);
  const Offset least = leastVertices(result);
  const Offset asked = task.options.numberOfSites;
  const Offset extra = repair.stage == RepairStage::BeyondNumber
    ? task.options.maximumExtraPoints - repair.counts.extraPoints
    : 0;
  const bool fits = !task.options.exactNumber || least > asked ||
    least + countSections(found) <= asked + extra; // each is divided once at most
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
  repair.failingMass = std::numeric_limits<double>::infinity();
  repair.failingShare = std::numeric_limits<double>::infinity();
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
  const Offset before = wantedVertices(task.options, result, repair);
  // More than wanted, as components and patches take some each, none of which can be taken away.
  const Offset surplus = std::max(Offset(0), result.components.count() - before);
  const Offset extra = repair.stage == RepairStage::BeyondNumber && repair.flipRounds == 0
    ? std::min(count + surplus, task.options.maximumExtraPoints - repair.counts.extraPoints)
    : 0;
  repair.counts.extraPoints += extra;
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

/**
 * Takes sites that were added for the topology, and are of no use, to where they are. Where not the
 * number of vertices is given, but that of sites, they stay.
 */
Index pruneSites(const Task& task, Repair& repair, RemeshResult& result)
{
  SitePruning& pruning = repair.pruning;
  const bool isUndone = pruning.isTrying() &&
    !pruning.judge(result.topology.certificate.holds(), failingSites(result, repair.intrusions),
      result.components.count());
  if (!isUndone)
  {
    repair.intrusions = result.seams.intrusions.size();
    const bool mayPrune = task.options.exactNumber && !repair.othersStay && repair.flipRounds == 0;
    if (!mayPrune || !result.topology.certificate.holds() ||
      !pruning.choose({ task.surface, result.sites, result.diagram }, result.components,
        result.dual,
        { shareSites(result, repair), repair.counts.addedSites, result.components.count(),
          wantedVertices(task.options, result, repair), repair.counts.extraPoints }))
    {
      return 0;
    }
  }
  SitePruning::Trial trial = pruning.next();
  result.sites = std::move(trial.sites);
  repair.counts.addedSites = trial.added;
  repair.counts.extraPoints = trial.extraPoints;
  return 1;
}

/** Whether two rounds of sites have not even halved what they were for. */
bool helpsNoMore(const std::vector<Offset>& before, Offset now)
{
  return before.size() >= 2 && 2 * now > before[before.size() - 2];
}

/**
 * Strays as the score counts them: as long as there are not half as many as at first, as many.
 * Where the surface goes through itself, sites help nothing, and would be missed elsewhere.
 */
Offset countStrays(const Repair& repair, Offset strays)
{
  const Offset first = repair.straysBefore.empty() ? strays : repair.straysBefore.front();
  return 2 * strays <= first ? strays : first;
}

void enterFlipRound(Repair& repair)
{
  ++repair.flipRounds;
  repair.rounds = 0;
  repair.idleRounds = 0;
  repair.adjustments = std::min(repair.adjustments, settledAdjustments);
}

/** Sites for these triangles; others are taken away. */
Index refineAt(
  const std::vector<Index>& triangles, const Task& task, Repair& repair, RemeshResult& result)
{
  Certificate failures;
  for (const Index t : triangles)
  {
    failures.vertices.push_back(result.dual.triangles[t]);
  }
  const Offset wanted = wantedVertices(task.options, result, repair);
  Refinement refinement = refineTriangles(
    { task.surface, result.sites, result.diagram }, result.components, result.dual, triangles);
  return refinement.added.empty()
    ? 0
    : revise(std::move(refinement), failures, wanted, task, repair, result);
}

/**
 * Places on curves that are too coarse for flipped triangles, if that takes neither more vertices
 * than there may be, which would be worse, nor free sites that stay.
 */
Index divideAtFlipped(const std::vector<Index>& flipped, const Task& task,
  const RunControl& control, Repair& repair, RemeshResult& result)
{
  if (!task.features)
  {
    return 0;
  }
  std::vector<Triple> triangles;
  for (const Index t : flipped)
  {
    triangles.push_back(result.dual.triangles[t]);
  }
  const std::vector<Intrusion> coarse = coarseSections(
    triangles, result.components, result.seams, task.featured(), result.featureSites, control);
  const Offset taken = leastVertices(result) + repair.leastFree + countSections(coarse);
  const bool fits =
    !task.options.exactNumber || taken <= task.options.numberOfSites + repair.counts.extraPoints;
  return fits && !control.cancelled() ? repairCurves(task, coarse, control, repair, result) : 0;
}

/** Places on curves and sites for where triangles are flipped, and then sites for strays. */
Index repairFlips(const Task& task, const RunControl& control, Repair& repair, RemeshResult& result)
{
  RepairCounts& counts = repair.counts;
  const auto [found, flipped] = flippedTriangles(task, FlipSteps::Move, control, result);
  counts.flips = static_cast<Offset>(flipped.size());
  counts.strays = 0;
  if (repair.flipRounds == 0 && !result.topology.certificate.holds())
  {
    counts.flips = 0;
    if (scoreOf(task.options, result, repair) > repair.scoreOfBest)
    {
      return 0; // the best one is restored in the end
    }
    repair.scoreOfBest = worstScore; // flipped triangles were not counted yet
    counts.flips = static_cast<Offset>(flipped.size());
  }
  const auto size = static_cast<Offset>(result.dual.triangles.size());
  const bool hopeless = isHopeless(counts.flips, result);
  const std::vector<Index> wrong =
    hopeless ? flipped : wrongTriangles(task, found, control, result);
  counts.strays =
    countStrays(repair, std::max(static_cast<Offset>(wrong.size()) - counts.flips, Offset(0)));
  keepBest(task.options, result, repair);
  if (repair.flipRounds >= mostFlipRounds || hopeless)
  {
    return 0;
  }
  const auto areFew = [&](Offset some)
  { return static_cast<double>(some) <= fewFlips * static_cast<double>(size); };
  const bool flipsRest = repair.straysBefore.size() > 0 || flipped.empty() ||
    helpsNoMore(repair.flipsBefore, counts.flips) ||
    (areFew(counts.flips) &&
      flippedTriangles(task, FlipSteps::MoveAndTurn, control, result).left.empty());
  if (!flipsRest)
  {
    enterFlipRound(repair);
    if (const Index onCurves = divideAtFlipped(flipped, task, control, repair, result);
        onCurves > 0)
    {
      return onCurves;
    }
    repair.flipsBefore.push_back(counts.flips);
    return refineAt(flipped, task, repair, result);
  }
  const auto all = static_cast<Offset>(wrong.size());
  if (areFew(all) || all > mostStrays(size) || helpsNoMore(repair.straysBefore, all))
  {
    return 0;
  }
  repair.straysBefore.push_back(all);
  enterFlipRound(repair);
  return refineAt(wrong, task, repair, result);
}

/**
 * The number of vertices to aim at on the way to the one that is wanted, counting one for each site
 * that goes: with cells of several parts, more vertices go than that.
 */
Offset nextNumber(Offset wanted, const RemeshResult& result)
{
  const Offset count = result.components.count();
  const Offset surplus = count - wanted;
  const Offset free = result.sites.count() - result.sites.fixed;
  const Offset parts = count - result.featureSites.numberOfPoints(); // of their cells, about
  return surplus > 1 && parts > free ? count - std::max(surplus * free / parts, Offset(1)) : wanted;
}

/** Sites where there are too few vertices, or none where there are too many. */
Index adjustNumber(const Task& task, Repair& repair, RemeshResult& result)
{
  const Offset wanted = wantedVertices(task.options, result, repair);
  if (!task.options.exactNumber || repair.adjustments >= mostAdjustments ||
    result.components.count() == wanted)
  {
    return 0;
  }
  // Where cells reach several parts of the surface, others may come to do so with each that goes.
  keepIfBest(task.options, result, repair);
  ++repair.adjustments;
  const Offset next = nextNumber(wanted, result);
  return revise({}, result.topology.certificate, next, task, repair, result);
}
}

Index mend(const Task& task, const RunControl& control, Repair& repair, RemeshResult& result)
{
  repair.wentBack = false;
  if (repair.pruning.isTrying())
  {
    if (const Index touched = pruneSites(task, repair, result); touched > 0)
    {
      return touched;
    }
  }
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
    repair.counts.strays = 0;
    keepBest(task.options, result, repair);
    if (const Index touched = repairTopology(task, control, repair, result); touched > 0)
    {
      repair.adjustments = std::min(repair.adjustments, settledAdjustments);
      return touched;
    }
  }
  if (const Index touched = pruneSites(task, repair, result); touched > 0)
  {
    return touched;
  }
  if (const Index touched = adjustNumber(task, repair, result); touched > 0)
  {
    return touched;
  }
  return repairFlips(task, control, repair, result);
}

bool leavesUnsettled(const Repair& repair)
{
  return repair.othersStay || repair.pruning.hasTried() ||
    repair.adjustments > settledAdjustments || repair.stage != RepairStage::Refine ||
    repair.rounds > settledRepairs || repair.flipRounds > 0;
}

bool othersMustStay(const Repair& repair)
{
  return leavesUnsettled(repair) || repair.refinements > settledRefinements;
}
}
