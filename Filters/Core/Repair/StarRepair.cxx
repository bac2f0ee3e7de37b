#include "Repair/StarRepair.h"

#include "Support/SortUnique.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace remesh
{
namespace
{
constexpr std::size_t maxSamples = 12;

Point3 meanOf(const std::vector<Index>& vertices, const std::vector<Point3>& positions)
{
  Point3 sum = Point3::Zero();
  for (const Index vertex : vertices)
  {
    sum += positions[vertex];
  }
  return sum / static_cast<double>(vertices.size());
}
}

std::vector<Point3> placesFor(
  const RepairContext& context, Index vertex, bool many, RepairedMesh& mesh)
{
  const Components& components = context.problem.components;
  const std::vector<Point3>& positions = mesh.positions();
  const std::vector<Index> around = mesh.neighbours(vertex);
  const Point3 mean = meanOf(around, positions);
  std::vector<Point3> goals{ components.centroids[vertex], context.surfacePlaces[vertex], mean };
  if (!many)
  {
    return goals;
  }
  goals.push_back(mesh.onSurface(vertex, mean));
  for (const Index other : around)
  {
    goals.push_back(mesh.onSurface(vertex, 0.5 * (positions[vertex] + positions[other])));
  }
  const Offset begin = components.pieceBegin[vertex];
  const auto pieces = static_cast<std::size_t>(components.pieceBegin[vertex + 1] - begin);
  const std::size_t samples = std::min(pieces, maxSamples);
  for (std::size_t k = 0; k < samples; ++k)
  {
    const Index facet =
      context.problem.diagram.facets[components.pieces[begin + k * pieces / samples]];
    goals.push_back((context.problem.facetPoint(facet, 0) + context.problem.facetPoint(facet, 1) +
                      context.problem.facetPoint(facet, 2)) /
      3.0);
  }
  return goals;
}

namespace
{
/** Moves a vertex to the best of a few or many places; false where its own is. */
bool moveVertex(const RepairContext& context, Index vertex, bool many, RepairedMesh& mesh)
{
  if (context.problem.isFixed(static_cast<std::size_t>(vertex)))
  {
    return false;
  }
  const std::vector<Index> star = mesh.star(vertex);
  Point3& position = mesh.positions()[vertex];
  const Point3 before = position;
  Point3 best = before;
  const double start = mesh.costOfStar(star);
  double least = start;
  for (const Point3& goal : placesFor(context, vertex, many, mesh))
  {
    if (context.control.cancelled())
    {
      break;
    }
    for (const double way : { 1.0, 0.5, 0.25, 1.5 })
    {
      position = before + way * (goal - before);
      if (const double cost = mesh.costOfStar(star); cost < least)
      {
        least = cost;
        best = position;
      }
    }
    position = before;
  }
  const bool helps = least < start - 0.5 * context.gain;
  position = helps ? best : before;
  return helps;
}

/** Turns the edge opposite to corner k of a triangle over, if that helps; tells how to undo it. */
bool flipEdge(const RepairContext& context, Index triangle, int k, RepairedMesh& mesh,
  RepairedMesh::EdgeFlip* back = nullptr)
{
  RepairedMesh::EdgeFlip flip;
  if (!mesh.canFlip(triangle, k, flip))
  {
    return false;
  }
  const std::vector<Triple>& triangles = mesh.triangles();
  const double before = mesh.cost(triangles[flip.old[0]]) + mesh.cost(triangles[flip.old[1]]);
  if (mesh.cost(flip.fresh[0]) + mesh.cost(flip.fresh[1]) > before - 0.5 * context.gain)
  {
    return false;
  }
  if (back)
  {
    *back = { flip.old, { triangles[flip.old[0]], triangles[flip.old[1]] } };
  }
  mesh.apply(flip);
  return true;
}

}

void mendTriangle(
  const RepairContext& context, Index triangle, RepairedMesh& mesh, MeshEdits& edits)
{
  for (const Index vertex : Triple(mesh.triangles()[triangle]))
  {
    if (mesh.isInverted(mesh.triangles()[triangle]))
    {
      edits.movedVertices += moveVertex(context, vertex, context.gain < strayCost, mesh);
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    if (context.mayFlip && mesh.isInverted(mesh.triangles()[triangle]))
    {
      edits.flippedEdges += flipEdge(context, triangle, k, mesh);
    }
  }
}

namespace
{
/** Steps that can be undone. */
struct Steps
{
  std::vector<std::pair<Index, Point3>> moved; ///< vertices, and where they were
  std::vector<RepairedMesh::EdgeFlip> flipped; ///< what flips the edges back

  void undo(RepairedMesh& mesh) const
  {
    std::for_each(flipped.rbegin(), flipped.rend(), [&](const auto& back) { mesh.apply(back); });
    std::for_each(moved.rbegin(), moved.rend(),
      [&](const auto& move) { mesh.positions()[move.first] = move.second; });
  }
};
}

void mendAround(const RepairContext& context, Index triangle, RepairedMesh& mesh, MeshEdits& edits)
{
  Triple vertices = mesh.triangles()[triangle];
  std::sort(vertices.begin(), vertices.end());
  Steps steps;
  for (const Index vertex : vertices)
  {
    if (context.control.cancelled())
    {
      return;
    }
    const Point3 before = mesh.positions()[vertex];
    if (moveVertex(context, vertex, false, mesh))
    {
      steps.moved.emplace_back(vertex, before);
    }
  }
  for (const Index vertex : vertices)
  {
    for (const Index t : mesh.star(vertex))
    {
      for (int k = 0; k < 3; ++k)
      {
        RepairedMesh::EdgeFlip back;
        if (flipEdge(context, t, k, mesh, &back))
        {
          steps.flipped.push_back(back);
        }
      }
    }
  }
  if (mesh.isInverted(mesh.triangles()[triangle]))
  {
    steps.undo(mesh);
    return;
  }
  edits.movedVertices += static_cast<Offset>(steps.moved.size());
  edits.flippedEdges += static_cast<Offset>(steps.flipped.size());
}
}
