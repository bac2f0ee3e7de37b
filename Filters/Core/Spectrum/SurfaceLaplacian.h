/**
 * @file SurfaceLaplacian.h
 * @brief The Laplacian of a surface as two sparse matrices: of linear finite elements.
 *
 * Stiffness K: the cotangents of the angles opposite to each edge, halved. Mass M: consistent (the
 * integrals of the products of hat functions) or lumped (a third of the area around each point).
 * K f = lambda M f has the eigenfunctions of the surface.
 */
#ifndef remesh_SurfaceLaplacian_h
#define remesh_SurfaceLaplacian_h

#include "Mesh/SurfaceMesh.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

#include <Eigen/SparseCore>

namespace remesh
{
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor, Index>;

enum class MassMatrix
{
  Lumped,
  Consistent
};

/** What functions do at the surface's borders, edges of one facet. */
enum class BorderCondition
{
  Natural, ///< no slope across (Neumann)
  Fixed    ///< 0 (Dirichlet)
};

struct SurfaceLaplacian
{
  std::vector<Index> unknowns; ///< V, the matrices' row of each point; noIndex: fixed at 0
  Index size = 0;              ///< n, of the matrices
  SparseRows stiffness;        ///< n x n, all entries
  SparseRows mass;             ///< n x n, of the same pattern, or diagonal
  double area = 0.0;
  /** n, the component that a row belongs to where constants of it have no energy, else noIndex. */
  std::vector<Index> constants;
  Index numberOfConstants = 0; ///< components of which constants have no energy
};

/** @return Cancelled, or InvalidInput where borders are fixed and there is no other point. O(F). */
Status buildLaplacian(const SurfaceMesh& mesh, MassMatrix mass, BorderCondition border,
  const RunControl& control, SurfaceLaplacian& laplacian);
}

#endif
