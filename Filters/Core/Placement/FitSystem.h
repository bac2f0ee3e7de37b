/**
 * @file FitSystem.h
 * @brief The normal equations of one round of the surface fit.
 */
#ifndef remesh_FitSystem_h
#define remesh_FitSystem_h

#include "Placement/StarFit.h"
#include "Support/ConjugateGradients.h"

#include <Eigen/Core>

namespace remesh
{
/** A symmetric 3 x 3 matrix: xx, xy, xz, yy, yz, zz. */
template <class Real>
using Symmetric3 = Eigen::Matrix<Real, 6, 1>;

/**
 * min over displacements d of sum_p W_p (n_p . (sum_k w_pk d_k - r_p))^2, over the samples p with
 * their residuals r_p and feet w_pk, plus springs along the edges and damping (FitSystem.cxx): one
 * block for each vertex and one for each edge of the mesh (w_i w_j n n^T is symmetric).
 */
struct FitSystem
{
  std::vector<Symmetric3<double>> vertexBlocks; ///< K, definite but at frozen vertices
  /**
   * E; the solver's time goes into reading them. Floats lose 1e-8 to 2e-7 of a vertex's weight, and
   * the damping is at least 9e-7 of it: the system stays definite.
   */
  std::vector<Symmetric3<float>> edgeBlocks;
  std::vector<Point3> slopes;    ///< K, the right-hand side; 0 at fixed vertices
  std::vector<double> weights;   ///< K, sum of W_p w_pv^2, areas in FitSamples::unit() squared
  std::vector<double> stiffness; ///< K, of the springs

  std::vector<Point3> triangleNormals; ///< T, sum of W n over the samples of each triangle
  std::vector<StarBlock> blockSums;    ///< scratch, whose memory the next round uses again

  struct Link
  {
    Index vertex;
    Index edge;
  };
  std::vector<Offset> linkBegins;    ///< K + 1, into `links`
  std::vector<Link> links;           ///< the edges at each vertex
  std::vector<Triple> triangleEdges; ///< T x 3, as in an EdgeTable
  std::vector<char> frozen;          ///< K, vertices that must not move

  Point3 row(const VectorField& x, std::size_t i) const;
  /** By the inverse of the vertex's block; zero at frozen vertices. */
  Point3 precondition(const Point3& r, std::size_t i) const;
};

/** The mesh's edges as links, and room for their blocks. O(T). */
FitSystem makeFitSystem(const PlacementProblem& problem);

/**
 * Ties each sample of the surface to the closest point of the triangles around its own vertex that
 * face the same way (so never to another sheet), and sums up the system. Vertices without triangles
 * or fixed are frozen.
 *
 * @param shapes K, the positions whose shapes the springs keep.
 * Cost: O(samples). Parallel over blocks of vertices, whose sums are added in a fixed order.
 *
 * @return false when cancelled.
 */
[[nodiscard]] bool assembleFit(const PlacementProblem& problem, const VertexStars& stars,
  const std::vector<Point3>& positions, const std::vector<Point3>& shapes, FitSamples& samples,
  const RunControl& control, FitSystem& system);
}

#endif
