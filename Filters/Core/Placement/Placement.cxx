#include "Placement/Placement.h"

#include "Mesh/FacetGeometry.h"
#include "Placement/EvenTriangles.h"
#include "Placement/Quadric.h"
#include "Placement/StepLimit.h"
#include "Placement/SurfaceFit.h"
#include "Placement/TriangleShape.h"
#include "Support/Parallel.h"
#include "Support/SortUnique.h"

#include <algorithm>
#include <utility>

namespace remesh
{
std::vector<Point3> startingPlaces(
  const PlacementProblem& problem, const std::vector<Point3>& given)
{
  std::vector<Point3> places = problem.components.centroids;
  if (given.size() == places.size())
  {
    for (std::size_t v = 0; v < places.size(); ++v)
    {
      places[v] = problem.isFixed(v) ? given[v] : places[v];
    }
  }
  return places;
}

std::vector<Point3> placesOnSurface(const PlacementProblem& problem,
  const std::vector<SurfaceLocation>& locations, const std::vector<Point3>& start)
{
  std::vector<Point3> places = start;
  for (std::size_t v = 0; v < places.size(); ++v)
  {
    if (!problem.isFixed(v))
    {
      const SurfaceLocation& location = locations[v];
      places[v] = location.b[0] * problem.facetPoint(location.facet, 0) +
        location.b[1] * problem.facetPoint(location.facet, 1) +
        location.b[2] * problem.facetPoint(location.facet, 2);
    }
  }
  return places;
}

Status locatePlaces(const NearbySurface& surface, const std::vector<Point3>& known,
  const std::vector<Point3>& positions, const RunControl& control,
  std::vector<SurfaceLocation>& locations)
{
  const PlacementProblem& problem = surface.problem();
  const auto isKnown = [&](std::size_t v)
  { return !known.empty() && positions[v] == known[v] && !problem.isFixed(v); };
  std::size_t first = 0;
  while (first < positions.size() && isKnown(first))
  {
    ++first;
  }
  if (first == positions.size())
  {
    return Status::success();
  }
  const VertexStars stars(problem.triangles, problem.numberOfVertices());
  const bool done =
    forEachRange(Blocks::cut(problem.numberOfVertices(), 64, 4096), control.silent(),
      [&](Offset begin, Offset end)
      {
        std::vector<Index> cells;
        for (auto v = static_cast<Index>(begin); v < end; ++v)
        {
          if (isKnown(static_cast<std::size_t>(v)))
          {
            continue;
          }
          cells.assign(1, v);
          for (Offset k = stars.begin(v); k < stars.end(v); ++k)
          {
            const Triple& triangle = problem.triangles[stars.triangles[k]];
            cells.insert(cells.end(), triangle.begin(), triangle.end());
          }
          sortUnique(cells);
          locations[v] = surface.closest(cells.data(), cells.data() + cells.size(), positions[v]);
        }
      });
  return done ? Status::success() : Status::cancelled();
}

namespace
{
/** The quadrics' minima, as near to them as no triangle is spoilt. */
Status approachQuadrics(const PlacementProblem& problem, const std::vector<Point3>& start,
  const RunControl& control, CellForms& cells, std::vector<Point3>& positions)
{
  CellQuadrics planes; // none is left when vertices are fitted
  if (!measureCells(problem, control, planes, cells) ||
    !placeByQuadrics(problem, planes, control.silent(), positions))
  {
    return Status::cancelled();
  }
  const VertexStars stars(problem.triangles, problem.numberOfVertices());
  // Against their own normals: shapes alone do not tell a triangle from its mirror image.
  const std::vector<Point3> normals = normalsOf(problem.triangles, start);
  return limitSteps(problem, stars, { start, normals, start }, control.silent(), positions)
    ? Status::success()
    : Status::cancelled();
}
}

Status choosePlaces(const PlacementProblem& problem, VertexPlacement way, const RunControl& control,
  const std::vector<SurfaceLocation>& locations, std::vector<Point3>& positions)
{
  std::vector<Point3> start = startingPlaces(problem, positions);
  if (problem.metric && way >= VertexPlacement::Fit)
  {
    if (Status status = evenOutTriangles(problem, control.silent(), locations, start); !status.ok())
    {
      return status;
    }
  }
  positions = start;
  if (way == VertexPlacement::Centroid)
  {
    return Status::success();
  }
  if (way == VertexPlacement::Surface)
  {
    positions = placesOnSurface(problem, locations, start);
    return Status::success();
  }
  CellForms cells;
  const Status status = approachQuadrics(problem, start, control.step(0, 2), cells, positions);
  if (!status.ok() || way == VertexPlacement::Quadric)
  {
    return status;
  }
  const HeldShapes shapes{ start, way == VertexPlacement::HeldFit,
    way == VertexPlacement::FirmFit };
  return fitToSurface(problem, cells, shapes, control.step(1, 2), positions);
}
}
