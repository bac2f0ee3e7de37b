/**
 * @file QuadraticFit.h
 * @brief Second derivatives along a surface, of functions given at its points and of itself.
 *
 * For each side of a point (SurfaceSides.h):
 *
 * 1. Take the points of two rings around it.
 * 2. Lay them into a plane: the direction is that of the projection, the length that to the point.
 * 3. Fit quadratic functions to the values, and to the heights above the plane, by least squares;
 *    near points count more. Coordinates are those in which the points have the covariance 1: the
 *    fit is the same however the neighbourhood is stretched.
 * 4. Turn the plane into the heights' tangent plane, and do 2 and 3 again.
 *
 * Exact for quadratic functions on a plane. Where there are too few points for a quadratic
 * function, as on a few triangles between creases, the least one that fits them.
 *
 * Source: X. Jiao, H. Zha, "Consistent computation of first- and second-order differential
 * quantities for surface meshes", 2008 (local fits in tangent planes).
 * Cost: O(points x (1 + functions)), some 10 us each, in parallel. Deterministic.
 */
#ifndef remesh_QuadraticFit_h
#define remesh_QuadraticFit_h

#include "Metric/MetricLaplacian.h" // Rows
#include "Metric/SurfaceSides.h"
#include "Metric/Tensor2.h"

namespace remesh
{
/** A side's tangent plane, and second derivatives in it. */
struct FittedSide
{
  Point3 x; ///< unit
  Point3 y; ///< unit, across x
  Point3 normal;
  Tensor2 bend; ///< second fundamental form: eigenvalues are the curvatures, 1 / length
};

struct QuadraticFits
{
  std::vector<FittedSide> sides;
  /** For each side one of each function; row by row. */
  std::vector<Tensor2> hessians;
  std::size_t functions = 0;

  const Tensor2& hessian(std::size_t side, std::size_t function) const
  {
    return this->hessians[side * this->functions + function];
  }
};

/** @param values V x functions. @return Cancelled. */
Status fitQuadratics(
  const SurfaceSides& sides, const Rows& values, const RunControl& control, QuadraticFits& fits);
}

#endif
