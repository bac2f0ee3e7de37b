#include "Repair/SiteRepair.h"

#include "Delaunay/CellColors.h"
#include "Repair/ReserveRelease.h"
#include "Repair/SiteProposals.h"

namespace remesh
{
namespace
{
/** What else is told of the cells. */
Status describeCells(const Task& task, const RunControl& control, RemeshResult& result)
{
  if (Status status =
        countNeighbors(result.diagram, result.sites.count(), control, result.numbersOfNeighbors);
      !status.ok())
  {
    return status;
  }
  result.cellColors = colorCells(result.diagram, result.components, result.dual,
    result.sites.count(), task.features ? &result.featureSites : nullptr);
  result.cellAreas = measureCellAreas(task.mesh, result.diagram, result.sites.count());
  return locateOnSurface(task.mesh, result.diagram, result.components, control, result.locations);
}

Status improve(SiteTable table, const RunControl& control, SiteCandidate& candidate)
{
  return Improvement<SiteCandidate>(table, candidate).run(control);
}

/** Diagram and dual, again and again while there is something wrong that can be made better. */
Status repair(const RunControl& control, SiteCandidate& candidate, RemeshResult& result)
{
  Status status = candidate.judge(control.step(0, 2));
  result.fallsApart = status.ok() && candidate.fallsApart();
  if (!status.ok() || result.fallsApart || !candidate.mayChange())
  {
    return status;
  }
  Stopwatch watch;
  const double before = result.seconds.diagram;
  const RunControl rest = afterDiagram(control.step(1, 2));
  status = improve(topologyTable(), rest.step(0, 2), candidate);
  if (status.ok())
  {
    status = candidate.countFacing(rest.silent());
  }
  if (status.ok())
  {
    status = improve(facingTable(), rest.step(1, 2), candidate);
  }
  result.seconds.repair += watch.lap() - (result.seconds.diagram - before);
  return status;
}
}

SiteTable topologyTable()
{
  SiteTable table;
  // proposal, most edits, patience
  table.push_back({ "join curves", joinCurves(4), 10, 10 });
  table.push_back({ "refine faults", refineFaults(Refining::AddSites, 2), 32, 8 });
  table.push_back({ "divide curves", divideCurves(), 32, 8 });
  table.push_back({ "cut tips", refineFaults(Refining::CutTips, 0), 32, 8 });
  table.push_back({ "refine beyond", refineFaults(Refining::BeyondNumber, 0), 32, 8 });
  table.push_back({ "adjust number", adjustNumber(4), 10, 10 });
  table.push_back({ "release reserve", std::make_unique<ReserveRelease>(), 32, 0 });
  return table;
}

SiteTable facingTable()
{
  SiteTable table;
  table.push_back({ "join curves", joinCurves(0), 10, 10 });
  table.push_back({ "refine faults", refineFaults(Refining::AddSites, 0), 32, 4 });
  table.push_back({ "adjust number", adjustNumber(0), 10, 10 });
  table.push_back({ "divide curves at inverted", divideCurvesAtInverted(), 8, 2 });
  table.push_back({ "refine inverted", refineInverted(), 8, 2 });
  table.push_back({ "refine strays", refineStrays(), 8, 3 });
  return table;
}

Status findRepairedDual(
  const Task& task, bool othersStay, const RunControl& control, RemeshResult& result)
{
  {
    SiteCandidate candidate(task, othersStay, result);
    if (Status status = repair(control, candidate, result); !status.ok() || result.fallsApart)
    {
      return status;
    }
    result.wantedVertices = task.options.exactNumber
      ? task.options.numberOfSites
      : result.numberOfVertexSites() - result.emptyCells - candidate.extraPoints();
  }
  return describeCells(task, control.silent(), result);
}
}
