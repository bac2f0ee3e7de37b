#include "Repair/RepairedMesh.h"

#include "Placement/TriangleShape.h"
#include "Support/SortUnique.h"

#include <algorithm>
#include <numeric>

namespace remesh
{
namespace
{
constexpr double stretchWeight = 0.05;
constexpr double largestStretch = 10.0;
}

RepairedMesh::RepairedMesh(const PlacementProblem& problem, const NearbySurface& surface,
  const std::vector<Point3>& shapes, std::vector<Triple>& triangles, std::vector<Point3>& positions)
  : m_surface(surface)
  , m_shapes(shapes)
  , m_triangles(triangles)
  , m_positions(positions)
  , m_stars(triangles, problem.numberOfVertices())
{
  if (problem.featureEdges)
  {
    for (const FeatureSegment& segment : *problem.featureEdges)
    {
      m_featureEdges.insert(std::minmax(segment.ends[0], segment.ends[1]));
    }
  }
}

std::vector<Index> RepairedMesh::star(Index vertex) const
{
  if (const auto found = m_changedStars.find(vertex); found != m_changedStars.end())
  {
    return found->second;
  }
  return { m_stars.triangles.begin() + m_stars.begin(vertex),
    m_stars.triangles.begin() + m_stars.end(vertex) };
}

std::vector<Index> RepairedMesh::neighbours(Index vertex) const
{
  std::vector<Index> around;
  for (const Index t : this->star(vertex))
  {
    std::copy_if(m_triangles[t].begin(), m_triangles[t].end(), std::back_inserter(around),
      [vertex](Index other) { return other != vertex; });
  }
  sortUnique(around);
  return around;
}

Point3 RepairedMesh::onSurface(Index vertex, const Point3& place) const
{
  std::vector<Index> cells = this->neighbours(vertex);
  cells.push_back(vertex);
  return m_surface.closestPoint(cells.data(), cells.data() + cells.size(), place);
}

bool RepairedMesh::isInverted(const Triple& triangle) const
{
  return m_surface.isInverted(triangle, cornersOf(triangle, m_positions));
}

double RepairedMesh::cost(const Triple& triangle) const
{
  const Corners corners = cornersOf(triangle, m_positions);
  const Facing facing = m_surface.facingOf(triangle, corners);
  const double stretch = stretchRatio(cornersOf(triangle, m_shapes), corners);
  const double flip = facing.cosine < 0.0 ? invertedCost : facing.least < 0.0 ? strayCost : 0.0;
  return flip + (1.0 - facing.cosine) + stretchWeight * std::min(stretch, largestStretch);
}

double RepairedMesh::costOfStar(const std::vector<Index>& star) const
{
  return std::accumulate(star.begin(), star.end(), 0.0,
    [&](double sum, Index t) { return sum + this->cost(m_triangles[t]); });
}

/** The one other triangle on an edge, or noIndex. */
Index RepairedMesh::acrossEdge(Index triangle, Index a, Index b) const
{
  Index other = noIndex;
  for (const Index t : this->star(a))
  {
    if (t != triangle && has(m_triangles[t], b))
    {
      if (other != noIndex)
      {
        return noIndex; // more than two triangles
      }
      other = t;
    }
  }
  return other;
}

/** Whether a vertex keeps a sound star with one triangle less. */
bool RepairedMesh::mayLose(Index vertex) const
{
  const std::size_t triangles = this->star(vertex).size();
  const bool isOpen = this->neighbours(vertex).size() > triangles;
  return triangles > (isOpen ? 1 : 3);
}

Index RepairedMesh::beyond(Index triangle, int k) const
{
  const Index a = m_triangles[triangle][(k + 1) % 3];
  const Index b = m_triangles[triangle][(k + 2) % 3];
  const Index other = this->acrossEdge(triangle, a, b);
  if (other == noIndex || m_featureEdges.count(std::minmax(a, b)) > 0)
  {
    return noIndex;
  }
  const Triple& across = m_triangles[other];
  const auto at = std::find(across.begin(), across.end(), b) - across.begin();
  return across[(at + 1) % 3] == a ? other : noIndex;
}

bool RepairedMesh::canFlip(Index triangle, int k, EdgeFlip& flip) const
{
  const Index other = this->beyond(triangle, k);
  if (other == noIndex)
  {
    return false;
  }
  const Triple corners = m_triangles[triangle];
  const Index apex = corners[k];
  const Index a = corners[(k + 1) % 3];
  const Index b = corners[(k + 2) % 3];
  const Triple& across = m_triangles[other];
  const Index opposite = *std::find_if(
    across.begin(), across.end(), [a, b](Index vertex) { return vertex != a && vertex != b; });
  const std::vector<Index> linked = this->neighbours(apex);
  if (opposite == apex || std::binary_search(linked.begin(), linked.end(), opposite) ||
    !this->mayLose(a) || !this->mayLose(b))
  {
    return false;
  }
  flip = { { triangle, other }, { Triple{ apex, a, opposite }, Triple{ apex, opposite, b } } };
  return true;
}

void RepairedMesh::apply(const EdgeFlip& flip)
{
  this->replace({ flip.old.begin(), flip.old.end() }, { flip.fresh.begin(), flip.fresh.end() });
}

void RepairedMesh::replace(const std::vector<Index>& old, const std::vector<Triple>& fresh)
{
  for (const Index t : old)
  {
    for (const Index vertex : m_triangles[t])
    {
      std::vector<Index> rest = this->star(vertex);
      rest.erase(std::remove(rest.begin(), rest.end(), t), rest.end());
      m_changedStars[vertex] = rest;
    }
  }
  for (std::size_t k = 0; k < old.size(); ++k)
  {
    m_triangles[old[k]] = fresh[k];
    for (const Index vertex : fresh[k])
    {
      std::vector<Index>& more = m_changedStars[vertex];
      more.insert(std::upper_bound(more.begin(), more.end(), old[k]), old[k]);
    }
  }
}
}
