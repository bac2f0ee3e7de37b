#include "RepairRevision.h"

#include "Delaunay/FeatureRepair.h"
#include "Delaunay/SiteRevision.h"

#include <algorithm>
#include <set>
#include <utility>

namespace remesh
{
namespace
{
constexpr double mostFailures = 0.1; // of the vertices; with more, there is no use in going on
}

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

Offset countSections(const std::vector<Intrusion>& intrusions)
{
  std::set<std::pair<Index, Index>> sections;
  for (const Intrusion& intrusion : intrusions)
  {
    sections.emplace(intrusion.curve, intrusion.section);
  }
  return static_cast<Offset>(sections.size());
}

bool isHopeless(Offset failures, const RemeshResult& result)
{
  return static_cast<double>(failures) >
    mostFailures * static_cast<double>(result.components.count());
}
}
