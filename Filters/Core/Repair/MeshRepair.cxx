#include "Repair/MeshRepair.h"

#include "Repair/CavityRepair.h"
#include "Repair/DualEdges.h"
#include "Repair/Improve.h"
#include "Repair/RepairedMesh.h"
#include "Repair/StarRepair.h"
#include "Repair/Untangling.h"
#include "Run/Verdict.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace remesh
{
namespace
{
constexpr int maxRings = 3;           // around a triangle that vertices move together in
constexpr Offset maxUntangled = 2000; // with more inverted triangles, points are too few
constexpr double smallGain = 0.02;    // at least, of a step that need not turn a triangle back

/** The mesh and the triangles that are inverted. */
class MeshCandidate
{
public:
  struct State
  {
    std::vector<Triple> triangles;
    std::vector<Point3> positions;
    MeshEdits edits;
  };

  MeshCandidate(const MeshTask& task, InvertedSearch& search, std::vector<Triple>& triangles,
    PlacedVertices& placed)
    : m_task(task)
    , m_search(search)
    , m_triangles(triangles)
    , m_positions(placed.positions)
    , m_edits(placed.edits)
  {
    this->readMesh();
  }

  Status judge(const RunControl& /*control*/)
  {
    const Status status = m_search.find(m_triangles, m_positions, m_task.control, m_inverted);
    m_edits.inverted = static_cast<Offset>(m_inverted.size());
    return status;
  }

  Verdict verdict() const
  {
    Verdict verdict;
    verdict.inverted = m_edits.inverted;
    return verdict;
  }
  State state() const { return { m_triangles, m_positions, m_edits }; }
  void restore(const State& state)
  {
    m_triangles = state.triangles;
    m_positions = state.positions;
    m_edits = state.edits;
    this->readMesh();
  }

  const MeshTask& task() const { return m_task; }
  const std::vector<Index>& inverted() const { return m_inverted; }
  Offset numberOfTriangles() const { return static_cast<Offset>(m_triangles.size()); }
  RepairedMesh& mesh() { return *m_mesh; }
  MeshEdits& edits() { return m_edits; }

private:
  void readMesh()
  {
    m_mesh.emplace(m_task.problem, m_task.surface, m_task.shapes, m_triangles, m_positions);
  }

  const MeshTask& m_task;
  InvertedSearch& m_search;
  std::vector<Triple>& m_triangles;
  std::vector<Point3>& m_positions;
  MeshEdits& m_edits;
  std::vector<Index> m_inverted;
  std::optional<RepairedMesh> m_mesh;
};

/** What one pass over the inverted triangles may do. */
struct Pass
{
  MeshSteps steps;            ///< for which it is made
  bool movesTogether = false; ///< vertices around a triangle
  bool flipsEdges = false;
  bool mayWorsen = false; ///< what it cannot mend; tries more places, and what is around
};

class PassProposal : public Proposal<MeshCandidate>
{
public:
  PassProposal(const Pass& pass, bool refills)
    : m_pass(pass)
    , m_refills(refills)
  {
  }

  bool answers(const MeshCandidate& candidate) const override
  {
    const Offset inverted = candidate.verdict().inverted;
    return inverted > 0 &&
      (m_pass.steps == MeshSteps::Move || inverted <= maxInverted(candidate.numberOfTriangles()));
  }

  /** Declines where no step is of use. */
  Status edit(
    MeshCandidate& candidate, int /*edit*/, const RunControl& /*control*/, bool& done) override
  {
    const MeshTask& task = candidate.task();
    const RepairContext context{ task.problem, task.surfacePlaces, task.control, m_pass.flipsEdges,
      m_pass.mayWorsen ? smallGain : strayCost };
    const MeshEdits before = candidate.edits();
    for (const Index triangle : candidate.inverted())
    {
      if (task.control.cancelled())
      {
        return Status::cancelled();
      }
      this->mend(context, triangle, candidate);
    }
    const MeshEdits& after = candidate.edits();
    done = after.movedVertices != before.movedVertices ||
      after.flippedEdges != before.flippedEdges || after.refilled != before.refilled;
    return Status::success();
  }

private:
  /** Tries what the pass may do, until the triangle is turned back. */
  void mend(const RepairContext& context, Index triangle, MeshCandidate& candidate) const
  {
    RepairedMesh& mesh = candidate.mesh();
    MeshEdits& edits = candidate.edits();
    const auto isInverted = [&]() { return mesh.isInverted(mesh.triangles()[triangle]); };
    if (isInverted())
    {
      mendTriangle(context, triangle, mesh, edits);
    }
    const bool together = m_pass.movesTogether && candidate.verdict().inverted <= maxUntangled;
    for (int rings = 1; rings <= maxRings && together && isInverted(); ++rings)
    {
      edits.movedVertices +=
        untangle(candidate.task().surface, triangle, rings, context.control, mesh);
    }
    if (m_pass.mayWorsen && isInverted())
    {
      mendAround(context, triangle, mesh, edits);
    }
    if (m_refills && candidate.verdict().inverted <= maxUntangled && isInverted())
    {
      refillAround(context, triangle, mesh, edits);
    }
  }

  Pass m_pass;
  bool m_refills;
};

struct PassRow
{
  const char* name;
  Pass pass;
  int maxEdits;
  int patience;
};

/** Passes of more and more effort. */
const PassRow passes[] = {
  { "move vertices", { MeshSteps::Move }, 3, 0 },
  { "move vertices together", { MeshSteps::Move, true }, 1, 0 },
  { "flip edges", { MeshSteps::MoveAndFlip, false, true }, 1, 0 },
  { "mend around", { MeshSteps::MoveAndFlip, true, true, true }, 4, 2 },
};

Improvement<MeshCandidate>::Table tableOf(MeshSteps steps)
{
  Improvement<MeshCandidate>::Table table;
  for (const PassRow& row : passes)
  {
    if (row.pass.steps <= steps)
    {
      const bool refills = steps == MeshSteps::Refill && row.pass.mayWorsen;
      table.push_back({ row.name, std::make_unique<PassProposal>(row.pass, refills), row.maxEdits,
        row.patience });
    }
  }
  return table;
}
}

Status repairMesh(const MeshTask& task, MeshSteps steps, InvertedSearch& search,
  std::vector<Triple>& triangles, PlacedVertices& placed)
{
  MeshEdits& edits = placed.edits;
  edits = MeshEdits{};
  const std::vector<Triple> dual = steps == MeshSteps::Move ? std::vector<Triple>() : triangles;
  {
    MeshCandidate candidate(task, search, triangles, placed);
    Improvement<MeshCandidate>::Table table = tableOf(steps);
    Status status = candidate.judge(task.control);
    if (status.ok())
    {
      status = Improvement<MeshCandidate>(table, candidate).run(task.control.silent());
    }
    if (!status.ok())
    {
      return status;
    }
  }
  if (edits.flippedEdges > 0)
  {
    RepairedMesh repaired(task.problem, task.surface, task.shapes, triangles, placed.positions);
    flipBack(dual, repaired, edits);
    edits.refilled = std::min(edits.refilled, edits.flippedEdges);
  }
  return Status::success();
}
}
