#include "Placement/WholeSurface.h"

#include "Mesh/Extent.h"
#include "Mesh/FacetGeometry.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace remesh
{
namespace
{
constexpr double asClose = 1e-6;  // of the distance: more than rounding
constexpr double asExact = 1e-12; // of the surface's size, for places on it
}

WholeSurface::WholeSurface(const SurfaceMesh& mesh, const RunControl& control)
  : m_facets{ mesh.points, mesh.facetPoints }
  , m_tree(m_facets, control)
  , m_rounding(asExact * boundingBoxDiagonal(mesh))
{
}

double WholeSurface::minCosine(
  const Point3& place, const Point3& vector, Index facet, double within) const
{
  std::vector<TriangleTree::Place> closest;
  closest.reserve(8);
  const auto [p, q, r] = m_facets.corners(facet);
  const double known = closestOnTriangle(place, p, q, r).squared;
  m_tree.findClosest(place, { asClose, m_rounding }, known, closest);
  double nearest = std::numeric_limits<double>::infinity();
  for (const TriangleTree::Place& near : closest)
  {
    nearest = std::min(nearest, near.at.squared);
  }
  if (std::sqrt(nearest) * (1.0 + asClose) + m_rounding >= within)
  {
    return 1.0;
  }
  double least = 1.0;
  for (const TriangleTree::Place& near : closest)
  {
    const auto [a, b, c] = m_tree.cornersOf(near.slot);
    least = std::min(least, vector.dot(facetNormal(a, b, c)));
  }
  return least;
}
}
