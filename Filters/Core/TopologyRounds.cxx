#include "TopologyRounds.h"

#include "Delaunay/TopologyRepair.h"
#include "RepairRevision.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace remesh
{
namespace
{
constexpr int mostRepairs = 32;       // in each stage
constexpr int mostIdleRepairs = 8;    // since one that came nearer than all before
constexpr int roundsBetweenCuts = 4;  // of tips
constexpr int mostRepairsOfFlips = 4; // rounds to repair the topology after

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
}

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
}
