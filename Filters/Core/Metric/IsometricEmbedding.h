/**
 * @file IsometricEmbedding.h
 * @brief Places in R^d whose distances along the surface are those of a metric.
 *
 * Each facet has a shape in the metric. With the gradient J (2 x d) of the places on it, the
 * energy is the sum of area |J - Q|^2, Q being the nearest matrix with orthonormal rows: 0 where
 * all facets have their shapes.
 *
 * 1. The surface is made coarser, to sides of a unit (MetricCoarsening.h).
 * 2. Start: the eigenfunctions of the metric's Laplacian (SpectralStart.h).
 * 3. Local and global steps (IsometrySteps.h), with one factor for all.
 * 4. Waves shorter than some units are taken out, and steps mend what that changes.
 * 5. The same on the given surface, from there: what is left are short waves, for which some
 *    conjugate gradients do instead of a factor.
 *
 * Few steps on purpose. Where no smooth surface of R^d has the metric, a crumpled one still may
 * (J. Nash, 1954), and what lowers the energy faster, or for longer, finds its way there. Measured
 * on a torus stretched 10 : 1 along a direction that winds around it, 28 800 points, edges of a
 * remeshing within [1/sqrt 2, sqrt 2] of the mean: 60 steps 0.881; 200 steps of a quasi-Newton
 * method with the same preconditioner 0.649, for an energy lower by 5 %; steps 1.9 times as long
 * 0.815. Crumples are what the fourth step is for: without it the coarse surface's stay.
 */
#ifndef remesh_IsometricEmbedding_h
#define remesh_IsometricEmbedding_h

#include "Metric/MetricField.h"

namespace remesh
{
struct IsometryOptions
{
  int dimension = 6;            ///< 2 to maxEmbeddingDimensions
  int iterations = 200;         ///< at most
  double energyDecrease = 0.15; ///< ends where ten steps lower the energy by less than this share
  double unit = 0.0; ///< edges of the mesh that it is for; 0: no coarse surface, nor is it smoothed
  std::uint64_t seed = 0;
};

struct IsometricEmbedding
{
  Rows places; ///< V x d, in units of the metric
  /** F x 2: by how much the facet is stretched least and most. */
  std::vector<std::array<float, 2>> stretches;
  std::vector<double> energies; ///< per area: of the start, and after each step
};

/** Deterministic. @return Cancelled, or InvalidInput where the metric cannot be worked on. */
Status embedIsometrically(const ShapedFacets& surface, const IsometryOptions& options,
  RunControl control, IsometricEmbedding& embedding);
}

#endif
