#include "Placement/Retreat.h"

#include "Placement/TriangleShape.h"
#include "Support/SortUnique.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr int mostRings = 4; // farther ones cost more accuracy, and turned no more back

/** The triangles with a vertex among these, ascending. */
std::vector<Index> trianglesAround(const std::vector<Index>& vertices, const VertexStars& stars)
{
  std::vector<Index> triangles;
  for (const Index vertex : vertices)
  {
    triangles.insert(triangles.end(), stars.triangles.begin() + stars.begin(vertex),
      stars.triangles.begin() + stars.end(vertex));
  }
  sortUnique(triangles);
  return triangles;
}

std::vector<Index> verticesOf(const std::vector<Index>& some, const std::vector<Triple>& triangles)
{
  std::vector<Index> vertices;
  for (const Index t : some)
  {
    vertices.insert(vertices.end(), triangles[t].begin(), triangles[t].end());
  }
  sortUnique(vertices);
  return vertices;
}
}

Offset retreat(const PlacementProblem& problem, const NearbySurface& surface,
  const std::vector<Point3>& others, const std::vector<Index>& flipped, const RunControl& control,
  std::vector<Point3>& positions)
{
  const VertexStars stars(problem.triangles, problem.numberOfVertices());
  const auto isFlipped = [&](Index t)
  { return surface.isFlipped(problem.triangles[t], cornersOf(problem.triangles[t], positions)); };
  Offset moved = 0;
  for (const Index triangle : flipped)
  {
    if (control.cancelled())
    {
      break;
    }
    const Triple& corners = problem.triangles[triangle];
    std::vector<Index> region(corners.begin(), corners.end());
    for (int ring = 0; ring <= mostRings && isFlipped(triangle); ++ring)
    {
      const std::vector<Index> touched = trianglesAround(region, stars);
      std::vector<Point3> former;
      for (const Index vertex : region)
      {
        former.push_back(positions[vertex]);
        positions[vertex] = others[vertex];
      }
      if (std::none_of(touched.begin(), touched.end(), isFlipped))
      {
        moved += static_cast<Offset>(region.size());
        break;
      }
      for (std::size_t k = 0; k < region.size(); ++k)
      {
        positions[region[k]] = former[k];
      }
      region = verticesOf(touched, problem.triangles);
    }
  }
  return moved;
}

void retreatAround(const PlacementProblem& problem, const std::vector<Point3>& others,
  const std::vector<Index>& flipped, int rings, std::vector<Point3>& positions)
{
  const VertexStars stars(problem.triangles, problem.numberOfVertices());
  std::vector<Index> region = verticesOf(flipped, problem.triangles);
  for (int ring = 0; ring < rings; ++ring)
  {
    region = verticesOf(trianglesAround(region, stars), problem.triangles);
  }
  for (const Index vertex : region)
  {
    positions[vertex] = others[vertex];
  }
}
}
