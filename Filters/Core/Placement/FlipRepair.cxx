#include "Placement/FlipRepair.h"

#include "Placement/CavityRepair.h"
#include "Placement/FlipPasses.h"
#include "Placement/RepairedMesh.h"
#include "Placement/StarRepair.h"
#include "Placement/TurnedEdges.h"
#include "Placement/Untangling.h"

#include <vector>

namespace remesh
{
namespace
{
constexpr int mostRings = 3;

/** The mesh when the fewest triangles were flipped: later steps may spoil what they cannot mend. */
struct BestMesh
{
  std::vector<Triple> triangles; ///< empty: none is kept
  std::vector<Point3> positions;
  FlipRepair repair;
};

void restore(const BestMesh& best, std::vector<Triple>& triangles, std::vector<Point3>& positions,
  FlipRepair& repair)
{
  if (!best.triangles.empty())
  {
    triangles = best.triangles;
    positions = best.positions;
    repair = best.repair;
  }
}

/** Tries what the pass allows, until the triangle is turned back. */
void mendFlipped(const RepairContext& context, const NearbySurface& surface,
  const FlipPasses& passes, Index triangle, RepairedMesh& mesh, FlipRepair& repair)
{
  const auto isFlipped = [&]() { return mesh.isFlipped(mesh.triangles()[triangle]); };
  if (isFlipped())
  {
    mendTriangle(context, triangle, mesh, repair);
  }
  for (int rings = 1; rings <= mostRings && passes.mayMoveTogether() && isFlipped(); ++rings)
  {
    repair.movedVertices +=
      untangle(context.problem, surface, triangle, rings, context.control, mesh);
  }
  if (passes.mayMendAround() && isFlipped())
  {
    mendAround(context, triangle, passes.effort(), mesh, repair);
  }
  if (passes.mayRefill() && isFlipped())
  {
    refillAround(context, triangle, mesh, repair);
  }
}

/** One triangle after the other; false when cancelled. */
bool mendEach(const RepairContext& context, const NearbySurface& surface, const FlipPasses& passes,
  const std::vector<Index>& flipped, RepairedMesh& mesh, FlipRepair& repair)
{
  for (const Index triangle : flipped)
  {
    if (context.control.cancelled())
    {
      return false;
    }
    mendFlipped(context, surface, passes, triangle, mesh, repair);
  }
  return true;
}
}

Status repairFlips(const FlipTask& task, FlipSteps steps, FlipSearch& search,
  std::vector<Triple>& triangles, std::vector<Point3>& positions, FlipRepair& repair)
{
  repair = FlipRepair{};
  const std::vector<Triple> dual = steps == FlipSteps::Move ? std::vector<Triple>() : triangles;
  RepairedMesh mesh(task.problem, task.surface, task.shapes, triangles, positions);
  FlipPasses passes(steps, static_cast<Offset>(triangles.size()));
  BestMesh best;
  std::vector<Index> flipped;
  for (;;)
  {
    if (Status status = search.find(triangles, positions, task.control, flipped); !status.ok())
    {
      return status;
    }
    repair.flippedTriangles = static_cast<Offset>(flipped.size());
    const bool goesOn = passes.enter(repair);
    if (passes.isBest())
    {
      best = { triangles, positions, repair };
    }
    if (!goesOn)
    {
      break;
    }
    const RepairContext context{ task.problem, task.surfacePlaces, task.control, passes.mayTurn(),
      passes.leastGain() };
    if (!mendEach(context, task.surface, passes, flipped, mesh, repair))
    {
      return Status::cancelled();
    }
  }
  restore(best, triangles, positions, repair);
  if (repair.flippedEdges > 0)
  {
    RepairedMesh repaired(task.problem, task.surface, task.shapes, triangles, positions);
    turnBack(dual, repaired, repair);
    repair.refilled = std::min(repair.refilled, repair.flippedEdges);
  }
  return Status::success();
}
}
