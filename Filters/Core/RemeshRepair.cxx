#include "RemeshRepair.h"

#include "Delaunay/TopologyRepair.h"
#include "FlipRounds.h"
#include "RepairRevision.h"
#include "Support/SortUnique.h"
#include "TopologyRounds.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace remesh
{
namespace
{
constexpr int settledRepairs = 2;   // later ones change nothing but what they must
constexpr int mostRefinements = 10; // rounds in which free sites may join curves
/** Settling after later ones would only bring others to the curves. */
constexpr int settledRefinements = 4;
constexpr int mostAdjustments = 10; // of the number of vertices

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
      allowSettling(repair);
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
