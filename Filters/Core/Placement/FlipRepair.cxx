#include "Placement/FlipRepair.h"

#include "Placement/RepairedMesh.h"
#include "Placement/StarRepair.h"
#include "Placement/TriangleShape.h"
#include "Placement/Untangling.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace remesh
{
namespace
{
constexpr int untanglingPass = 3; // from which on the vertices around move together
constexpr int movingPasses = 4;   // in which every step must turn a triangle back
constexpr int turningPass = 4;    // in which edges may turn, too
constexpr int mostRings = 3;
constexpr std::size_t mostUntangled = 2000; // with more flipped triangles, points are too few
constexpr int mostPasses = 18;
constexpr double leastGain = 0.02; // in later ones
constexpr int mostVainPasses = 3;  // at the last effort, with many flipped triangles

std::pair<Index, Index> edgeOf(const Triple& triangle, int k)
{
  return std::minmax(triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
}

/** Turns edges back that the dual does not have, where nothing flips by that. */
void turnBack(const std::vector<Triple>& dual, RepairedMesh& mesh, FlipRepair& repair)
{
  std::vector<Index> changed;
  std::set<std::pair<Index, Index>> edges; ///< that changed triangles had
  for (std::size_t t = 0; t < dual.size(); ++t)
  {
    if (dual[t] != mesh.triangles()[t])
    {
      changed.push_back(static_cast<Index>(t));
      for (int k = 0; k < 3; ++k)
      {
        edges.insert(edgeOf(dual[t], k));
      }
    }
  }
  const auto isSound = [&](const RepairedMesh::Turn& turn)
  {
    const Triple& first = turn.fresh[0]; // apex, a, opposite: the new edge is opposite to a
    return edges.count(edgeOf(first, 1)) > 0 && !mesh.isFlipped(first) &&
      !mesh.isFlipped(turn.fresh[1]);
  };
  for (bool any = true; any;)
  {
    any = false;
    for (const Index t : changed)
    {
      for (int k = 0; k < 3; ++k)
      {
        RepairedMesh::Turn turn;
        if (edges.count(edgeOf(mesh.triangles()[t], k)) == 0 && mesh.canTurn(t, k, turn) &&
          isSound(turn))
        {
          for (const Index old : turn.old)
          {
            repair.flippedTriangles -= mesh.isFlipped(mesh.triangles()[old]) ? 1 : 0;
          }
          mesh.apply(turn);
          --repair.flippedEdges;
          any = true;
        }
      }
    }
  }
}

struct Repaired
{
  std::vector<Triple> triangles;
  std::vector<Point3> positions;
  FlipRepair repair;
};
}

Status repairFlips(const PlacementProblem& problem, const NearbySurface& surface,
  const std::vector<Point3>& surfacePlaces, const std::vector<Point3>& shapes, FlipSteps steps,
  const RunControl& control, FlipSearch& search, std::vector<Triple>& triangles,
  std::vector<Point3>& positions, FlipRepair& repair)
{
  repair = FlipRepair{};
  static_assert(movingPasses <= turningPass); // so the dual is known where edges turn
  const std::vector<Triple> dual =
    steps == FlipSteps::MoveAndTurn ? triangles : std::vector<Triple>();
  RepairedMesh mesh(problem, surface, shapes, triangles, positions);
  Offset doneBefore = 0;
  Offset flippedBefore = 0;
  Effort effort = Effort::OwnStars;
  Repaired best; // once steps need only lower deviations
  int vain = 0;  // passes at the last effort since that
  std::vector<Index> flipped;
  int passes = steps == FlipSteps::Move ? movingPasses : mostPasses;
  for (int pass = 0;; ++pass)
  {
    if (Status status = search.find(triangles, positions, control, flipped); !status.ok())
    {
      return status;
    }
    repair.flippedTriangles = static_cast<Offset>(flipped.size());
    const Offset done = repair.movedVertices + repair.flippedEdges;
    const bool stuck = pass > turningPass + 1 && done == doneBefore;
    const bool tooMany =
      repair.flippedTriangles > mostFlipped(static_cast<Offset>(triangles.size()));
    const bool hopeless = tooMany && pass > 0 && 2 * repair.flippedTriangles > flippedBefore;
    flippedBefore = repair.flippedTriangles;
    passes = hopeless || (tooMany && pass >= movingPasses) ? pass : passes;
    effort = stuck ? static_cast<Effort>(static_cast<int>(effort) + 1) : effort;
    // Later steps may spoil what they cannot mend.
    if (pass > turningPass &&
      (best.triangles.empty() || repair.flippedTriangles < best.repair.flippedTriangles))
    {
      best = { triangles, positions, repair };
      vain = 0;
    }
    vain += effort == Effort::KeptAnyway ? 1 : 0;
    const bool isVain = vain > mostVainPasses && repair.flippedTriangles > fewFlipped;
    if (repair.flippedTriangles == 0 || pass == passes || effort == Effort::Everything || isVain)
    {
      if (!best.triangles.empty())
      {
        triangles = best.triangles;
        positions = best.positions;
        repair = best.repair;
      }
      if (repair.flippedEdges > 0)
      {
        RepairedMesh repaired(problem, surface, shapes, triangles, positions);
        turnBack(dual, repaired, repair);
      }
      return Status::success();
    }
    doneBefore = done;
    const RepairContext context{ problem, surfacePlaces, control, pass >= turningPass,
      pass <= turningPass ? strayCost : leastGain };
    for (const Index triangle : flipped)
    {
      if (control.cancelled())
      {
        return Status::cancelled();
      }
      const auto isFlipped = [&]() { return mesh.isFlipped(triangles[triangle]); };
      if (isFlipped())
      {
        mendTriangle(context, triangle, mesh, repair);
      }
      if (pass >= untanglingPass && pass != turningPass && flipped.size() <= mostUntangled)
      {
        for (int rings = 1; rings <= mostRings && isFlipped(); ++rings)
        {
          repair.movedVertices += untangle(problem, surface, triangle, rings, control, mesh);
        }
      }
      if (pass > turningPass && isFlipped())
      {
        mendAround(context, triangle, effort, mesh, repair);
      }
    }
  }
}
}
