/**
 * @file CellForms.h
 * @brief What the facets of each cell say together: their planes, and their metric in R^d.
 */
#ifndef remesh_CellForms_h
#define remesh_CellForms_h

#include "Placement/PlacementProblem.h"
#include "Support/RunControl.h"
#include "Support/Symmetric3.h"

namespace remesh
{
/** Sums over the pieces of components, a their areas in R^3, n their facets' unit normals. */
struct CellQuadrics
{
  std::vector<Symmetric3<double>> quadrics; ///< K, sum of a n n^T
  std::vector<Point3> slopes;               ///< K, sum of a (n . (p - centroid)) n, p in the plane
  std::vector<double> radii;                ///< K, how far the pieces' centres are from centroids
};

/** What a fit reads of them, too. */
struct CellForms
{
  std::vector<Point3> normals; ///< K, sum of a n
  /**
   * K, the mean of the metrics that R^d and the density give the facets, scaled units: in them the
   * sites are equally far apart. Each is a tensor of R^3 that takes normals for as long as the
   * geometric mean of the plane's directions. Zero without area.
   */
  std::vector<Symmetric3<double>> metrics;
  /**
   * How much normals vary within cells, 0 to 2/3: the share of the quadrics' traces beside their
   * largest eigenvalues, the mean over the cells of vertices that are not fixed.
   */
  double variation = 0.0;
};

/**
 * Cost: O(pieces), whatever d is. Parallel, deterministic.
 *
 * @return false when cancelled.
 */
[[nodiscard]] bool measureCells(const PlacementProblem& problem, const RunControl& control,
  CellQuadrics& planes, CellForms& forms);
}

#endif
