#include "Placement/SurfaceFit.h"

#include "Placement/FitSystem.h"
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
constexpr int rounds = 6;
constexpr int fineRounds = 2;
/**
 * How far all but the last round go along their displacements, and how much of the way of the round
 * before the coarse ones go once more: feet that slide in their triangles come along a round late.
 * The rounds after them end what these overshoot.
 */
constexpr double relaxation = 1.5;
constexpr double momentum = 0.3;
constexpr ConjugateGradientsLimits solverLimits{ 100, 1e-2 }; // the next round sees to the rest

/**
 * The places where the system's solution sends the vertices.
 *
 * @param before K, the positions a round ago.
 * @param step how far to go along the displacements, 1: to their ends.
 * @param again how much of the way since `before` to go once more.
 * @param goals K, replaced. The system's slopes are used up.
 * @return false when cancelled.
 */
bool findGoals(FitSystem& system, const std::vector<Point3>& positions,
  const std::vector<Point3>& before, double step, double again, const RunControl& control,
  std::vector<Point3>& goals)
{
  VectorField displacements(positions.size(), Point3::Zero());
  if (!solveConjugateGradients(system, solverLimits, control, system.slopes, displacements))
  {
    return false;
  }
  goals = positions;
  for (std::size_t v = 0; v < goals.size(); ++v)
  {
    if (!system.frozen[v] && displacements[v].allFinite())
    {
      goals[v] += step * displacements[v] + again * (positions[v] - before[v]);
    }
  }
  return true;
}
}

Status fitToSurface(const PlacementProblem& problem, const std::vector<Point3>& shapes,
  const RunControl& control, std::vector<Point3>& positions)
{
  const VertexStars stars(problem.triangles, problem.numberOfVertices());
  FitSystem system = makeFitSystem(problem);
  std::optional<FitSamples> samples;
  samples.emplace(problem, coarseSamples);
  std::vector<Point3> before = positions; // the last round
  for (int round = 0; round < rounds; ++round)
  {
    const bool isCoarse = round + fineRounds < rounds;
    if (round + fineRounds == rounds)
    {
      // For two rounds, keeping these takes as long as making them again.
      samples.emplace(problem, samplesPerVertex, 0.0);
    }
    const double step = round + 1 < rounds ? relaxation : 1.0;
    const double again = isCoarse ? momentum : 0.0;
    std::vector<Point3> goals;
    if (!assembleFit(problem, stars, positions, shapes, *samples, control, system) ||
      !findGoals(system, positions, before, step, again, control, goals) ||
      !limitSteps(problem, stars, { shapes, system.triangleNormals }, positions, control, goals))
    {
      return Status::cancelled();
    }
    before = std::move(positions);
    positions = std::move(goals);
    control.report((round + 1.0) / rounds);
  }
  return Status::success();
}
}
