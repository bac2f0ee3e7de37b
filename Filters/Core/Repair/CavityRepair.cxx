#include "Repair/CavityRepair.h"

#include "Repair/CavityFilling.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace remesh
{
namespace
{
constexpr std::size_t maxTriangles = 40;
constexpr std::size_t maxCavities = 500;
constexpr std::size_t maxSteps = 300000; // of the fillings

/** The corner beyond edge k of a triangle, and the one where it comes into the polygon. */
struct NextCorner
{
  Index triangle = noIndex; ///< noIndex: the cavity cannot grow there
  Index corner = noIndex;
  std::vector<Index>::const_iterator before;
};

NextCorner nextCorner(const RepairedMesh& mesh, const Cavity& cavity, Index triangle, int k)
{
  NextCorner next;
  const Index other = mesh.beyond(triangle, k);
  if (other == noIndex || cavity.has(other))
  {
    return next;
  }
  const Triple& across = mesh.triangles()[other];
  const Index end = mesh.triangles()[triangle][(k + 2) % 3];
  const auto at = std::find(across.begin(), across.end(), end) - across.begin();
  next.corner = across[(at + 2) % 3];
  next.before = std::find(cavity.loop.begin(), cavity.loop.end(), end);
  const bool closes =
    std::find(cavity.loop.begin(), cavity.loop.end(), next.corner) != cavity.loop.end();
  next.triangle = closes ? noIndex : other; // around a vertex
  return next;
}

Cavity extended(const Cavity& cavity, const NextCorner& next)
{
  Cavity larger = cavity;
  larger.loop.insert(larger.loop.begin() + (next.before - cavity.loop.begin()), next.corner);
  larger.triangles.insert(
    std::upper_bound(larger.triangles.begin(), larger.triangles.end(), next.triangle),
    next.triangle);
  return larger;
}

/** Looks for the smallest cavity whose triangles can be better ones. */
class CavitySearch
{
public:
  CavitySearch(const RepairedMesh& mesh, const RunControl& control)
    : m_mesh(mesh)
    , m_control(control)
    , m_filler(mesh)
  {
  }

  /** The best filling of the smallest cavities around a triangle where fewer are inverted then. */
  Filling around(Index triangle)
  {
    const Triple& corners = m_mesh.triangles()[triangle];
    std::vector<Cavity> cavities{ { { triangle }, { corners.begin(), corners.end() } } };
    Filling best;
    while (best.turnedBack == 0 && !cavities.empty() && !this->isOver())
    {
      cavities = this->larger(cavities);
      for (const Cavity& cavity : cavities)
      {
        Filling filling = this->fill(cavity);
        const bool isBetter = filling.turnedBack > 0 && filling.gain > best.gain;
        best = isBetter ? std::move(filling) : best;
      }
    }
    return best;
  }

private:
  bool isOver() const
  {
    return m_seen.size() >= maxCavities || m_steps >= maxSteps || m_control.cancelled();
  }

  Filling fill(const Cavity& cavity)
  {
    if (m_steps >= maxSteps || m_control.cancelled())
    {
      return {};
    }
    m_steps += CavityFiller::stepsFor(cavity);
    return m_filler.fill(cavity);
  }

  /** With one triangle more. */
  std::vector<Cavity> larger(const std::vector<Cavity>& cavities)
  {
    std::vector<Cavity> found;
    for (const Cavity& cavity : cavities)
    {
      for (std::size_t i = 0; i < cavity.triangles.size() && cavity.triangles.size() < maxTriangles;
           ++i)
      {
        for (int k = 0; k < 3 && m_seen.size() < maxCavities; ++k)
        {
          const NextCorner next = nextCorner(m_mesh, cavity, cavity.triangles[i], k);
          if (next.triangle == noIndex)
          {
            continue;
          }
          Cavity grown = extended(cavity, next);
          if (m_seen.insert(grown.triangles).second)
          {
            found.push_back(std::move(grown));
          }
        }
      }
    }
    return found;
  }

  const RepairedMesh& m_mesh;
  const RunControl& m_control;
  CavityFiller m_filler;
  std::set<std::vector<Index>> m_seen; ///< triangles of cavities
  std::size_t m_steps = 0;
};
}

bool refillAround(
  const RepairContext& context, Index triangle, RepairedMesh& mesh, MeshEdits& edits)
{
  const Triple& corners = mesh.triangles()[triangle];
  const bool mayMove = std::any_of(corners.begin(), corners.end(),
    [&](Index v) { return !context.problem.isFixed(static_cast<std::size_t>(v)); });
  if (mayMove && mesh.cost(corners) < invertedCost)
  {
    return false;
  }
  const Filling filling = CavitySearch(mesh, context.control).around(triangle);
  if (filling.turnedBack == 0 || context.control.cancelled())
  {
    return false;
  }
  mesh.replace(filling.old, filling.fresh);
  edits.flippedEdges += filling.newEdges;
  edits.refilled += filling.turnedBack;
  return true;
}
}
