#include "Placement/FlipRepair.h"

#include "Placement/RepairedMesh.h"
#include "Placement/TriangleShape.h"
#include "Placement/Untangling.h"
#include "Support/Grouping.h"

#include <algorithm>
#include <set>

namespace remesh
{
namespace
{
constexpr int untanglingPass = 3; // in which the vertices around move together
constexpr int movingPasses = 4;   // in which every step must turn a triangle back
constexpr int turningPass = 4;    // in which edges may turn, too
constexpr int mostRings = 3;
constexpr int mostPasses = 18;
constexpr double leastGain = 0.02; // in later ones
constexpr std::size_t mostSamples = 12;

/** What may change around a triangle that nothing helps alone. */
enum class Effort
{
  OwnStars,   ///< the stars of its corners; undone if that does not help
  Neighbours, ///< those of their neighbours, too; undone if that does not help
  KeptAnyway, ///< the same, and it stays: something may help later
  Everything  ///< has been done
};

/** What a repair reads, and the least gain of a step in the pass it is in. */
struct Workshop
{
  const PlacementProblem& problem;
  const std::vector<Point3>& surfacePlaces;
  const RunControl& control;
  bool mayTurn;
  double gain;
};

Point3 meanOf(const std::vector<Index>& vertices, const std::vector<Point3>& positions)
{
  Point3 sum = Point3::Zero();
  for (const Index vertex : vertices)
  {
    sum += positions[vertex];
  }
  return sum / static_cast<double>(vertices.size());
}

/** Places for a vertex: around its cell, and between its neighbours. */
std::vector<Point3> findGoals(const Workshop& shop, Index vertex, RepairedMesh& mesh, bool many)
{
  const Components& components = shop.problem.components;
  const std::vector<Point3>& positions = mesh.positions();
  const std::vector<Index> around = mesh.neighbours(vertex);
  const Point3 mean = meanOf(around, positions);
  std::vector<Point3> goals{ components.centroids[vertex], shop.surfacePlaces[vertex], mean };
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
  const std::size_t samples = std::min(pieces, mostSamples);
  for (std::size_t k = 0; k < samples; ++k)
  {
    const Index facet =
      shop.problem.diagram.facets[components.pieces[begin + k * pieces / samples]];
    goals.push_back((shop.problem.facetPoint(facet, 0) + shop.problem.facetPoint(facet, 1) +
                      shop.problem.facetPoint(facet, 2)) /
      3.0);
  }
  return goals;
}

/** Moves a vertex to the best of a few or many places; false where its own is. */
bool moveVertex(const Workshop& shop, Index vertex, bool many, RepairedMesh& mesh)
{
  if (shop.problem.isFixed(static_cast<std::size_t>(vertex)))
  {
    return false;
  }
  const std::vector<Index> star = mesh.star(vertex);
  Point3& position = mesh.positions()[vertex];
  const Point3 before = position;
  Point3 best = before;
  const double start = mesh.costOfStar(star);
  double least = start;
  for (const Point3& goal : findGoals(shop, vertex, mesh, many))
  {
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
  const bool helps = least < start - 0.5 * shop.gain;
  position = helps ? best : before;
  return helps;
}

/** Turns the edge opposite to corner k of a triangle over, if that helps; tells how to undo it. */
bool turnEdge(const Workshop& shop, Index triangle, int k, RepairedMesh& mesh,
  RepairedMesh::Turn* back = nullptr)
{
  RepairedMesh::Turn turn;
  if (!mesh.canTurn(triangle, k, turn))
  {
    return false;
  }
  const std::vector<Triple>& triangles = mesh.triangles();
  const double before = mesh.cost(triangles[turn.old[0]]) + mesh.cost(triangles[turn.old[1]]);
  if (mesh.cost(turn.fresh[0]) + mesh.cost(turn.fresh[1]) > before - 0.5 * shop.gain)
  {
    return false;
  }
  if (back)
  {
    *back = { turn.old, { triangles[turn.old[0]], triangles[turn.old[1]] } };
  }
  mesh.apply(turn);
  return true;
}

/** Moves the corners of a triangle, then turns its edges, until it is turned back. */
void mend(const Workshop& shop, Index triangle, RepairedMesh& mesh, FlipRepair& repair)
{
  for (const Index vertex : Triple(mesh.triangles()[triangle]))
  {
    if (mesh.isFlipped(mesh.triangles()[triangle]))
    {
      repair.movedVertices += moveVertex(shop, vertex, shop.gain < flippedCost, mesh);
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    if (shop.mayTurn && mesh.isFlipped(mesh.triangles()[triangle]))
    {
      repair.flippedEdges += turnEdge(shop, triangle, k, mesh);
    }
  }
}

/** The corners of a triangle, or all that share a triangle with one of them; ascending. */
std::vector<Index> verticesAround(Index triangle, Effort effort, const RepairedMesh& mesh)
{
  const Triple& corners = mesh.triangles()[triangle];
  std::vector<Index> vertices(corners.begin(), corners.end());
  for (const Index vertex : corners)
  {
    if (effort != Effort::OwnStars)
    {
      const std::vector<Index> around = mesh.neighbours(vertex);
      vertices.insert(vertices.end(), around.begin(), around.end());
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/** Moves and turns what is around a triangle that nothing helps alone; see Effort. */
void mendAround(
  const Workshop& shop, Index triangle, Effort effort, RepairedMesh& mesh, FlipRepair& repair)
{
  const std::vector<Index> vertices = verticesAround(triangle, effort, mesh);
  std::vector<std::pair<Index, Point3>> moved;
  std::vector<RepairedMesh::Turn> turned;
  for (const Index vertex : vertices)
  {
    if (shop.control.cancelled())
    {
      return;
    }
    const Point3 before = mesh.positions()[vertex];
    if (moveVertex(shop, vertex, false, mesh))
    {
      moved.emplace_back(vertex, before);
    }
  }
  for (const Index vertex : vertices)
  {
    for (const Index t : mesh.star(vertex))
    {
      for (int k = 0; k < 3; ++k)
      {
        RepairedMesh::Turn back;
        if (turnEdge(shop, t, k, mesh, &back))
        {
          turned.push_back(back);
        }
      }
    }
  }
  if (effort != Effort::KeptAnyway && mesh.isFlipped(mesh.triangles()[triangle]))
  {
    std::for_each(turned.rbegin(), turned.rend(), [&](const auto& back) { mesh.apply(back); });
    std::for_each(moved.rbegin(), moved.rend(),
      [&](const auto& move) { mesh.positions()[move.first] = move.second; });
    return;
  }
  repair.movedVertices += static_cast<Offset>(moved.size());
  repair.flippedEdges += static_cast<Offset>(turned.size());
}

std::pair<Index, Index> edgeOf(const Triple& triangle, int k)
{
  return std::minmax(triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
}

/** Turns edges back that the dual does not have, where nothing flips by that. */
void turnBack(const std::vector<Triple>& dual, RepairedMesh& mesh, FlipRepair& repair)
{
  std::vector<Index> changed;
  std::set<std::pair<Index, Index>> edges; ///< that changed triangles had
  for (std::size_t t = 0; t < dual.size(); ++t)
  {
    if (dual[t] != mesh.triangles()[t])
    {
      changed.push_back(static_cast<Index>(t));
      for (int k = 0; k < 3; ++k)
      {
        edges.insert(edgeOf(dual[t], k));
      }
    }
  }
  const auto isSound = [&](const RepairedMesh::Turn& turn)
  {
    const Triple& first = turn.fresh[0]; // apex, a, opposite: the new edge is opposite to a
    return edges.count(edgeOf(first, 1)) > 0 && !mesh.isFlipped(first) &&
      !mesh.isFlipped(turn.fresh[1]);
  };
  for (bool any = true; any;)
  {
    any = false;
    for (const Index t : changed)
    {
      for (int k = 0; k < 3; ++k)
      {
        RepairedMesh::Turn turn;
        if (edges.count(edgeOf(mesh.triangles()[t], k)) == 0 && mesh.canTurn(t, k, turn) &&
          isSound(turn))
        {
          mesh.apply(turn);
          --repair.flippedEdges;
          any = true;
        }
      }
    }
  }
}

struct Repaired
{
  std::vector<Triple> triangles;
  std::vector<Point3> positions;
  FlipRepair repair;
};
}

Status findFlipped(const NearbySurface& surface, const std::vector<Triple>& triangles,
  const std::vector<Point3>& positions, const RunControl& control, std::vector<Index>& flipped)
{
  std::vector<char> isFlipped(triangles.size());
  if (!forEachRange(Blocks::cut(static_cast<Offset>(triangles.size()), 64, 4096), control.silent(),
        [&](Offset begin, Offset end)
        {
          for (Offset t = begin; t < end; ++t)
          {
            isFlipped[t] = surface.isFlipped(triangles[t], cornersOf(triangles[t], positions));
          }
        }))
  {
    return Status::cancelled();
  }
  flipped.clear();
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (isFlipped[t])
    {
      flipped.push_back(static_cast<Index>(t));
    }
  }
  return Status::success();
}

Status repairFlips(const PlacementProblem& problem, const NearbySurface& surface,
  const std::vector<Point3>& surfacePlaces, const std::vector<Point3>& shapes, FlipSteps steps,
  const RunControl& control, std::vector<Triple>& triangles, std::vector<Point3>& positions,
  FlipRepair& repair)
{
  repair = FlipRepair{};
  const std::vector<Triple> dual = triangles;
  RepairedMesh mesh(problem, surface, shapes, triangles, positions);
  Offset doneBefore = 0;
  Effort effort = Effort::OwnStars;
  Repaired before; // the steps that are not undone one by one
  std::vector<Index> flipped;
  for (int pass = 0;; ++pass)
  {
    if (Status status = findFlipped(surface, triangles, positions, control, flipped); !status.ok())
    {
      return status;
    }
    repair.flippedTriangles = static_cast<Offset>(flipped.size());
    const Offset done = repair.movedVertices + repair.flippedEdges;
    const bool stuck = pass > turningPass + 1 && done == doneBefore;
    const int passes = steps == FlipSteps::Move ? movingPasses : mostPasses;
    effort = stuck ? static_cast<Effort>(static_cast<int>(effort) + 1) : effort;
    if (stuck && effort == Effort::KeptAnyway)
    {
      before = { triangles, positions, repair };
    }
    if (repair.flippedTriangles == 0 || pass == passes || effort == Effort::Everything)
    {
      if (!before.triangles.empty() && repair.flippedTriangles >= before.repair.flippedTriangles)
      {
        triangles = before.triangles;
        positions = before.positions;
        repair = before.repair;
      }
      RepairedMesh repaired(problem, surface, shapes, triangles, positions);
      turnBack(dual, repaired, repair);
      return Status::success();
    }
    doneBefore = done;
    const Workshop shop{ problem, surfacePlaces, control, pass >= turningPass,
      pass <= turningPass ? flippedCost : leastGain };
    for (const Index triangle : flipped)
    {
      if (control.cancelled())
      {
        return Status::cancelled();
      }
      const auto isFlipped = [&]() { return mesh.isFlipped(triangles[triangle]); };
      if (isFlipped())
      {
        mend(shop, triangle, mesh, repair);
      }
      if (pass >= untanglingPass && pass != turningPass)
      {
        for (int rings = 1; rings <= mostRings && isFlipped(); ++rings)
        {
          repair.movedVertices += untangle(problem, surface, triangle, rings, mesh);
        }
      }
      if (pass > turningPass && isFlipped())
      {
        mendAround(shop, triangle, effort, mesh, repair);
      }
    }
  }
}
}
