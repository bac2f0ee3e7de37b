#include "Placement/NearbySurface.h"

#include "Mesh/ClosestPoint.h"
#include "Mesh/FacetGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
Point3 centroidOf(const std::array<Point3, 3>& corners)
{
  return (corners[0] + corners[1] + corners[2]) / 3.0;
}
}

NearbySurface::NearbySurface(
  const PlacementProblem& problem, double leastHeight, const WholeSurface* whole)
  : m_problem(problem)
  , m_leastHeight(leastHeight)
  , m_whole(whole)
  , m_reach(problem.mesh.facetPoints.size())
{
  for (Index f = 0; f < problem.mesh.numberOfFacets(); ++f)
  {
    const Point3& first = problem.facetPoint(f, 0);
    const double reach = std::sqrt(std::max((problem.facetPoint(f, 1) - first).squaredNorm(),
      (problem.facetPoint(f, 2) - first).squaredNorm()));
    m_reach[f] = std::nextafter(static_cast<float>(reach), std::numeric_limits<float>::infinity());
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

bool NearbySurface::isFlat(const std::array<Point3, 3>& corners) const
{
  constexpr double sliver = 0.01; // of the length
  const double length = std::sqrt(std::max({ (corners[1] - corners[0]).squaredNorm(),
    (corners[2] - corners[1]).squaredNorm(), (corners[0] - corners[2]).squaredNorm() }));
  return 2.0 * facetArea(corners[0], corners[1], corners[2]) <
    length * std::min(m_leastHeight, sliver * length);
}

Point3 NearbySurface::closestPoint(const Index* begin, const Index* end, const Point3& point) const
{
  const SurfaceLocation at = this->closest(begin, end, point);
  if (at.facet == noIndex)
  {
    return point;
  }
  return at.b[0] * m_problem.facetPoint(at.facet, 0) + at.b[1] * m_problem.facetPoint(at.facet, 1) +
    at.b[2] * m_problem.facetPoint(at.facet, 2);
}

Index NearbySurface::facetNear(const Triple& components, const std::array<Point3, 3>& corners) const
{
  return this->closest(components.data(), components.data() + 3, centroidOf(corners)).facet;
}

Point3 NearbySurface::normalOf(Index facet) const
{
  return facet == noIndex ? Point3(Point3::Zero())
                          : facetNormal(m_problem.facetPoint(facet, 0),
                              m_problem.facetPoint(facet, 1), m_problem.facetPoint(facet, 2));
}

Point3 NearbySurface::normalNear(
  const Triple& components, const std::array<Point3, 3>& corners) const
{
  return this->normalOf(this->facetNear(components, corners));
}

Facing NearbySurface::facingOf(const Triple& components, const std::array<Point3, 3>& corners) const
{
  const Point3 normal = facetNormal(corners[0], corners[1], corners[2]);
  const Index facet = this->facetNear(components, corners);
  const Point3 wanted = this->normalOf(facet);
  if (normal.isZero(0.0) || wanted.isZero(0.0) || this->isFlat(corners))
  {
    return { -1.0, -1.0 };
  }
  const double cosine = normal.dot(wanted);
  return { cosine,
    m_whole && cosine >= 0.0
      ? std::min(cosine, m_whole->leastCosine(centroidOf(corners), normal, facet))
      : cosine };
}
}
