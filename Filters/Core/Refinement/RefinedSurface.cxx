#include "Refinement/RefinedSurface.h"

namespace remesh
{
FacetOrigins::FacetOrigins(const std::vector<FacetOrigin>& origins)
  : m_facets(origins.size())
{
  for (std::size_t f = 0; f < origins.size(); ++f)
  {
    const bool isWhole = origins[f].isWhole();
    m_facets[f] = isWhole ? origins[f].facet : -1 - static_cast<Index>(m_parts.size());
    if (!isWhole)
    {
      m_parts.push_back(origins[f]);
    }
  }
}

CornerCoordinates interpolateCorners(const SurfaceMesh& before, const SurfaceMesh& refined,
  const FacetOrigins& origins, const CornerCoordinates& coordinates)
{
  CornerCoordinates made;
  made.dimension = coordinates.dimension;
  const auto d = static_cast<std::size_t>(coordinates.dimension);
  made.values.assign(static_cast<std::size_t>(refined.numberOfCorners()) * d, 0.0);
  std::vector<char> done(refined.cornerPoints.size(), 0);
  for (std::size_t f = 0; f < origins.size(); ++f)
  {
    const FacetOrigin origin = origins[f];
    for (int k = 0; k < 3; ++k)
    {
      const Index corner = refined.facetCorners[f][k];
      for (int j = 0; j < 3 && !done[corner]; ++j)
      {
        const double weight = static_cast<double>(origin.corners[k][j]);
        const double* from = coordinates.values.data() +
          static_cast<std::size_t>(before.facetCorners[origin.facet][j]) * d;
        double* to = made.values.data() + static_cast<std::size_t>(corner) * d;
        for (std::size_t c = 0; c < d && weight > 0.0; ++c)
        {
          to[c] += weight * from[c];
        }
      }
      done[corner] = 1;
    }
  }
  return made;
}
}
