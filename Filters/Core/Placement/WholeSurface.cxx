#include "Placement/WholeSurface.h"

#include "Mesh/FacetGeometry.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr double asClose = 1e-6; // of the squared distance: more than rounding
}

WholeSurface::WholeSurface(const SurfaceMesh& mesh, const RunControl& control)
  : m_tree({ mesh.points, mesh.facetPoints }, control)
  , m_slots(mesh.facetPoints.size(), noIndex)
{
  for (Index slot = 0; slot < m_tree.size(); ++slot)
  {
    m_slots[m_tree.triangleOf(slot)] = slot;
  }
}

double WholeSurface::leastCosine(const Point3& place, const Point3& vector, Index facet) const
{
  const TriangleTree::Place closest =
    m_tree.closest(place, facet == noIndex ? noIndex : m_slots[facet]);
  double least = 1.0;
  m_tree.visitWithin(place, (1.0 + asClose) * closest.at.squared,
    [&](const TriangleTree::Place& near)
    {
      const auto& [a, b, c] = m_tree.cornersOf(near.slot);
      least = std::min(least, vector.dot(facetNormal(a, b, c)));
    });
  return least;
}
}
