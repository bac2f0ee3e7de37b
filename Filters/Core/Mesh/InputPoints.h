/**
 * @file InputPoints.h
 * @brief Which of the caller's points each facet has at its corners.
 *
 * The caller may have several points at one place, of which facets that share a point of the mesh
 * use different ones. As a rule there is one for each, and only those are held.
 */
#ifndef remesh_InputPoints_h
#define remesh_InputPoints_h

#include "Support/SharedArray.h"
#include "Support/Types.h"

namespace remesh
{
class InputPoints
{
public:
  InputPoints() = default;
  /**
   * @param facetPoints F x 3, points of the mesh.
   * @param ofFacets F x 3, the caller's points there.
   */
  InputPoints(const SharedArray<Triple>& facetPoints, Index numberOfPoints,
    std::vector<std::array<Offset, 3>> ofFacets);

  /** The caller's ids at the three corners of a facet. */
  std::array<Offset, 3> operator[](std::size_t facet) const
  {
    if (!m_ofFacets.empty())
    {
      return m_ofFacets[facet];
    }
    const auto& [a, b, c] = m_facetPoints[facet];
    return { m_ofPoints[a], m_ofPoints[b], m_ofPoints[c] };
  }
  std::size_t size() const { return m_facetPoints.size(); } ///< F
  /** Whether facets that share a point of the mesh use different ones of the caller's there. */
  bool differ() const { return !m_ofFacets.empty(); }

private:
  SharedArray<Triple> m_facetPoints;
  std::vector<Offset> m_ofPoints;                ///< V; none where facets differ
  std::vector<std::array<Offset, 3>> m_ofFacets; ///< F x 3, there
};
}

#endif
