/**
 * @file QuasiNewton.h
 * @brief L-BFGS on the CVT energy: where Lloyd's iterations crawl, it converges.
 *
 * The energy F(X) = sum_i int_{cell i} |x - x_i|^2 dx is C^2 with gradient 2 m_i (x_i - g_i)
 * (Y. Liu et al., "On Centroidal Voronoi Tessellation: Energy Smoothness and Fast Computation",
 * 2009). Two-loop recursion of J. Nocedal (1980) with diag(2 m_i), scaled to the last step's
 * curvature, as initial Hessian: the first step is Lloyd's. A backtracking line search keeps the
 * energy falling; the unit step is nearly always taken. No site goes farther in it than twice the
 * root mean square radius of its cell. Positions and gradients are doubles; the history is held in
 * two bytes a number, and the recursion works on floats (HistoryPass.h).
 */
#ifndef remesh_QuasiNewton_h
#define remesh_QuasiNewton_h

#include "Optimization/Relaxation.h"

namespace remesh
{
struct QuasiNewtonOptions
{
  int iterations = 30;
  int historyLength = 7; ///< pairs of steps and gradient changes, each n x d numbers
  /** Stops where the gradient's norm is at most this fraction of the first row's; 0: never. */
  double gradientTolerance = 0.0;
  /** Stops where a step lowers the energy by at most this fraction of it; 0: only if by none. */
  double energyTolerance = 0.0;
};

/** Of a pair of the history, for each coordinate of a site. */
constexpr double historyBytes = 4.0;

/**
 * The pairs that a run keeps of those wanted. Where a pair takes more than 16 MB and there are many
 * dimensions, as many as fit into a twelfth of the embedding's own memory, but at least 3. A run
 * makes one more for a short time.
 */
int historyWithin(const EmbeddedSurface& surface, Offset numberOfSites, int wanted);

/**
 * Minimises from `sites`, whose integrals are `sums`; both belong to the best sites on return, and
 * `convergence`, which has at least its first row, gets one more for each step. A site that loses
 * its cell is moved, and the history forgotten.
 */
Status minimizeQuasiNewton(
  const Relaxation& relaxation, const QuasiNewtonOptions& options, const RunControl& control);
}

#endif
