#include "Repair/CrossingRepair.h"

#include "Mesh/FacetGeometry.h"
#include "Placement/TriangleShape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace remesh
{
namespace
{
constexpr double gapWeight = 10.0; // of the distance from the surface, to that of a neighbour
constexpr double maxGap = 0.02;    // more distance from the surface, likewise
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

/** Judges places of a vertex by the triangles around it: how many cross, and how they deviate. */
class PlaceJudge
{
public:
  using Score = std::pair<Offset, double>; ///< the lower one is better

  PlaceJudge(Index vertex, CrossingSearch& search, RepairedMesh& mesh)
    : m_vertex(vertex)
    , m_search(search)
    , m_mesh(mesh)
    , m_star(mesh.star(vertex))
    , m_limit(mesh.costOfStar(m_star) + 0.5 * strayCost) // so that nothing else flips
    , m_radius(radiusAround(vertex, mesh))
    , m_largestGap(this->gap() + maxGap * m_radius)
  {
    for (const Index t : m_star)
    {
      search.setChanged(t);
    }
    m_crossing = crossingsOf(m_star, search);
  }

  /** Of the place at first. */
  Score start() const { return { m_crossing, 0.0 }; }

  /** Whether the vertex may stay where it is now: then lowers `least` to its score there. */
  bool isBetter(Score& least) const
  {
    const double cost = m_mesh.costOfStar(m_star);
    if (!(cost < m_limit))
    {
      return false;
    }
    const Offset crossing = crossingsOf(m_star, m_search);
    if (crossing >= m_crossing || crossing > least.first)
    {
      return false;
    }
    const double gap = this->gap();
    const Score score{ crossing, cost + gapWeight * gap / m_radius };
    if (gap > m_largestGap || !(score < least)) // accuracy goes first
    {
      return false;
    }
    least = score;
    return true;
  }

private:
  /** Distance from the surface. */
  double gap() const
  {
    const Point3& position = m_mesh.positions()[m_vertex];
    return (m_mesh.onSurface(m_vertex, position) - position).norm();
  }

  Index m_vertex;
  CrossingSearch& m_search;
  RepairedMesh& m_mesh;
  std::vector<Index> m_star;
  double m_limit;
  double m_radius;
  double m_largestGap;
  Offset m_crossing = 0; ///< at first
};

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
  const PlaceJudge judge(vertex, search, mesh);
  Point3& position = mesh.positions()[vertex];
  const Point3 before = position;
  std::vector<Point3> goals = placesFor(context, vertex, true, mesh);
  const auto [a, b, c] = cornersOf(mesh.triangles()[other], mesh.positions());
  const Point3 normal = facetNormal(a, b, c);
  goals.emplace_back(before - beyond * normal.dot(before - a) * normal);
  PlaceJudge::Score least = judge.start();
  Point3 best = before;
  for (const Point3& goal : goals)
  {
    if (context.control.cancelled())
    {
      break;
    }
    for (const double way : { 1.0, 0.5, 0.25, 1.5 })
    {
      position = before + way * (goal - before);
      best = judge.isBetter(least) ? position : best;
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

/** Tries all that may part two triangles. */
void part(const RepairContext& context, const std::pair<Index, Index>& pair, CrossingSearch& search,
  RepairedMesh& mesh, MeshEdits& edits)
{
  const Index first = pair.first;
  const Index second = pair.second;
  const auto cross = [&]()
  { return areCrossing(mesh.triangles()[first], mesh.triangles()[second], mesh.positions()); };
  if (!cross())
  {
    return;
  }
  for (const auto& [vertex, other] : verticesOf(first, second, search, mesh))
  {
    edits.movedVertices += cross() && moveVertex(context, vertex, other, search, mesh) ? 1 : 0;
  }
  for (const Index triangle : { first, second })
  {
    for (int k = 0; k < 3 && context.mayFlip; ++k)
    {
      edits.flippedEdges += cross() && flipEdge(triangle, k, search, mesh) ? 1 : 0;
    }
  }
}
}

void partCrossings(const RepairContext& context, const CrossingSearch::Pairs& pairs,
  CrossingSearch& search, RepairedMesh& mesh, MeshEdits& edits)
{
  for (const std::pair<Index, Index>& pair : pairs)
  {
    if (context.control.cancelled())
    {
      return;
    }
    part(context, pair, search, mesh, edits);
  }
}
}
