#include "Placement/SurfaceFit.h"

#include "Placement/DistanceBound.h"
#include "Placement/FitSystem.h"
#include "Placement/Regularity.h"
#include "Placement/StepLimit.h"

#include <optional>
#include <utility>

namespace remesh
{
namespace
{
// With fewer, the triangles come closer to the samples than to what is between.
constexpr int samplesPerVertex = 40;
constexpr int coarseSamples = 18; // in all but the last rounds
constexpr int coarseRounds = 4;
constexpr int fineRounds = 2;
/**
 * How far all but the last round go along their displacements, and how much of the way of the round
 * before the coarse ones go once more: feet that slide in their triangles come along a round late.
 * The rounds after them end what these overshoot.
 */
constexpr double relaxation = 1.4;
constexpr double momentum = 0.3;
constexpr ConjugateGradientsLimits solverLimits{ 100, 1e-2 }; // the next round sees to the rest

/**
 * What holds vertices at their centroids where they are to stay there, in proportion to how much
 * normals vary within cells; and how much regularity they may lose at most all the same. (measured,
 * a torus with a winding metric of 3 : 1, RMS distance in 1e-4 and even edges: held as firmly as
 * can be 12.8 and 99.7 %, like this 6.8 and 99.0 %, free 6.4 and 91.9 %.)
 */
constexpr double holdPerVariation = 0.3;
constexpr double maxLoss = 0.0075; // by cells alone, which miss a quarter of it
constexpr double firmly = 10.0;    // across the surface alone

class FitRounds
{
public:
  FitRounds(const FitTask& task, const std::vector<Point3>& shapes)
    : m_task(task)
    , m_shapes(shapes)
    , m_system(makeFitSystem(task.problem))
  {
    m_samples.emplace(task.problem, coarseSamples);
  }

  /** All rounds from `start`, with the errors of the first. False when cancelled. */
  bool goAll(const std::vector<Point3>& start, const RunControl& control, FitErrors& errors,
    std::vector<Point3>& positions)
  {
    for (int round = 0; round < coarseRounds; ++round)
    {
      if (!this->go(relaxation, momentum, control, positions))
      {
        return false;
      }
      if (round == 0)
      {
        errors = m_system.errors;
      }
      control.report((round + 1.0) / (coarseRounds + fineRounds));
    }
    // Here, too, so that the last rounds make the best of it.
    if (!boundDistances(m_task, start, errors, control, positions))
    {
      return false;
    }
    // For two rounds, keeping these takes as long as making them again.
    m_samples.emplace(m_task.problem, samplesPerVertex, 0.0);
    for (int left = fineRounds; left > 0; --left)
    {
      if (!this->go(left > 1 ? relaxation : 1.0, 0.0, control, positions))
      {
        return false;
      }
      control.report((coarseRounds + fineRounds - left + 1.0) / (coarseRounds + fineRounds));
    }
    return true;
  }

  /**
   * One round.
   *
   * @param step how far to go along the displacements, 1: to their ends.
   * @param again how much of the way of the round before to go once more.
   * @return false when cancelled.
   */
  bool go(double step, double again, const RunControl& control, std::vector<Point3>& positions)
  {
    if (m_before.empty())
    {
      m_before = positions;
    }
    std::vector<Point3> goals;
    if (!assembleFit(m_task, positions, *m_samples, control, m_system) ||
      !this->findGoals(positions, step, again, control, goals) ||
      !this->limit(positions, control, goals))
    {
      return false;
    }
    m_before = std::move(positions);
    positions = std::move(goals);
    return true;
  }

  /** Keeps triangles from turning on the way from `start`; false when cancelled. */
  bool limit(
    const std::vector<Point3>& start, const RunControl& control, std::vector<Point3>& goals) const
  {
    return limitSteps(
      m_task.problem, m_task.stars, { m_shapes, m_system.triangleNormals, start }, control, goals);
  }

private:
  /** The places where the system's solution sends the vertices. Its slopes are used up. */
  bool findGoals(const std::vector<Point3>& positions, double step, double again,
    const RunControl& control, std::vector<Point3>& goals)
  {
    VectorField displacements(positions.size(), Point3::Zero());
    if (!solveConjugateGradients(m_system, solverLimits, control, m_system.slopes, displacements))
    {
      return false;
    }
    goals = positions;
    for (std::size_t v = 0; v < goals.size(); ++v)
    {
      if (!m_system.frozen[v] && displacements[v].allFinite())
      {
        goals[v] += step * displacements[v] + again * (positions[v] - m_before[v]);
      }
    }
    return true;
  }

  const FitTask& m_task;
  const std::vector<Point3>& m_shapes;
  FitSystem m_system;
  std::optional<FitSamples> m_samples;
  std::vector<Point3> m_before; ///< the last positions
};

/** Only what their ways from the centroids are across the surface. */
void keepAcross(
  const CellForms& cells, const std::vector<Point3>& centroids, std::vector<Point3>& positions)
{
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    const Point3 normal = cells.normals[v].stableNormalized();
    positions[v] = centroids[v] + normal.dot(positions[v] - centroids[v]) * normal;
  }
}

}

Status fitToSurface(const PlacementProblem& problem, const CellForms& cells,
  const HeldShapes& shapes, const RunControl& control, std::vector<Point3>& positions)
{
  const VertexStars stars(problem.triangles, problem.numberOfVertices());
  FitTask task{ problem, stars, cells };
  if (shapes.held || shapes.heldFirmly)
  {
    keepAcross(cells, shapes.positions, positions);
    task.anchors = &shapes.positions;
    task.hold = shapes.heldFirmly ? firmly : holdPerVariation * cells.variation;
  }
  const std::vector<Point3> start = positions;
  std::vector<Point3> anchors;
  FitErrors errors;
  FitRounds rounds(task, shapes.positions);
  if (!rounds.goAll(start, control, errors, positions))
  {
    return Status::cancelled();
  }
  if (shapes.held && limitSliding(problem, cells, maxLoss, shapes.positions, positions))
  {
    anchors = positions;
    task.anchors = &anchors;
    task.hold = firmly;
    if (!rounds.go(1.0, 0.0, control.silent(), positions))
    {
      return Status::cancelled();
    }
  }
  return boundDistances(task, start, errors, control, positions) &&
      rounds.limit(start, control, positions)
    ? Status::success()
    : Status::cancelled();
}
}
