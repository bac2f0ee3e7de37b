/**
 * @file Lloyd.h
 * @brief Anisotropic Lloyd relaxation in R^d, [Levy12] Algorithm 3.
 *
 * Each step moves every site to the centroid of its restricted cell, x_i <- g_i. The CVT energy
 * F = sum_i int_{cell i} |x - x_i|^2 dx never rises.
 */
#ifndef remesh_Lloyd_h
#define remesh_Lloyd_h

#include "Optimization/Relaxation.h"

namespace remesh
{
/**
 * Runs `iterations` steps; on return `sums` belongs to the final sites, and `convergence` has one
 * more row for the sites as they were given, of step length 0, and one for each step.
 */
Status relaxLloyd(const Relaxation& relaxation, int iterations, const RunControl& control);
}

#endif
