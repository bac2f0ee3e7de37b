#include "Placement/SurfaceFit.h"

#include "Placement/FitSystem.h"
#include "Placement/StepLimit.h"

#include <optional>

namespace remesh
{
namespace
{
// With fewer, the triangles come closer to the samples than to what is between.
constexpr int samplesPerVertex = 40;
constexpr int coarseSamples = 18; // in all but the last rounds
constexpr int rounds = 8;
constexpr int fineRounds = 2;
/**
 * How far the first rounds go along their displacements: feet that slide in their triangles come
 * along a round late. Rounds at the full step end what longer ones overshoot.
 */
constexpr double relaxation = 1.6;
constexpr int fullRounds = 3;
constexpr ConjugateGradientsLimits solverLimits{ 100, 1e-2 }; // the next round sees to the rest
}

Status fitToSurface(const PlacementProblem& problem, const std::vector<Point3>& shapes,
  const RunControl& control, std::vector<Point3>& positions)
{
  const VertexStars stars(problem.triangles, problem.numberOfVertices());
  const EdgeTable edges = buildEdgeTable(problem.triangles);
  FitSystem system = makeFitSystem(problem, edges);
  std::optional<FitSamples> samples;
  samples.emplace(problem, coarseSamples);
  for (int round = 0; round < rounds; ++round)
  {
    if (round + fineRounds == rounds)
    {
      // For two rounds, keeping these takes as long as making them again.
      samples.emplace(problem, samplesPerVertex, 0.0);
    }
    if (!assembleFit(problem, stars, edges, positions, shapes, *samples, control, system))
    {
      return Status::cancelled();
    }
    VectorField displacements(positions.size(), Point3::Zero());
    // The slopes are summed anew in the next round.
    if (!solveConjugateGradients(system, solverLimits, control, system.slopes, displacements))
    {
      return Status::cancelled();
    }
    const double step = round + fullRounds < rounds ? relaxation : 1.0;
    std::vector<Point3> goals(positions.size());
    for (std::size_t v = 0; v < goals.size(); ++v)
    {
      const bool moves = !system.frozen[v] && displacements[v].allFinite();
      goals[v] = moves ? Point3(positions[v] + step * displacements[v]) : positions[v];
    }
    if (!limitSteps(problem, stars, { shapes, system.triangleNormals }, positions, control, goals))
    {
      return Status::cancelled();
    }
    positions.swap(goals);
    control.report((round + 1.0) / rounds);
  }
  return Status::success();
}
}
