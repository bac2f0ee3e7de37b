#include "RemeshFacing.h"

#include "Placement/StrayTriangles.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr double noSides = 0.25; // of the triangles flipped: as if sides were drawn by lot

/** What vertices at the centroids of their cells are placed by. */
PlacementProblem problemOf(
  const Task& task, const RemeshResult& result, const std::vector<char>& fixed)
{
  return { task.mesh, task.surface, result.sites, result.diagram, result.components,
    result.dual.triangles, fixed, &result.seams.segments };
}

/** Of the flipped triangles, as `search` found them, those that these steps do not turn back. */
std::vector<Index> leftFlipped(const PlacementProblem& problem, const NearbySurface& surface,
  FlipSteps steps, const RunControl& control, FlipSearch& search)
{
  const std::vector<Point3>& centroids = problem.components.centroids;
  std::vector<Point3> positions = centroids;
  std::vector<Triple> triangles = problem.triangles;
  FlipRepair repair;
  Status status = repairFlips({ problem, surface, centroids, centroids, control }, steps, search,
    triangles, positions, repair);
  if (!status.ok() || repair.flippedTriangles == 0)
  {
    return {};
  }
  std::vector<Index> flipped;
  status = search.find(triangles, positions, control, flipped);
  return status.ok() ? flipped : std::vector<Index>();
}

/**
 * @param suspects if given: no others are flipped.
 * @param most with more than so many no steps would be worth their time.
 */
FlippedTriangles findFlipped(const PlacementProblem& problem, const NearbySurface& surface,
  FlipSteps steps, const std::vector<char>* suspects, Offset most, const RunControl& control)
{
  FlipSearch search(surface);
  std::vector<Index> found;
  const Status status =
    search.find(problem.triangles, problem.components.centroids, control, found, suspects);
  if (!status.ok() || found.empty())
  {
    return {};
  }
  return { found,
    static_cast<Offset>(found.size()) > most
      ? found
      : leftFlipped(problem, surface, steps, control, search) };
}
}

FlippedTriangles flippedTriangles(
  const Task& task, FlipSteps steps, const RunControl& control, const RemeshResult& result)
{
  const std::vector<char> fixed = verticesOnFeatures(result.seams, result.components.count());
  const PlacementProblem problem = problemOf(task, result, fixed);
  const auto most = static_cast<Offset>(noSides * static_cast<double>(problem.triangles.size()));
  return findFlipped(problem, NearbySurface(problem), steps, nullptr, most, control);
}

std::vector<Index> wrongTriangles(const Task& task, const std::vector<Index>& flipped,
  const RunControl& control, const RemeshResult& result)
{
  const std::vector<char> fixed = verticesOnFeatures(result.seams, result.components.count());
  const PlacementProblem problem = problemOf(task, result, fixed);
  const WholeSurface whole(task.mesh, control);
  std::vector<char> suspects;
  const Status status = findSuspects(
    problem, whole, problem.triangles, problem.components.centroids, control, suspects);
  for (const Index t : flipped)
  {
    suspects[t] = 1;
  }
  if (!status.ok() || std::none_of(suspects.begin(), suspects.end(), [](char s) { return s; }))
  {
    return {};
  }
  const Offset most = mostStrays(static_cast<Offset>(problem.triangles.size()));
  return findFlipped(
    problem, NearbySurface(problem, 0.0, &whole), FlipSteps::Move, &suspects, most, control)
    .left;
}
}
