/**
 * @file IsometricEmbedding.h
 * @brief Places in R^d whose distances along the surface are those of a metric.
 *
 * Each facet has a shape in the metric. With the gradient J (2 x d) of the places on it, the
 * energy is the sum of area |J - Q|^2, Q being the nearest matrix with orthonormal rows: 0 where
 * all facets have their shapes.
 *
 * 1. Start: the eigenfunctions of the metric's Laplacian (SpectralStart.h).
 * 2. Local step: Q = (J J')^(-1/2) J, in closed form.
 * 3. Global step: the places whose gradients are nearest to all Q, with one factor for all steps
 *    (O. Sorkine, M. Alexa, "As-rigid-as-possible surface modeling", 2007). The energy falls at
 *    every step.
 *
 * Few steps on purpose. Where no smooth surface of R^d has the metric, a crumpled one still may
 * (J. Nash, 1954), and what lowers the energy faster, or for longer, finds its way there. Measured
 * on a torus stretched 10 : 1 along a direction that winds around it, 28 800 points, edges of a
 * remeshing within [1/sqrt 2, sqrt 2] of the mean: 60 steps 0.881; 200 steps of a quasi-Newton
 * method with the same preconditioner 0.649, for an energy lower by 5 %; steps 1.9 times as long
 * 0.815.
 */
#ifndef remesh_IsometricEmbedding_h
#define remesh_IsometricEmbedding_h

#include "Metric/MetricLaplacian.h"

namespace remesh
{
struct IsometryOptions
{
  int dimension = 6;            ///< 2 to mostEmbeddingDimensions
  int iterations = 200;         ///< at most
  double energyDecrease = 0.15; ///< ends where ten steps lower the energy by less than this share
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
Status embedIsometrically(const SurfaceMesh& mesh, const std::vector<TargetShape>& shapes,
  const IsometryOptions& options, RunControl control, IsometricEmbedding& embedding);
}

#endif
