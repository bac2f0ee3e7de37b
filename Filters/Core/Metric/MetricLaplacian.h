/**
 * @file MetricLaplacian.h
 * @brief Gradients on facets of given shapes, their Laplacian, and its one factor.
 *
 * Functions are given at the points of a surface, d at once: V x d, row by row. On a facet of shape
 * R with the differences D (2 x d) of its corners to the first one, their gradient is R^-T D.
 */
#ifndef remesh_MetricLaplacian_h
#define remesh_MetricLaplacian_h

#include "Metric/MetricField.h"
#include "Support/Grouping.h"
#include "Support/SparseFactor.h"

namespace remesh
{
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/** The largest d. */
constexpr int mostEmbeddingDimensions = 16;

/** 2 x d, on the stack. */
using FacetRows =
  Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::RowMajor, 2, mostEmbeddingDimensions>;

class MetricLaplacian
{
public:
  /** Mesh and shapes must outlive it. Of no use when cancelled. O(F). */
  MetricLaplacian(
    const SurfaceMesh& mesh, const std::vector<TargetShape>& shapes, const RunControl& control);

  Index numberOfPoints() const { return m_mesh.numberOfPoints(); }
  Index numberOfFacets() const { return m_mesh.numberOfFacets(); }
  const SurfaceMesh& mesh() const { return m_mesh; }
  double area(Index facet) const { return m_shapes[facet].area(); }
  double totalArea() const { return m_area; }
  /** V, a third of the area of the facets around each point. */
  const std::vector<double>& masses() const { return m_masses; }

  FacetRows gradient(const Rows& functions, Index facet) const;

  /**
   * For each point the sum over its facets, in their order, of area G' X. In parallel.
   *
   * @param fields 2F x d, the X of each facet.
   * @return false when cancelled.
   */
  bool divergence(const Rows& fields, const RunControl& control, Rows& sums) const;

  /**
   * Factors G' A G, which a part in 1e10 of the masses makes regular (SparseFactor.h).
   */
  Status factor(const RunControl& control);

  /** Solves with that factor, in parallel. False when cancelled. */
  bool solve(const Rows& right, const RunControl& control, Rows& solution) const;

private:
  /** What the corners' values add to the two rows of the gradient. */
  struct Weights
  {
    double ofCorner[3][2];
  };

  const SurfaceMesh& m_mesh;
  const std::vector<TargetShape>& m_shapes;
  std::vector<Weights> m_weights; ///< F
  std::vector<double> m_masses;
  double m_area = 0.0;
  Groups m_corners; ///< of each point: 3 facet + k
  SparseFactor m_factor;
};
}

#endif
