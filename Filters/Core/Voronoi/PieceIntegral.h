/**
 * @file PieceIntegral.h
 * @brief Mass, centroid and energy of a piece, without leaving barycentric coordinates.
 *
 * Independent of d but for the H values: over a triangle with vertices u, v, w and centroid c,
 * the integral of |x - x_i|^2 is mass / 12 (|u|^2 + |v|^2 + |w|^2 + 9 |c|^2), all from x_i.
 */
#ifndef remesh_PieceIntegral_h
#define remesh_PieceIntegral_h

#include "Voronoi/FacetTiling.h"

#include <algorithm>

namespace remesh
{
/** Which part of its facet a piece is. */
struct PieceWeights
{
  double weights[3] = { 0.0, 0.0, 0.0 }; ///< of the facet's corners: centroid = sum w p / sum w

  /** Share of the facet's area. */
  double fraction() const { return this->weights[0] + this->weights[1] + this->weights[2]; }
};

struct PieceIntegral : PieceWeights
{
  double energy = 0.0; ///< integral of |x - x_i|^2 over the facet's mass
};

/** A piece of site `slot`. O(vertices). */
inline PieceIntegral integratePiece(
  const FacetTiling& tiling, const FacetConstants& facet, const Polygon& polygon, int slot)
{
  PieceIntegral sum;
  const std::size_t size = polygon.size();
  for (std::size_t v = 1; v + 1 < size; ++v)
  {
    const double* p = polygon[0].b;
    const double* q = polygon[v].b;
    const double* r = polygon[v + 1].b;
    const double share = (q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1]);
    double center[3];
    for (int k = 0; k < 3; ++k)
    {
      center[k] = (p[k] + q[k] + r[k]) / 3.0;
      sum.weights[k] += share * center[k];
    }
    sum.energy += share *
      (tiling.squaredDistance(slot, p) + tiling.squaredDistance(slot, q) +
        tiling.squaredDistance(slot, r) + 9.0 * tiling.squaredDistance(slot, center));
  }
  sum.energy *= facet.mass / 12.0;
  return sum;
}

/** The same for a facet that lies wholly in the cell of a site with these H values. */
inline PieceIntegral integrateWholeFacet(const FacetConstants& facet, const double h[3])
{
  const double third = 1.0 / 3.0;
  const double affine = (h[0] + h[1] + h[2]) / 3.0;
  const double quadratic = (facet.edge2[0] + facet.edge2[1] + facet.edge2[2]) / 12.0;
  return { { third, third, third }, facet.mass * std::max(0.0, affine - quadratic) };
}
}

#endif
