#include "Placement/FlipRepair.h"

#include "Placement/TriangleShape.h"
#include "Support/Grouping.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace remesh
{
namespace
{
constexpr int mostPasses = 4;
constexpr double flippedCost = 1000.0; // above all that the other costs of a star sum to
constexpr double largestStretchCost = 10.0;

/** The mesh while it is repaired: stars that edges have been turned in are kept apart. */
class RepairedMesh
{
public:
  RepairedMesh(const PlacementProblem& problem, const NearbySurface& surface,
    const std::vector<Point3>& shapes, std::vector<Triple>& triangles,
    std::vector<Point3>& positions)
    : m_stars(triangles, problem.numberOfVertices())
    , m_surface(surface)
    , m_shapes(shapes)
    , m_triangles(triangles)
    , m_positions(positions)
  {
  }

  std::vector<Index> star(Index vertex) const
  {
    if (const auto found = m_changedStars.find(vertex); found != m_changedStars.end())
    {
      return found->second;
    }
    return { m_stars.triangles.begin() + m_stars.begin(vertex),
      m_stars.triangles.begin() + m_stars.end(vertex) };
  }

  /** The other two vertices of the triangles of a star, each once, ascending. */
  std::vector<Index> neighbours(Index vertex) const
  {
    std::vector<Index> around;
    for (const Index t : this->star(vertex))
    {
      std::copy_if(m_triangles[t].begin(), m_triangles[t].end(), std::back_inserter(around),
        [vertex](Index other) { return other != vertex; });
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return around;
  }

  double cosine(const Triple& triangle) const
  {
    return m_surface.facingOf(triangle, cornersOf(triangle, m_positions));
  }
  bool isFlipped(const Triple& triangle) const { return this->cosine(triangle) < 0.0; }

  double cost(const Triple& triangle) const
  {
    const double cosine = this->cosine(triangle);
    const double stretch =
      stretchRatio(cornersOf(triangle, m_shapes), cornersOf(triangle, m_positions));
    return (cosine < 0.0 ? flippedCost : 0.0) + (1.0 - cosine) +
      0.05 * std::min(stretch, largestStretchCost);
  }
  double costOfStar(const std::vector<Index>& star) const
  {
    return std::accumulate(star.begin(), star.end(), 0.0,
      [&](double sum, Index t) { return sum + this->cost(m_triangles[t]); });
  }

  /** Replaces two triangles; their stars follow. */
  void replace(const std::array<Index, 2>& old, const std::array<Triple, 2>& fresh)
  {
    for (int k = 0; k < 2; ++k)
    {
      for (const Index vertex : m_triangles[old[k]])
      {
        std::vector<Index> rest = this->star(vertex);
        rest.erase(std::remove(rest.begin(), rest.end(), old[k]), rest.end());
        m_changedStars[vertex] = rest;
      }
    }
    for (int k = 0; k < 2; ++k)
    {
      m_triangles[old[k]] = fresh[k];
      for (const Index vertex : fresh[k])
      {
        std::vector<Index> more = this->star(vertex);
        more.insert(std::upper_bound(more.begin(), more.end(), old[k]), old[k]);
        m_changedStars[vertex] = more;
      }
    }
  }

  const std::vector<Triple>& triangles() const { return m_triangles; }
  std::vector<Point3>& positions() { return m_positions; }

private:
  VertexStars m_stars;
  const NearbySurface& m_surface;
  const std::vector<Point3>& m_shapes;
  std::vector<Triple>& m_triangles;
  std::vector<Point3>& m_positions;
  std::map<Index, std::vector<Index>> m_changedStars;
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

/** Moves a vertex to the best of some places; false where its own is the best. */
bool moveVertex(Index vertex, const std::array<Point3, 2>& places, RepairedMesh& mesh)
{
  const std::vector<Index> star = mesh.star(vertex);
  Point3& position = mesh.positions()[vertex];
  const Point3 before = position;
  Point3 best = before;
  double least = mesh.costOfStar(star);
  const double start = least;
  const Point3 goals[] = { places[0], places[1],
    meanOf(mesh.neighbours(vertex), mesh.positions()) };
  for (const Point3& goal : goals)
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
  }
  const bool helps = least < start - 0.5 * flippedCost;
  position = helps ? best : before;
  return helps;
}

/** Turns the edge opposite to corner k of a triangle over, if that helps. */
bool turnEdge(const PlacementProblem& problem, Index triangle, int k, RepairedMesh& mesh)
{
  const Triple corners = mesh.triangles()[triangle];
  const Index apex = corners[k];
  const Index a = corners[(k + 1) % 3];
  const Index b = corners[(k + 2) % 3];
  if (problem.isFixed(static_cast<std::size_t>(a)) && problem.isFixed(static_cast<std::size_t>(b)))
  {
    return false; // it may be a crease
  }
  Index other = noIndex;
  for (const Index t : mesh.star(a))
  {
    const Triple& candidate = mesh.triangles()[t];
    if (t != triangle && std::find(candidate.begin(), candidate.end(), b) != candidate.end())
    {
      if (other != noIndex)
      {
        return false; // more than two triangles: the edge stays
      }
      other = t;
    }
  }
  if (other == noIndex)
  {
    return false;
  }
  const Triple across = mesh.triangles()[other];
  int far = 0;
  while (across[far] == a || across[far] == b)
  {
    ++far;
  }
  const Index opposite = across[far];
  const std::vector<Index> linked = mesh.neighbours(apex);
  const bool consistent = across[(far + 1) % 3] == b; // the two triangles turn the same way
  if (!consistent || opposite == apex || mesh.star(a).size() < 4 || mesh.star(b).size() < 4 ||
    std::binary_search(linked.begin(), linked.end(), opposite))
  {
    return false;
  }
  const std::array<Triple, 2> fresh{ Triple{ apex, a, opposite }, Triple{ apex, opposite, b } };
  if (mesh.cost(fresh[0]) + mesh.cost(fresh[1]) >
    mesh.cost(corners) + mesh.cost(across) - 0.5 * flippedCost)
  {
    return false;
  }
  mesh.replace({ triangle, other }, fresh);
  return true;
}

void mend(const PlacementProblem& problem, const std::vector<Point3>& surfacePlaces, Index triangle,
  Offset mostEdges, RepairedMesh& mesh, FlipRepair& repair)
{
  const Triple corners = mesh.triangles()[triangle];
  for (const Index vertex : corners)
  {
    if (mesh.isFlipped(corners) && !problem.isFixed(static_cast<std::size_t>(vertex)))
    {
      const std::array<Point3, 2> places{ problem.components.centroids[vertex],
        surfacePlaces[vertex] };
      repair.movedVertices += moveVertex(vertex, places, mesh);
    }
  }
  for (int k = 0; k < 3 && repair.flippedEdges < mostEdges; ++k)
  {
    if (mesh.isFlipped(mesh.triangles()[triangle]) && turnEdge(problem, triangle, k, mesh))
    {
      ++repair.flippedEdges;
    }
  }
}
}

Status repairFlips(const PlacementProblem& problem, const NearbySurface& surface,
  const std::vector<Point3>& surfacePlaces, const std::vector<Point3>& shapes,
  const RunControl& control, std::vector<Triple>& triangles, std::vector<Point3>& positions,
  FlipRepair& repair)
{
  repair = FlipRepair{};
  const auto count = static_cast<Offset>(triangles.size());
  const Offset mostEdges = (count / 1000 + 2) / 4;
  RepairedMesh mesh(problem, surface, shapes, triangles, positions);
  for (int pass = 0;; ++pass)
  {
    std::vector<char> flipped(triangles.size());
    if (!forEachRange(Blocks::cut(count, 64, 4096), control.silent(),
          [&](Offset begin, Offset end)
          {
            for (Offset t = begin; t < end; ++t)
            {
              flipped[t] = mesh.isFlipped(triangles[t]) ? 1 : 0;
            }
          }))
    {
      return Status::cancelled();
    }
    repair.flippedTriangles = std::count(flipped.begin(), flipped.end(), 1);
    if (repair.flippedTriangles == 0 || pass == mostPasses)
    {
      return Status::success();
    }
    for (Offset t = 0; t < count; ++t)
    {
      if (flipped[t] && mesh.isFlipped(triangles[t]))
      {
        mend(problem, surfacePlaces, static_cast<Index>(t), mostEdges, mesh, repair);
      }
      if (flipped[t] && control.cancelled())
      {
        return Status::cancelled();
      }
    }
  }
}
}
