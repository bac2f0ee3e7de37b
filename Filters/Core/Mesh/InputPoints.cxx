#include "Mesh/InputPoints.h"

namespace remesh
{
InputPoints::InputPoints(const SharedArray<Triple>& facetPoints, Index numberOfPoints,
  std::vector<std::array<Offset, 3>> ofFacets)
  : m_facetPoints(facetPoints)
  , m_ofPoints(static_cast<std::size_t>(numberOfPoints), -1)
{
  for (std::size_t f = 0; f < facetPoints.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      Offset& own = m_ofPoints[facetPoints[f][k]];
      own = own < 0 ? ofFacets[f][k] : own;
      if (own != ofFacets[f][k])
      {
        m_ofPoints.clear();
        m_ofFacets = std::move(ofFacets);
        return;
      }
    }
  }
}
}
