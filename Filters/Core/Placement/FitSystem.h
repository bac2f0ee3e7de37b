/**
 * @file FitSystem.h
 * @brief The normal equations of one round of the surface fit.
 */
#ifndef remesh_FitSystem_h
#define remesh_FitSystem_h

#include "Placement/CellForms.h"
#include "Placement/StarFit.h"
#include "Support/ConjugateGradients.h"

#include <numeric>

namespace remesh
{
/** What the rounds of a fit have in common. */
struct FitTask
{
  const PlacementProblem& problem;
  const VertexStars& stars;
  const CellForms& cells;
  /** K, or nullptr: places that vertices are held at, along the surface. */
  const std::vector<Point3>* anchors = nullptr;
  double hold = 0.0; ///< how much that counts, as a share of the vertices' own weights
};

/** How far the samples are from the triangles, along their own normals. */
struct FitErrors
{
  std::vector<double> squared; ///< K, around the vertices: sum of W_p w_pv r_p^2 ...
  std::vector<double> weights; ///< ... and of W_p w_pv
  double farthest = 0.0;       ///< the greatest r_p^2

  /** The mean square around a vertex; 0 without samples. */
  double around(Index vertex) const
  {
    return this->weights[vertex] > 0.0 ? this->squared[vertex] / this->weights[vertex] : 0.0;
  }
  /** Of the whole mesh. */
  double mean() const
  {
    const double weight = std::accumulate(this->weights.begin(), this->weights.end(), 0.0);
    return weight > 0.0 ? std::accumulate(this->squared.begin(), this->squared.end(), 0.0) / weight
                        : 0.0;
  }
};

/**
 * min over displacements d of sum_p W_p (n_p . (sum_k w_pk d_k - r_p))^2, over the samples p with
 * their residuals r_p and feet w_pk, plus what the triangles' shapes in R^d are worth
 * (ShapeTerm.h), the vertices' ties to anchors if there are any, and damping: one block for each
 * vertex and one for each edge of the mesh (all blocks are symmetric).
 */
struct FitSystem
{
  std::vector<Symmetric3<double>> vertexBlocks; ///< K, definite but at frozen vertices
  std::vector<Symmetric3<double>> inverses;     ///< K, of these; zero at frozen vertices
  /**
   * E; the solver's time goes into reading them. Floats lose 1e-8 to 2e-7 of a vertex's weight, and
   * the damping is at least 1e-6 of it: the system stays definite.
   */
  std::vector<Symmetric3<float>> edgeBlocks;
  std::vector<Point3> slopes;  ///< K, the right-hand side; 0 at fixed vertices
  std::vector<double> weights; ///< K, sum of W_p w_pv^2, areas in FitSamples::unit() squared
  FitErrors errors;            ///< at the positions of the last assembly

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
  Point3 precondition(const Point3& r, std::size_t i) const
  {
    return multiply(this->inverses[i], r);
  }
};

/** The mesh's edges as links, and room for their blocks. O(T). */
FitSystem makeFitSystem(const PlacementProblem& problem);

/**
 * Ties each sample of the surface to the closest point of the triangles around its own vertex that
 * face the same way (so never to another sheet), and sums up the system. Vertices without triangles
 * or fixed are frozen.
 *
 * Cost: O(samples + T). Parallel over blocks of vertices and of triangles, whose sums are added in
 * a fixed order.
 *
 * @return false when cancelled.
 */
[[nodiscard]] bool assembleFit(const FitTask& task, const std::vector<Point3>& positions,
  FitSamples& samples, const RunControl& control, FitSystem& system);
}

#endif
