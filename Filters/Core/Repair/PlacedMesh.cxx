#include "Repair/PlacedMesh.h"

#include "Mesh/Extent.h"
#include "Placement/StrayTriangles.h"
#include "Placement/WholeSurface.h"
#include "Repair/Improve.h"
#include "Repair/PlacedCandidate.h"

#include <memory>
#include <optional>

namespace remesh
{
namespace
{
/** Whether so many faults are worth repairing; with more, points are too few. */
bool areFew(Offset faults, const PlacedCandidate& candidate)
{
  return faults <= maxStrays(candidate.numberOfTriangles());
}

/** Turns back triangles that face the wrong way. */
class TurnBack : public Proposal<PlacedCandidate>
{
public:
  explicit TurnBack(MeshFault fault)
    : m_fault(fault)
  {
  }

  bool answers(const PlacedCandidate& candidate) const override
  {
    const Verdict verdict = candidate.verdict();
    return m_fault == MeshFault::Inverted
      ? verdict.inverted > 0
      : verdict.strays > 0 && areFew(verdict.inverted + verdict.strays, candidate);
  }

  Status edit(
    PlacedCandidate& candidate, int /*edit*/, const RunControl& /*control*/, bool& done) override
  {
    done = true;
    return candidate.turnBack();
  }

private:
  MeshFault m_fault;
};

/** Parts triangles that go through each other. */
class PartCrossings : public Proposal<PlacedCandidate>
{
public:
  bool answers(const PlacedCandidate& candidate) const override
  {
    const Offset crossings = candidate.verdict().crossings;
    return crossings > 0 && areFew(crossings, candidate);
  }

  /** Declines where no step is of use. */
  Status edit(
    PlacedCandidate& candidate, int /*edit*/, const RunControl& control, bool& done) override
  {
    done = candidate.partCrossings();
    return control.cancelled() ? Status::cancelled() : Status::success();
  }
};

struct FaultRow
{
  MeshFault fault; ///< is counted from this row on
  const char* name;
};

/**
 * One after the other: what a row mends is not even looked for before it has its turn. Each makes
 * one edit, which is undone if it is in vain.
 */
const FaultRow rows[] = {
  { MeshFault::Inverted, "turn inverted" },
  { MeshFault::Stray, "turn strays" },
  { MeshFault::Crossing, "part crossings" },
};

std::unique_ptr<Proposal<PlacedCandidate>> proposalFor(MeshFault fault)
{
  if (fault == MeshFault::Crossing)
  {
    return std::make_unique<PartCrossings>();
  }
  return std::make_unique<TurnBack>(fault);
}

Status improve(const PlacedTask& task, std::vector<Triple>& triangles, PlacedVertices& placed)
{
  PlacedCandidate candidate(task, triangles, placed);
  Status status = Status::success();
  for (const FaultRow& row : rows)
  {
    status = status.ok() ? candidate.count(row.fault) : status;
    if (status.ok())
    {
      Improvement<PlacedCandidate>::Table table;
      table.push_back({ row.name, proposalFor(row.fault), 1, 0 }); // most edits, patience
      status = Improvement<PlacedCandidate>(table, candidate).run(task.control);
    }
  }
  return status;
}
}

Status repairPlacedMesh(const PlacementProblem& problem, VertexPlacement way,
  const RunControl& control, std::vector<SurfaceLocation>& locations,
  std::vector<Triple>& triangles, PlacedVertices& placed)
{
  const std::vector<Point3> start = startingPlaces(problem, placed.positions);
  const std::vector<Point3> onSurface = placesOnSurface(problem, locations, start);
  const RunControl silent = control.silent();
  std::optional<WholeSurface> made;
  if (!problem.whole)
  {
    made.emplace(problem.mesh, silent);
  }
  const NearbySurface own(problem, control, minHeight(problem.mesh));
  const WholeSurface& whole = problem.whole ? *problem.whole : *made;
  if (Status status = improve({ problem, own, whole, onSurface, start, silent }, triangles, placed);
      !status.ok())
  {
    return status;
  }
  const std::vector<Point3> known =
    way == VertexPlacement::Surface ? onSurface : std::vector<Point3>();
  return locatePlaces(
    own, way == VertexPlacement::Centroid ? start : known, placed.positions, control, locations);
}
}
