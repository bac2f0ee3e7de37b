/**
 * @file IsometrySteps.h
 * @brief Local and global steps towards places in R^d with the distances of a metric.
 *
 * The energy is that of IsometricEmbedding.h.
 *
 * 1. Local step: on each facet the nearest matrix with orthonormal rows, Q = (J J')^(-1/2) J.
 * 2. Global step: the places whose gradients are nearest to all Q. By the laplacian's factor; or,
 *    where only short waves are left, nearly, by some conjugate gradients.
 *
 * Source: O. Sorkine, M. Alexa, "As-rigid-as-possible surface modeling", 2007. The energy falls at
 * each step.
 */
#ifndef remesh_IsometrySteps_h
#define remesh_IsometrySteps_h

#include "Metric/LaplacianMatrix.h"

namespace remesh
{
struct StepOptions
{
  int iterations = 200;         ///< at most
  double energyDecrease = 0.15; ///< ends where ten steps lower the energy by less than this share
  const LaplacianMatrix* matrix = nullptr; ///< for conjugate gradients; nullptr: the factor
  int innerIterations = 0;                 ///< of these, for each step
};

/**
 * @param laplacian with a factor, where there is no matrix.
 * @param places V x d, in and out.
 * @param energies receives the energy per area: of the start, and after each step.
 * @return false when cancelled. Parallel, deterministic.
 */
[[nodiscard]] bool stepToIsometry(const MetricLaplacian& laplacian, const StepOptions& options,
  const RunControl& control, Rows& places, std::vector<double>& energies);

/** By how much a facet is stretched least and most. */
std::array<double, 2> stretchesOf(const FacetRows& gradient);
}

#endif
