/**
 * @file SpectralStart.h
 * @brief The smoothest functions on a surface, as places in R^d to start from.
 */
#ifndef remesh_SpectralStart_h
#define remesh_SpectralStart_h

#include "Metric/MetricLaplacian.h"

namespace remesh
{
/**
 * On each component of the surface the first d eigenfunctions of the Laplacian but for the
 * constant, over the roots of their eigenvalues, scaled so that facets keep their size on average.
 * By a few steps of block inverse iteration with the laplacian's factor (for a start that is near,
 * not for exact eigenfunctions). Where a component has too few points for d, zeros follow.
 *
 * @param places V x d.
 * @return false when cancelled.
 */
bool makeSpectralStart(const MetricLaplacian& laplacian, int dimension, std::uint64_t seed,
  const RunControl& control, Rows& places);
}

#endif
