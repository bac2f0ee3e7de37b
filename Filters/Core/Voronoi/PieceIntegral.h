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
#include <array>

namespace remesh
{
struct PieceIntegral
{
  double weights[3] = { 0.0, 0.0, 0.0 }; ///< of the facet's corners: centroid = sum w p / sum w
  double energy = 0.0;                   ///< integral of |x - x_i|^2 over the facet's mass

  /** Share of the facet's area. */
  double fraction() const { return this->weights[0] + this->weights[1] + this->weights[2]; }
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

/**
 * The two pieces of a facet that two cells share: the site of slot `single` owns corner k alone,
 * the other one the other two corners.
 * Returns the single one's piece, then the other's. O(1).
 */
inline std::array<PieceIntegral, 2> integrateTwoPieces(
  const FacetTiling& tiling, const FacetConstants& facet, int single, int k)
{
  const int other = 1 - single;
  const int l = (k + 1) % 3;
  const int m = (k + 2) % 3;
  const double* hs = tiling.site(single).h;
  const double* ho = tiling.site(other).h;
  // How far along the edges from corner k the bisector is, in [0, 1].
  const double gap = ho[k] - hs[k];
  const double alongL = std::min(1.0, gap / (gap + (hs[l] - ho[l])));
  const double alongM = std::min(1.0, gap / (gap + (hs[m] - ho[m])));
  double corners[4][3] = {}; // of the single one's triangle, then its centre
  corners[0][k] = 1.0;
  corners[1][k] = 1.0 - alongL;
  corners[1][l] = alongL;
  corners[2][k] = 1.0 - alongM;
  corners[2][m] = alongM;
  corners[3][l] = alongL / 3.0;
  corners[3][m] = alongM / 3.0;
  corners[3][k] = 1.0 - corners[3][l] - corners[3][m];

  std::array<PieceIntegral, 2> pieces;
  const double fraction = alongL * alongM;
  const auto meanSquare = [&](int slot)
  {
    return (tiling.squaredDistance(slot, corners[0]) + tiling.squaredDistance(slot, corners[1]) +
             tiling.squaredDistance(slot, corners[2]) +
             9.0 * tiling.squaredDistance(slot, corners[3])) /
      12.0;
  };
  const PieceIntegral whole = integrateWholeFacet(facet, ho);
  for (int c = 0; c < 3; ++c)
  {
    pieces[0].weights[c] = fraction * corners[3][c];
    pieces[1].weights[c] = whole.weights[c] - pieces[0].weights[c];
  }
  const double mass = facet.mass * fraction;
  pieces[0].energy = mass * meanSquare(single);
  pieces[1].energy = std::max(0.0, whole.energy - mass * meanSquare(other));
  return pieces;
}
}

#endif
