/**
 * @file LaplacianMatrix.h
 * @brief The matrix of a metric's Laplacian, for systems that need no factor.
 */
#ifndef remesh_LaplacianMatrix_h
#define remesh_LaplacianMatrix_h

#include "Metric/MetricLaplacian.h"

namespace remesh
{
/** G' A G plus some of the masses on its diagonal. */
class LaplacianMatrix
{
public:
  /** The laplacian must outlive it. Of no use when cancelled. O(F), in parallel. */
  LaplacianMatrix(const MetricLaplacian& laplacian, const RunControl& control);

  /**
   * Some steps of conjugate gradients towards the solution, from 0, with all columns as one system.
   *
   * @param right V x d, is lost.
   * @return false when cancelled. In parallel, deterministic.
   */
  [[nodiscard]] bool approach(
    Rows& right, int steps, const RunControl& control, Rows& solution) const;

  /**
   * Makes functions smoother: (L + M / time) f = M f / time. Waves of length w become
   * 1 + time (2 pi / w)² times lower.
   *
   * @return false when cancelled.
   */
  [[nodiscard]] bool smooth(double time, const RunControl& control, Rows& functions);

private:
  struct Entry
  {
    Index column;
    float value;
  };

  /** A place in `m_entries` for a row: that of twice its first corner. */
  Offset begin(Offset point) const { return 2 * m_laplacian.corners().begins[point]; }
  template <int fixed>
  void applyTo(const Rows& functions, Offset point, double* sum) const;
  template <int fixed>
  class Descent;
  template <int fixed>
  bool approachIn(Rows& right, int steps, const RunControl& control, Rows& solution) const;

  const MetricLaplacian& m_laplacian;
  std::vector<Entry> m_entries;   ///< off the diagonal
  std::vector<Index> m_counts;    ///< V, of entries
  std::vector<double> m_diagonal; ///< V
};
}

#endif
