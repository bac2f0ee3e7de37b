#include "Placement/NearbySurface.h"

#include "Mesh/ClosestPoint.h"
#include "Mesh/FacetGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
NearbySurface::NearbySurface(const PlacementProblem& problem)
  : m_problem(problem)
  , m_reach(problem.mesh.facetPoints.size())
{
  for (Index f = 0; f < problem.mesh.numberOfFacets(); ++f)
  {
    const Point3& first = problem.facetPoint(f, 0);
    m_reach[f] = std::sqrt(std::max((problem.facetPoint(f, 1) - first).squaredNorm(),
      (problem.facetPoint(f, 2) - first).squaredNorm()));
  }
}

SurfaceLocation NearbySurface::closest(
  const Index* begin, const Index* end, const Point3& point) const
{
  const Components& components = m_problem.components;
  SurfaceLocation location{ noIndex, { 0.0, 0.0, 0.0 } };
  double nearest2 = std::numeric_limits<double>::infinity();
  double nearest = nearest2;
  for (const Index* component = begin; component != end; ++component)
  {
    for (Offset p = components.pieceBegin[*component]; p < components.pieceBegin[*component + 1];
         ++p)
    {
      const Index facet = m_problem.diagram.facets[components.pieces[p]];
      const Point3& a = m_problem.facetPoint(facet, 0);
      const double bound = nearest + m_reach[facet];
      if ((a - point).squaredNorm() > bound * bound)
      {
        continue;
      }
      const ClosestPoint found =
        closestOnTriangle(point, a, m_problem.facetPoint(facet, 1), m_problem.facetPoint(facet, 2));
      if (found.squared < nearest2 || (found.squared == nearest2 && facet < location.facet))
      {
        nearest2 = found.squared;
        nearest = std::sqrt(found.squared);
        location.facet = facet;
        std::copy_n(found.b, 3, location.b);
      }
    }
  }
  return location;
}

double NearbySurface::facingOf(const Triple& components, const std::array<Point3, 3>& corners) const
{
  const Point3 center = (corners[0] + corners[1] + corners[2]) / 3.0;
  const Index facet = this->closest(components.data(), components.data() + 3, center).facet;
  const Point3 normal = facetNormal(corners[0], corners[1], corners[2]);
  if (facet == noIndex || normal.isZero(0.0))
  {
    return -1.0;
  }
  return normal.dot(facetNormal(m_problem.facetPoint(facet, 0), m_problem.facetPoint(facet, 1),
    m_problem.facetPoint(facet, 2)));
}
}
