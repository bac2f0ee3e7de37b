/**
 * @file FixedSites.h
 * @brief Sites on features take part in the diagram but do not move.
 */
#ifndef remesh_FixedSites_h
#define remesh_FixedSites_h

#include "Voronoi/CellSums.h"

#include <cmath>

namespace remesh
{
/** Norm of the gradient with respect to the free sites. */
inline double freeGradientNorm(const Sites& sites, const CellSums& sums)
{
  if (sites.fixed == 0)
  {
    return sums.gradientNorm;
  }
  double squared = 0.0;
  for (auto k = static_cast<std::size_t>(sites.fixed) * static_cast<std::size_t>(sites.dimension);
       k < sums.moment.size(); ++k)
  {
    squared += sums.moment[k] * sums.moment[k];
  }
  return 2.0 * std::sqrt(squared);
}

/** Takes the fixed sites out of the gradient: their moment becomes 0, and nothing moves them. */
inline void holdFixedSites(const Sites& sites, CellSums& sums)
{
  sums.gradientNorm = freeGradientNorm(sites, sums);
  std::fill_n(sums.moment.begin(),
    static_cast<std::size_t>(sites.fixed) * static_cast<std::size_t>(sites.dimension), 0.0);
}

/** Free sites without mass. */
inline Index countEmptyFree(const Sites& sites, const CellSums& sums)
{
  return static_cast<Index>(std::count_if(
    sums.mass.begin() + sites.fixed, sums.mass.end(), [](double m) { return !(m > 0.0); }));
}
}

#endif
