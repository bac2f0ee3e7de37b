#include "Comparison/PointDistance.h"

#include "Mesh/EdgeTable.h"
#include "Mesh/FacetGeometry.h"
#include "Support/Parallel.h"

#include <cmath>

namespace remesh
{
SideNormals::SideNormals(const Triangles& surface, const RunControl& control)
  : m_triangles(surface.triangles)
{
  EdgeTable edges = buildEdgeTable(m_triangles, control);
  if (control.cancelled())
  {
    return;
  }
  m_edgeNormals.resize(static_cast<std::size_t>(edges.numberOfEdges()), Point3::Zero());
  m_pointNormals.resize(surface.points.size(), Point3::Zero());
  for (Offset t = 0; t < surface.count(); ++t)
  {
    const std::array<Point3, 3> p = surface.corners(t);
    if (!hasArea(p[0], p[1], p[2]))
    {
      continue;
    }
    const Point3 normal = facetNormal(p[0], p[1], p[2]);
    for (int k = 0; k < 3; ++k)
    {
      const Point3 u = (p[(k + 1) % 3] - p[k]).stableNormalized();
      const Point3 v = (p[(k + 2) % 3] - p[k]).stableNormalized();
      const double angle = 2.0 * std::atan2((u - v).norm(), (u + v).norm());
      m_pointNormals[m_triangles[t][k]] += angle * normal;
      m_edgeNormals[edges.facetEdges[t][k]] += normal;
    }
  }
  m_triangleEdges = std::move(edges.facetEdges);
}

bool SideNormals::isBehind(
  const Point3& point, const TriangleTree& tree, const TriangleTree::Place& place) const
{
  const Index triangle = tree.triangleOf(place.slot);
  const double* b = place.at.b;
  const int zeros = (b[0] == 0.0) + (b[1] == 0.0) + (b[2] == 0.0);
  const auto [p, q, r] = tree.cornersOf(place.slot);
  Point3 normal = facetNormal(p, q, r);
  if (zeros == 2)
  {
    const int corner = b[0] != 0.0 ? 0 : b[1] != 0.0 ? 1 : 2;
    normal = m_pointNormals[m_triangles[triangle][corner]];
  }
  else if (zeros == 1)
  {
    const int opposite = b[0] == 0.0 ? 0 : b[1] == 0.0 ? 1 : 2;
    normal = m_edgeNormals[m_triangleEdges[triangle][(opposite + 1) % 3]];
  }
  return (point - tree.positionOf(place)).dot(normal) < 0.0;
}

Status measurePointDistances(const std::vector<Point3>& points, const TriangleTree& surface,
  const SideNormals* sides, const RunControl& control, PointDistances& result)
{
  result.distances.assign(points.size(), std::numeric_limits<double>::quiet_NaN());
  result.behind.assign(sides ? points.size() : 0, 0);
  const Blocks blocks = Blocks::cut(static_cast<Offset>(points.size()), 1024, 4096);
  const bool done = forEachRange(blocks, control,
    [&](Offset begin, Offset end)
    {
      Index hint = noIndex;
      for (Offset k = begin; k < end; ++k)
      {
        if (!points[k].allFinite())
        {
          continue;
        }
        const TriangleTree::Place place = surface.closest(points[k], hint);
        if (place.slot == noIndex)
        {
          continue; // too far for a distance
        }
        hint = place.slot;
        result.distances[k] = std::sqrt(place.at.squared);
        if (sides)
        {
          result.behind[k] = sides->isBehind(points[k], surface, place) ? 1 : 0;
        }
      }
    });
  return done ? Status::success() : Status::cancelled();
}
}
