#include "Placement/Placement.h"

#include "Mesh/Extent.h"
#include "Mesh/FacetGeometry.h"
#include "Placement/CrossingRepair.h"
#include "Placement/PartableCrossings.h"
#include "Placement/Quadric.h"
#include "Placement/Retreat.h"
#include "Placement/StepLimit.h"
#include "Placement/StrayTriangles.h"
#include "Placement/SurfaceFit.h"
#include "Placement/TriangleShape.h"
#include "Support/Parallel.h"
#include "Support/SortUnique.h"

#include <algorithm>
#include <utility>

namespace remesh
{
namespace
{
/** Centroids but at the fixed vertices that have places already. */
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

/** The points of the surface closest to the places, but where these are among known ones. */
Status locatePlaces(const PlacementProblem& problem, const NearbySurface& surface,
  const std::vector<Point3>& known, const std::vector<Point3>& positions, const RunControl& control,
  std::vector<SurfaceLocation>& locations)
{
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

/** The quadrics' minima, as near to them as no triangle is spoilt. */
Status approachQuadrics(const PlacementProblem& problem, const CellForms& cells,
  const std::vector<Point3>& start, const RunControl& control, std::vector<Point3>& positions)
{
  if (!placeByQuadrics(problem, cells, control.silent(), positions))
  {
    return Status::cancelled();
  }
  const VertexStars stars(problem.triangles, problem.numberOfVertices());
  // Against their own normals: shapes alone do not tell a triangle from its mirror image.
  const std::vector<Point3> normals = normalsOf(problem.triangles, start);
  return limitSteps(problem, stars, { start, normals }, start, control, positions)
    ? Status::success()
    : Status::cancelled();
}

/**
 * Where triangles are left flipped, with the vertices around them at the centroids again, and the
 * dual's edges: what mends them there differs from what does at the fitted places.
 *
 * @param task with the triangles before edges were turned, and the centroids as shapes.
 * @param fitted K, the places then.
 * @param flipped then.
 * @param triangles after; changed only for better ones.
 */
Status mendFromCentroids(const FlipTask& task, const std::vector<Point3>& fitted,
  const std::vector<Index>& flipped, std::vector<Triple>& triangles, Placement& placement)
{
  for (const int rings : { 1, 2, 4 })
  {
    std::vector<Point3> positions = fitted;
    retreatAround(task.problem, task.shapes, flipped, rings, positions);
    std::vector<Triple> turned = task.problem.triangles;
    FlipSearch search(task.surface);
    FlipRepair repair;
    if (Status status = repairFlips(task, FlipSteps::Refill, search, turned, positions, repair);
        !status.ok())
    {
      return status;
    }
    if (repair.flippedTriangles < placement.repair.flippedTriangles)
    {
      triangles = std::move(turned);
      placement.positions = std::move(positions);
      placement.repair = repair;
    }
    if (repair.flippedTriangles == 0)
    {
      break;
    }
  }
  return Status::success();
}

/** Whether any triangles are left flipped, and few enough. */
bool isWorthMore(const FlipRepair& repair, const std::vector<Triple>& triangles)
{
  return repair.flippedTriangles > 0 &&
    repair.flippedTriangles <= mostFlipped(static_cast<Offset>(triangles.size()));
}

/**
 * Turns flipped triangles back by moving vertices, then with the places that vertices come to from
 * the centroids, if few are left.
 *
 * @param flipped those that are left, where it went on from the centroids.
 */
Status moveBack(const FlipTask& task, FlipSearch& search, std::vector<Triple>& triangles,
  Placement& placement, std::vector<Index>& flipped)
{
  FlipRepair& repair = placement.repair;
  Status status =
    repairFlips(task, FlipSteps::Move, search, triangles, placement.positions, repair);
  if (!status.ok() || !isWorthMore(repair, triangles))
  {
    return status;
  }
  std::vector<Point3> fromCentroids = task.shapes;
  FlipSearch otherSearch(task.surface);
  FlipRepair other;
  status = repairFlips(task, FlipSteps::Move, otherSearch, triangles, fromCentroids, other);
  if (status.ok() && other.flippedTriangles < repair.flippedTriangles)
  {
    status = search.find(triangles, placement.positions, task.control, flipped);
    if (status.ok())
    {
      repair.movedVertices += retreat(
        task.problem, task.surface, fromCentroids, flipped, task.control, placement.positions);
    }
  }
  return status.ok() ? search.find(triangles, placement.positions, task.control, flipped) : status;
}

/** Turns flipped triangles back: by moving vertices, by turned edges, and from the centroids. */
Status mendFlips(const PlacementProblem& problem, const NearbySurface& surface,
  const std::vector<SurfaceLocation>& locations, const std::vector<Point3>& start,
  const RunControl& control, std::vector<Triple>& triangles, Placement& placement)
{
  placement.repair = FlipRepair{};
  FlipRepair& repair = placement.repair;
  FlipSearch search(surface);
  std::vector<Index> flipped;
  Status status = search.find(triangles, placement.positions, control, flipped);
  if (!status.ok() || flipped.empty())
  {
    return status;
  }
  const std::vector<Point3> onSurface = placesOnSurface(problem, locations, start);
  const FlipTask task{ problem, surface, onSurface, start, control };
  status = moveBack(task, search, triangles, placement, flipped);
  if (!status.ok() || !isWorthMore(repair, triangles))
  {
    return status;
  }
  const Offset moved = repair.movedVertices;
  const std::vector<Point3> fitted = placement.positions;
  const std::vector<Triple> dual = triangles; // `problem` may hold the very list that changes
  status = repairFlips(task, FlipSteps::Refill, search, triangles, placement.positions, repair);
  if (status.ok() && repair.flippedTriangles > 0 && repair.flippedTriangles <= fewFlipped)
  {
    const PlacementProblem unturned{ problem.mesh, problem.surface, problem.sites, problem.diagram,
      problem.components, dual, problem.fixed, problem.featureEdges };
    status = mendFromCentroids(
      { unturned, surface, onSurface, start, control }, fitted, flipped, triangles, placement);
  }
  repair.movedVertices += moved;
  return status;
}

/**
 * Turns back what faces its own cells' facets, but not those of another part of the surface that
 * are closer, if they are few. Keeps nothing by which more triangles are flipped than before.
 */
Status mendStrays(const PlacementProblem& problem, const NearbySurface& own,
  const std::vector<SurfaceLocation>& locations, const std::vector<Point3>& start,
  const RunControl& control, std::vector<Triple>& triangles, Placement& placement)
{
  placement.wrongWay = 0;
  const WholeSurface whole(problem.mesh, control);
  std::vector<char> suspects;
  Status status =
    findSuspects(problem, whole, triangles, placement.positions, control.silent(), suspects);
  if (!status.ok() || std::none_of(suspects.begin(), suspects.end(), [](char s) { return s; }))
  {
    return status;
  }
  const NearbySurface surface(problem, leastHeight(problem.mesh), &whole);
  FlipSearch search(surface);
  std::vector<Index> strays;
  // Where none faces against its own cells, only the suspects can be flipped.
  const bool faceOwnCells = placement.repair.flippedTriangles == 0;
  status = search.find(
    triangles, placement.positions, control, strays, faceOwnCells ? &suspects : nullptr);
  const auto before = static_cast<Offset>(strays.size());
  placement.wrongWay = before;
  if (!status.ok() || before == placement.repair.flippedTriangles ||
    before > mostStrays(static_cast<Offset>(triangles.size())))
  {
    return status;
  }
  std::vector<Triple> turned = triangles;
  std::vector<Point3> positions = placement.positions;
  FlipRepair repair;
  const std::vector<Point3> onSurface = placesOnSurface(problem, locations, start);
  status = repairFlips({ problem, surface, onSurface, start, control }, FlipSteps::Refill, search,
    turned, positions, repair);
  if (!status.ok())
  {
    return status;
  }
  std::vector<Index> flipped;
  status = FlipSearch(own).find(turned, positions, control, flipped);
  const auto after = static_cast<Offset>(flipped.size());
  if (status.ok() && repair.flippedTriangles < before && after <= placement.repair.flippedTriangles)
  {
    triangles = std::move(turned);
    placement.positions = std::move(positions);
    placement.wrongWay = repair.flippedTriangles;
    placement.repair.flippedTriangles = after;
    placement.repair.movedVertices += repair.movedVertices;
    placement.repair.flippedEdges += repair.flippedEdges;
    placement.repair.refilled += repair.refilled;
  }
  return status;
}

/** Parts triangles that go through each other, if they are few; flips none for that. */
Status mendCrossings(const PlacementProblem& problem, const std::vector<SurfaceLocation>& locations,
  const std::vector<Point3>& start, const RunControl& control, std::vector<Triple>& triangles,
  Placement& placement)
{
  CrossingSearch search(triangles, placement.positions, control);
  std::vector<std::pair<Index, Index>> pairs;
  const Offset most = mostStrays(static_cast<Offset>(triangles.size()));
  Status status = findPartable(problem, search, triangles, most, control, pairs);
  if (!status.ok() || pairs.empty() || static_cast<Offset>(pairs.size()) > most)
  {
    return status;
  }
  const WholeSurface whole(problem.mesh, control);
  const NearbySurface surface(problem, leastHeight(problem.mesh), &whole);
  const std::vector<Point3> onSurface = placesOnSurface(problem, locations, start);
  RepairedMesh mesh(problem, surface, start, triangles, placement.positions);
  repairCrossings(
    { problem, onSurface, control, true, 0.0 }, pairs, search, mesh, placement.repair);
  return control.cancelled() ? Status::cancelled() : Status::success();
}
}

Status choosePlaces(const PlacementProblem& problem, VertexPlacement way, const RunControl& control,
  const std::vector<SurfaceLocation>& locations, std::vector<Point3>& positions)
{
  const std::vector<Point3> start = startingPlaces(problem, positions);
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
  if (!measureCells(problem, control.step(0, 2), cells))
  {
    return Status::cancelled();
  }
  const Status status = approachQuadrics(problem, cells, start, control.silent(), positions);
  if (!status.ok() || way == VertexPlacement::Quadric)
  {
    return status;
  }
  const HeldShapes shapes{ start, way == VertexPlacement::HeldFit };
  return fitToSurface(problem, cells, shapes, control.step(1, 2), positions);
}

Status mendPlaces(const PlacementProblem& problem, VertexPlacement way, const RunControl& control,
  std::vector<SurfaceLocation>& locations, std::vector<Triple>& triangles, Placement& placement)
{
  const std::vector<Point3> start = startingPlaces(problem, placement.positions);
  const NearbySurface surface(problem, leastHeight(problem.mesh));
  Status status = mendFlips(problem, surface, locations, start, control, triangles, placement);
  if (status.ok())
  {
    status = mendStrays(problem, surface, locations, start, control.silent(), triangles, placement);
  }
  if (status.ok())
  {
    status = mendCrossings(problem, locations, start, control.silent(), triangles, placement);
  }
  if (!status.ok())
  {
    return status;
  }
  const std::vector<Point3> known = way == VertexPlacement::Surface
    ? placesOnSurface(problem, locations, start)
    : std::vector<Point3>();
  return locatePlaces(problem, surface, way == VertexPlacement::Centroid ? start : known,
    placement.positions, control, locations);
}
}
