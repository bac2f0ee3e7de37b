#include "Repair/PlacedCandidate.h"

#include "Mesh/Extent.h"
#include "Placement/StrayTriangles.h"
#include "Placement/TriangleShape.h"
#include "Repair/CrossingRepair.h"
#include "Repair/PartableCrossings.h"
#include "Repair/RepairedMesh.h"
#include "Repair/StarRepair.h"

#include <algorithm>

namespace remesh
{
PlacedCandidate::PlacedCandidate(
  const PlacedTask& task, std::vector<Triple>& triangles, PlacedVertices& placed)
  : m_task(task)
  , m_triangles(triangles)
  , m_placed(placed)
{
  m_search.emplace(task.own);
}

Status PlacedCandidate::count(MeshFault fault)
{
  return fault == MeshFault::Inverted ? this->judge(m_task.control)
    : fault == MeshFault::Stray       ? this->findStrays()
                                      : this->findCrossings();
}

Status PlacedCandidate::judge(const RunControl& control)
{
  Status status = m_search->find(m_triangles, m_placed.positions, control, m_wrong);
  if (status.ok())
  {
    this->countWrong();
  }
  return status.ok() && m_countsCrossings ? this->findPairs(control) : status;
}

Verdict PlacedCandidate::verdict() const
{
  Verdict verdict;
  verdict.inverted = m_placed.edits.inverted;
  verdict.strays = m_placed.strays;
  verdict.crossings = m_placed.crossings;
  return verdict;
}

void PlacedCandidate::restore(const State& state)
{
  m_triangles = state.triangles;
  m_placed = state.placed;
}

Status PlacedCandidate::findStrays()
{
  std::vector<char> suspects;
  Status status = findSuspects(m_task.problem, m_task.whole, { m_placed.positions, m_triangles },
    m_task.control.silent(), suspects);
  if (!status.ok() || std::none_of(suspects.begin(), suspects.end(), [](char s) { return s; }))
  {
    return status;
  }
  // Where none faces against its own cells, only the suspects can be inverted.
  const bool faceOwnCells = m_wrong.empty();
  this->lookAtWhole();
  status = m_search->find(
    m_triangles, m_placed.positions, m_task.control, m_wrong, faceOwnCells ? &suspects : nullptr);
  if (status.ok())
  {
    this->countWrong();
  }
  return status;
}

Status PlacedCandidate::findCrossings()
{
  m_countsCrossings = true;
  const Status status = this->findPairs(m_task.control);
  if (status.ok() && !m_pairs.empty())
  {
    if (!m_whole) // no triangle was even suspected to be a stray
    {
      this->lookAtWhole();
    }
    m_search->know(m_triangles, m_placed.positions, m_wrong);
  }
  return status;
}

Status PlacedCandidate::findPairs(const RunControl& control)
{
  m_crossing.emplace(m_triangles, m_placed.positions, control);
  const Offset most = maxStrays(this->numberOfTriangles());
  const Status status = findPartable(m_task.problem, *m_crossing, most, control, m_pairs);
  m_placed.crossings = static_cast<Offset>(m_pairs.size());
  return status;
}

/** From now on triangles are wrong, too, that face against other parts of the surface. */
void PlacedCandidate::lookAtWhole()
{
  m_whole.emplace(m_task.own, m_task.whole);
  m_search.emplace(*m_whole);
}

/** Tells inverted triangles from strays. */
void PlacedCandidate::countWrong()
{
  const auto isInverted = [this](Index t)
  {
    return !m_whole ||
      m_task.own.isInverted(m_triangles[t], cornersOf(m_triangles[t], m_placed.positions));
  };
  m_placed.edits.inverted = std::count_if(m_wrong.begin(), m_wrong.end(), isInverted);
  m_placed.strays = static_cast<Offset>(m_wrong.size()) - m_placed.edits.inverted;
}

Status PlacedCandidate::turnBack()
{
  const MeshEdits before = m_placed.edits;
  const MeshTask task{ m_task.problem, this->surface(), m_task.surfacePlaces, m_task.shapes,
    m_task.control };
  const Status status = repairMesh(task, MeshSteps::Refill, *m_search, m_triangles, m_placed);
  m_placed.edits.movedVertices += before.movedVertices;
  m_placed.edits.flippedEdges += before.flippedEdges;
  m_placed.edits.refilled += before.refilled;
  return status;
}

bool PlacedCandidate::partCrossings()
{
  RepairedMesh mesh(
    m_task.problem, this->surface(), m_task.shapes, m_triangles, m_placed.positions);
  MeshEdits& edits = m_placed.edits;
  const MeshEdits before = edits;
  remesh::partCrossings({ m_task.problem, m_task.surfacePlaces, m_task.control, true, 0.0 },
    m_pairs, *m_crossing, mesh, edits);
  return edits.movedVertices + edits.flippedEdges > before.movedVertices + before.flippedEdges;
}
}
