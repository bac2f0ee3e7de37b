/**
 * @file SolutionMetric.h
 * @brief The metric that a given number of points is spent best by, for functions on a surface.
 *
 * 1. The Hessian H of each function along the surface (QuadraticFit.h), or a given one; of a
 *    vector the root of the sum of its components' squares. |H| has the eigenvalues' absolute
 *    values, the smaller of which is raised to the larger over `maximumRatio` squared.
 * 2. The metric det |H|^(-1 / (2 p + 2)) |H|, in which even triangles have the least error of
 * linear interpolation in L^p. [Loseille11]
 * 3. The metrics of several functions, each for the same number of points, are intersected, and
 *    with them what asks for lengths: curvature and a chord's height, given metrics, sizes. All are
 *    held between the smallest and the largest size, and to the ratio.
 * 4. The functions' metrics are scaled, all alike, until a mesh whose edges have the length 1 has
 *    the number of points.
 *
 * At a crease, this is done on each side; the sides' metrics are intersected in space.
 *
 * Source: A. Loseille, F. Alauzet, "Continuous mesh framework part I: well-posed continuous
 * interpolation error", SIAM J. Numer. Anal., 2011. [Loseille11]
 * Cost: that of the fits, and some twenty passes over the points, in parallel. Deterministic.
 */
#ifndef remesh_SolutionMetric_h
#define remesh_SolutionMetric_h

#include "Metric/MetricLaplacian.h" // Rows
#include "Support/Symmetric3.h"

namespace remesh
{
enum class ErrorNorm
{
  L1,
  L2,
  L4,
  Maximum
};

struct SolutionMetricOptions
{
  ErrorNorm norm = ErrorNorm::L2;
  double numberOfPoints = 10000; ///< above 0
  double minimumSize = 0.0;      ///< length; 0: none
  double maximumSize = 0.0;      ///< length; 0: the diagonal of the bounding box
  double maximumRatio = 1000.0;  ///< of lengths along and across a triangle, from 1
  double chordTolerance = 0.0;   ///< length: an edge's largest distance to a bend; 0: none
};

/** What a metric is made for; nothing of it need be there. */
struct SolutionMetricInput
{
  Rows values;                                           ///< V x components of all functions
  std::vector<int> components;                           ///< of each function, one after the other
  std::vector<std::vector<Symmetric3<double>>> hessians; ///< of each further function, V
  std::vector<std::vector<Symmetric3<double>>> metrics;  ///< V each, positive definite
  std::vector<double> sizes;                             ///< V, above 0; or none
};

struct SolutionMetric
{
  std::vector<Symmetric3<double>> tensors; ///< V; across the surface the larger size
  double points = 0.0;                     ///< of a mesh with edges of length 1
  double minPoints = 0.0;                  ///< that all but the functions ask for
  bool isConstant = false; ///< whether all functions are linear: they ask for no points
};

/** @return Cancelled, or InvalidInput with a sentence where an option is out of its range. */
Status makeSolutionMetric(const SurfaceMesh& mesh, const SolutionMetricInput& input,
  const SolutionMetricOptions& options, RunControl control, SolutionMetric& metric);
}

#endif
