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
/** 2 x d, on the stack. */
using FacetRows =
  Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::RowMajor, 2, maxEmbeddingDimensions>;

class MetricLaplacian
{
public:
  /** What the surface refers to must outlive it. Of no use when cancelled. O(F). */
  MetricLaplacian(const ShapedFacets& surface, const RunControl& control);

  Index numberOfPoints() const { return m_surface.points; }
  Index numberOfFacets() const { return static_cast<Index>(m_surface.shapes.size()); }
  const ShapedFacets& surface() const { return m_surface; }
  double area(Index facet) const { return m_surface.shapes[facet].area(); }
  double totalArea() const { return m_area; }
  /** V, a third of the area of the facets around each point. */
  const std::vector<double>& masses() const { return m_masses; }

  /** Of each point, 3 facet + k: the facets around it. */
  const Groups& corners() const { return m_corners; }
  /** What a facet adds to G' A G where its corners k and l meet. */
  double entry(Index facet, int k, int l) const
  {
    const auto& weights = m_weights[facet].ofCorner;
    return this->area(facet) * (weights[k][0] * weights[l][0] + weights[k][1] * weights[l][1]);
  }

  FacetRows gradient(const Rows& functions, Index facet) const;

  /** The same; two rows, one after the other. @tparam fixed d, or 0 for any. */
  template <int fixed>
  void gradient(const Rows& functions, Index facet, double* rows) const
  {
    const auto d = fixed > 0 ? fixed : static_cast<int>(functions.cols());
    const Triple& points = m_surface.facetPoints[facet];
    const auto& weights = m_weights[facet].ofCorner;
    const double* const first = functions.data() + Offset(points[0]) * d;
    const double* const second = functions.data() + Offset(points[1]) * d;
    const double* const third = functions.data() + Offset(points[2]) * d;
    for (int k = 0; k < d; ++k)
    {
      rows[k] = weights[1][0] * (second[k] - first[k]);
      rows[d + k] = weights[1][1] * (second[k] - first[k]) + weights[2][1] * (third[k] - first[k]);
    }
  }

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
  /** Of G' A G and that part of the masses. */
  SparseFactor::Matrix lowerTriangle() const;

  template <int fixed>
  bool divergenceIn(const Rows& fields, const RunControl& control, Rows& sums) const;
  /** What the corners' values add to the two rows of the gradient. */
  struct Weights
  {
    double ofCorner[3][2];
  };

  ShapedFacets m_surface;
  std::vector<Weights> m_weights; ///< F
  std::vector<double> m_masses;
  double m_area = 0.0;
  Groups m_corners; ///< of each point: 3 facet + k
  SparseFactor m_factor;
};
}

#endif
