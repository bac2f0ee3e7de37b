#include "FlipRounds.h"

#include "Delaunay/FeatureRepair.h"
#include "Delaunay/TopologyRepair.h"
#include "Placement/StrayTriangles.h"
#include "RemeshFacing.h"
#include "RepairRevision.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace remesh
{
namespace
{
constexpr double fewFlips = 5e-5; // of the triangles: left to turned edges

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
  allowSettling(repair);
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

/** Triangles that face the wrong way. */
struct WrongTriangles
{
  std::vector<Index> flipped;
  std::vector<Index> all; ///< with strays, unless there is no hope
  bool hopeless = false;  ///< so many are flipped
};

/**
 * Counts them, and keeps the state if it is the best.
 *
 * @return whether it may be repaired: not where the topology is not proven, and was nearer to it.
 */
bool findWrong(const Task& task, const RunControl& control, Repair& repair, RemeshResult& result,
  WrongTriangles& wrong)
{
  RepairCounts& counts = repair.counts;
  FlippedTriangles facing = flippedTriangles(task, FlipSteps::Move, control, result);
  wrong.flipped = std::move(facing.left);
  wrong.hopeless = isHopeless(static_cast<Offset>(wrong.flipped.size()), result);
  counts.flips = 0;
  counts.strays = 0;
  if (repair.flipRounds == 0 && !result.topology.certificate.holds())
  {
    if (scoreOf(task.options, result, repair) > repair.scoreOfBest)
    {
      return false; // the best one is restored in the end
    }
    repair.scoreOfBest = worstScore; // flipped triangles were not counted yet
  }
  counts.flips = static_cast<Offset>(wrong.flipped.size());
  wrong.all = wrong.hopeless ? wrong.flipped : wrongTriangles(task, facing.found, control, result);
  const Offset strays = static_cast<Offset>(wrong.all.size()) - counts.flips;
  counts.strays = countStrays(repair, std::max(strays, Offset(0)));
  keepBest(task.options, result, repair);
  return true;
}

/** So few of the triangles that they are left to turned edges. */
bool areFew(std::size_t some, const RemeshResult& result)
{
  return static_cast<double>(some) <= fewFlips * static_cast<double>(result.dual.triangles.size());
}

/** Whether flipped triangles are left as they are: strays are repaired then. */
bool flipsRest(const std::vector<Index>& flipped, const Task& task, const RunControl& control,
  const Repair& repair, const RemeshResult& result)
{
  return !repair.straysBefore.empty() || flipped.empty() ||
    helpsNoMore(repair.flipsBefore, repair.counts.flips) ||
    (areFew(flipped.size(), result) &&
      flippedTriangles(task, FlipSteps::MoveAndTurn, control, result).left.empty());
}

Index mendFlipped(const std::vector<Index>& flipped, const Task& task, const RunControl& control,
  Repair& repair, RemeshResult& result)
{
  enterFlipRound(repair);
  if (const Index onCurves = divideAtFlipped(flipped, task, control, repair, result); onCurves > 0)
  {
    return onCurves;
  }
  repair.flipsBefore.push_back(repair.counts.flips);
  return refineAt(flipped, task, repair, result);
}

Index mendStrays(
  const std::vector<Index>& wrong, const Task& task, Repair& repair, RemeshResult& result)
{
  const auto all = static_cast<Offset>(wrong.size());
  if (areFew(wrong.size(), result) ||
    all > mostStrays(static_cast<Offset>(result.dual.triangles.size())) ||
    helpsNoMore(repair.straysBefore, all))
  {
    return 0;
  }
  repair.straysBefore.push_back(all);
  enterFlipRound(repair);
  return refineAt(wrong, task, repair, result);
}
}

Index repairFlips(const Task& task, const RunControl& control, Repair& repair, RemeshResult& result)
{
  WrongTriangles wrong;
  if (!findWrong(task, control, repair, result, wrong) || repair.flipRounds >= mostFlipRounds ||
    wrong.hopeless)
  {
    return 0;
  }
  return flipsRest(wrong.flipped, task, control, repair, result)
    ? mendStrays(wrong.all, task, repair, result)
    : mendFlipped(wrong.flipped, task, control, repair, result);
}
}
