#include "Repair/Facing.h"

#include "Placement/StrayTriangles.h"
#include "Placement/TriangleShape.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr double noSides = 0.25; // of the triangles inverted: as if sides were drawn by lot

/** Of the wrong triangles, as `search` found them, those that these steps do not turn back. */
WrongTriangles leftWrong(const PlacementProblem& problem, const NearbySurface& surface,
  MeshSteps steps, const RunControl& control, InvertedSearch& search)
{
  const std::vector<Point3>& centroids = problem.components.centroids;
  PlacedVertices placed;
  placed.positions = centroids;
  std::vector<Triple> triangles = problem.triangles;
  WrongTriangles left;
  Status status = repairMesh(
    { problem, surface, centroids, centroids, control }, steps, search, triangles, placed);
  if (!status.ok() || placed.edits.inverted == 0)
  {
    return left;
  }
  std::vector<Index> wrong;
  status = search.find(triangles, placed.positions, control, wrong);
  for (const Index t : wrong)
  {
    const Facing facing = surface.facingOf(triangles[t], cornersOf(triangles[t], placed.positions));
    (facing.cosine < 0.0 ? left.inverted : left.strays).push_back(t);
  }
  return left;
}

/** The triangles that may be strays, and these. */
Status findSuspects(const PlacementProblem& problem, const WholeSurface& whole,
  const std::vector<Index>& inverted, const RunControl& control, std::vector<char>& suspects)
{
  const Status status = findSuspects(
    problem, whole, { problem.components.centroids, problem.triangles }, control, suspects);
  for (const Index t : inverted)
  {
    suspects[t] = 1;
  }
  return status;
}
}

WrongTriangles findWrongTriangles(
  const Task& task, MeshSteps steps, const RunControl& control, const RemeshResult& result)
{
  const std::vector<char> fixed = verticesOnFeatures(result.seams, result.components.count());
  const PlacementProblem problem{ task.mesh, task.surface, result.sites, result.diagram,
    result.components, result.dual.triangles, fixed, &result.seams.segments };
  const std::vector<Point3>& centroids = problem.components.centroids;
  const NearbySurface own(problem, control);
  InvertedSearch ownSearch(own);
  std::vector<Index> inverted;
  std::vector<char> suspects;
  Status status = ownSearch.find(problem.triangles, centroids, control, inverted);
  const auto count = static_cast<Offset>(problem.triangles.size());
  if (status.ok() && static_cast<double>(inverted.size()) > noSides * static_cast<double>(count))
  {
    return { inverted, {} };
  }
  const WholeSurface& whole = task.wholeSurface(control);
  status = status.ok() ? findSuspects(problem, whole, inverted, control, suspects) : status;
  if (!status.ok() || std::none_of(suspects.begin(), suspects.end(), [](char s) { return s; }))
  {
    return {};
  }
  const NearbySurface surface(own, whole);
  InvertedSearch search(surface);
  std::vector<Index> wrong;
  status = search.find(problem.triangles, centroids, control, wrong, &suspects);
  const bool haveSides = static_cast<Offset>(wrong.size() - inverted.size()) <= maxStrays(count);
  return !status.ok() || wrong.empty() ? WrongTriangles{}
    : haveSides                        ? leftWrong(problem, surface, steps, control, search)
                                       : leftWrong(problem, own, steps, control, ownSearch);
}
}
