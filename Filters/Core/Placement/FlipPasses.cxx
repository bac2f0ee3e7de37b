#include "Placement/FlipPasses.h"

namespace remesh
{
namespace
{
constexpr int untanglingPass = 3;      // from which on the vertices around move together
constexpr int movingPasses = 4;        // in which every step must turn a triangle back
constexpr int turningPass = 4;         // in which edges may turn, too
constexpr Offset mostUntangled = 2000; // with more flipped triangles, points are too few
constexpr int mostPasses = 18;
constexpr double laterGain = 0.02; // at least, in passes after those
constexpr int mostVainPasses = 3;  // at the last effort, with many flipped triangles

static_assert(movingPasses <= turningPass); // where only vertices may move, no edge turns

Offset stepsOf(const FlipRepair& repair)
{
  return repair.movedVertices + repair.flippedEdges;
}

Effort moreThan(Effort effort)
{
  return static_cast<Effort>(static_cast<int>(effort) + 1);
}
}

bool FlipPasses::enter(const FlipRepair& repair)
{
  ++m_pass;
  m_isStuck = this->isStuck(repair);
  m_effort = m_isStuck ? moreThan(m_effort) : m_effort;
  m_isBest = m_pass > turningPass && repair.flippedTriangles < m_fewest;
  if (m_isBest)
  {
    m_fewest = repair.flippedTriangles;
    m_vainPasses = 0;
  }
  m_vainPasses += m_effort == Effort::KeptAnyway ? 1 : 0;
  const bool isOver = repair.flippedTriangles == 0 || this->hasTooMany(repair) ||
    m_effort == Effort::Everything || this->isVain(repair) || this->isLast();
  m_entered = repair;
  return !isOver;
}

/** Whether the last pass took no step, as it might have. */
bool FlipPasses::isStuck(const FlipRepair& repair) const
{
  return m_pass > turningPass + 1 && stepsOf(repair) == stepsOf(m_entered);
}

/** Whether so much is flipped that only passes are worth it that halve the number. */
bool FlipPasses::hasTooMany(const FlipRepair& repair) const
{
  const bool isHalved = 2 * repair.flippedTriangles <= m_entered.flippedTriangles;
  return repair.flippedTriangles > mostFlipped(m_triangles) &&
    (m_pass >= movingPasses || (m_pass > 0 && !isHalved));
}

bool FlipPasses::isVain(const FlipRepair& repair) const
{
  return m_vainPasses > mostVainPasses && repair.flippedTriangles > fewFlipped;
}

bool FlipPasses::isLast() const
{
  return m_pass == (m_steps == FlipSteps::Move ? movingPasses : mostPasses);
}

bool FlipPasses::mayTurn() const
{
  return m_pass >= turningPass;
}

bool FlipPasses::mayMoveTogether() const
{
  return m_pass >= untanglingPass && m_pass != turningPass &&
    m_entered.flippedTriangles <= mostUntangled;
}

bool FlipPasses::mayRefill() const
{
  const bool isNew = m_pass == turningPass + 1 || m_isStuck;
  return m_steps == FlipSteps::Refill && m_pass > turningPass &&
    m_entered.flippedTriangles <= (isNew ? mostUntangled : fewFlipped);
}

bool FlipPasses::mayMendAround() const
{
  return m_pass > turningPass;
}

double FlipPasses::leastGain() const
{
  return m_pass <= turningPass ? strayCost : laterGain;
}
}
