#include "Repair/CrossingRepair.h"

#include "Mesh/FacetGeometry.h"
#include "Placement/TriangleShape.h"
#include "Repair/PartableCrossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace remesh
{
namespace
{
constexpr int mostPasses = 4;
constexpr Offset noLimit = std::numeric_limits<Offset>::max(); // to pairs left: few were given
constexpr double gapWeight = 10.0; // of the distance from the surface, to that of a neighbour
constexpr double mostGap = 0.02;   // more distance from the surface, likewise
constexpr double beyond = 1.25;    // of the way to the other triangle's plane

Offset crossingsOf(const std::vector<Index>& triangles, const CrossingSearch& search)
{
  Offset sum = 0;
  for (const Index t : triangles)
  {
    sum += search.count(t);
  }
  return sum;
}

/** Largest distance to a neighbour. */
double radiusAround(Index vertex, RepairedMesh& mesh)
{
  double squared = std::numeric_limits<double>::min();
  for (const Index other : mesh.neighbours(vertex))
  {
    squared = std::max(squared, (mesh.positions()[other] - mesh.positions()[vertex]).squaredNorm());
  }
  return std::sqrt(squared);
}

/**
 * Moves a vertex to where the fewest triangles around it cross others, and of such places to one
 * where these deviate least and that is nearest to the surface; false where it is.
 */
bool moveVertex(const RepairContext& context, Index vertex, Index other, CrossingSearch& search,
  RepairedMesh& mesh)
{
  if (context.problem.isFixed(static_cast<std::size_t>(vertex)))
  {
    return false;
  }
  const std::vector<Index> star = mesh.star(vertex);
  for (const Index t : star)
  {
    search.setChanged(t);
  }
  Point3& position = mesh.positions()[vertex];
  const Point3 before = position;
  std::vector<Point3> goals = placesFor(context, vertex, true, mesh);
  const auto [a, b, c] = cornersOf(mesh.triangles()[other], mesh.positions());
  const Point3 normal = facetNormal(a, b, c);
  goals.emplace_back(before - beyond * normal.dot(before - a) * normal);
  const double limit = mesh.costOfStar(star) + 0.5 * strayCost; // so that nothing else flips
  const Offset crossingBefore = crossingsOf(star, search);
  std::pair<Offset, double> least{ crossingBefore, 0.0 };
  Point3 best = before;
  const double radius = radiusAround(vertex, mesh);
  const double startingGap = (mesh.onSurface(vertex, before) - before).norm();
  for (const Point3& goal : goals)
  {
    if (context.control.cancelled())
    {
      break;
    }
    for (const double way : { 1.0, 0.5, 0.25, 1.5 })
    {
      position = before + way * (goal - before);
      const double cost = mesh.costOfStar(star);
      if (!(cost < limit))
      {
        continue;
      }
      const Offset crossing = crossingsOf(star, search);
      if (crossing >= crossingBefore || crossing > least.first)
      {
        continue;
      }
      const double gap = (mesh.onSurface(vertex, position) - position).norm();
      if (gap > startingGap + mostGap * radius)
      {
        continue; // accuracy goes first
      }
      if (const std::pair<Offset, double> score{ crossing, cost + gapWeight * gap / radius };
          score < least)
      {
        least = score;
        best = position;
      }
    }
  }
  position = best;
  return best != before;
}

/** Turns the edge opposite to corner k of a triangle over, if fewer cross after. */
bool flipEdge(Index triangle, int k, CrossingSearch& search, RepairedMesh& mesh)
{
  RepairedMesh::EdgeFlip flip;
  if (!mesh.canFlip(triangle, k, flip))
  {
    return false;
  }
  const std::vector<Index> both(flip.old.begin(), flip.old.end());
  for (const Index t : both)
  {
    search.setChanged(t);
  }
  const RepairedMesh::EdgeFlip back{ flip.old,
    { mesh.triangles()[flip.old[0]], mesh.triangles()[flip.old[1]] } };
  const double limit = mesh.costOfStar(both) + 0.5 * strayCost;
  const Offset before = crossingsOf(both, search);
  mesh.apply(flip);
  if (mesh.costOfStar(both) < limit && crossingsOf(both, search) < before)
  {
    return true;
  }
  mesh.apply(back);
  return false;
}

/** The vertices of two triangles, each with the other triangle; the most entangled ones first. */
std::vector<std::pair<Index, Index>> verticesOf(
  Index first, Index second, const CrossingSearch& search, const RepairedMesh& mesh)
{
  std::vector<std::pair<Offset, std::pair<Index, Index>>> keyed;
  for (const auto& [own, other] : { std::make_pair(first, second), std::make_pair(second, first) })
  {
    for (const Index vertex : mesh.triangles()[own])
    {
      keyed.push_back({ -crossingsOf(mesh.star(vertex), search), { vertex, other } });
    }
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::pair<Index, Index>> vertices;
  for (const auto& [key, vertex] : keyed)
  {
    vertices.push_back(vertex);
  }
  return vertices;
}

/** Tries all that may part two triangles; tells how many steps it took. */
Offset part(const RepairContext& context, Index first, Index second, CrossingSearch& search,
  RepairedMesh& mesh, MeshEdits& edits)
{
  const auto cross = [&]()
  { return areCrossing(mesh.triangles()[first], mesh.triangles()[second], mesh.positions()); };
  if (!cross())
  {
    return 0;
  }
  Offset moved = 0;
  for (const auto& [vertex, other] : verticesOf(first, second, search, mesh))
  {
    moved += cross() && moveVertex(context, vertex, other, search, mesh) ? 1 : 0;
  }
  Offset turned = 0;
  for (const Index triangle : { first, second })
  {
    for (int k = 0; k < 3 && context.mayFlip; ++k)
    {
      turned += cross() && flipEdge(triangle, k, search, mesh) ? 1 : 0;
    }
  }
  edits.movedVertices += moved;
  edits.flippedEdges += turned;
  return moved + turned;
}
}

void repairCrossings(const RepairContext& context,
  const std::vector<std::pair<Index, Index>>& pairs, CrossingSearch& search, RepairedMesh& mesh,
  MeshEdits& edits)
{
  std::vector<std::pair<Index, Index>> left = pairs;
  for (int pass = 0; pass < mostPasses && !left.empty(); ++pass)
  {
    Offset done = 0;
    for (const auto& [a, b] : left)
    {
      if (context.control.cancelled())
      {
        return;
      }
      done += part(context, a, b, search, mesh, edits);
    }
    if (done == 0 ||
      !findPartable(
        context.problem, search, mesh.triangles(), noLimit, context.control.silent(), left)
         .ok())
    {
      return;
    }
  }
}
}
