/**
 * @file SparseFactor.h
 * @brief The factor L D L' of a sparse symmetric matrix, and solutions with it.
 *
 * 1. An order of the unknowns that keeps L sparse (approximate minimum degree, by Eigen), and the
 *    pattern of L from the elimination tree.
 * 2. L row by row, each by a sparse triangular system.
 * 3. Solutions for several right-hand sides at a time: each entry of L is read once for all.
 *
 * There is no pivoting: a zero on the way is an error. The signs of D are those of the eigenvalues
 * (J. Sylvester, 1852).
 *
 * Source: T. Davis, "Algorithm 849: a concise sparse Cholesky factorization package", ACM TOMS 31,
 * 2005. Cost: of a surface's matrix O(n^1.5) time and O(n log n) memory, one thread; a solution
 * O(n log n) for each right-hand side, in parallel.
 */
#ifndef remesh_SparseFactor_h
#define remesh_SparseFactor_h

#include "Support/Parallel.h"
#include "Support/Types.h"

#include <Eigen/SparseCore>

#include <vector>

namespace remesh
{
enum class FactorOutcome
{
  Done,
  Singular, ///< or not finite
  Cancelled
};

class SparseFactor
{
public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

  /** Orders the unknowns. @param lower the lower triangle; values do not count. */
  void analyze(const Matrix& lower);

  /** Factors a matrix of the analyzed pattern. Cancelling is heard within milliseconds. */
  [[nodiscard]] FactorOutcome factorize(const Matrix& lower, const RunControl& control);

  /** How many eigenvalues of the matrix are negative. */
  Index negatives() const;

  /**
   * Columns of the inverse times `right`, n x any, which may be `solution` itself.
   *
   * @return false when cancelled. Deterministic: a column does not depend on the others.
   */
  template <class Dense>
  [[nodiscard]] bool solve(const Dense& right, const RunControl& control, Dense& solution) const
  {
    solution.resize(right.rows(), right.cols());
    return forEachBlock((right.cols() + width - 1) / width, control,
      [&](Offset group)
      {
        const Offset first = group * width;
        const Offset count = std::min<Offset>(width, right.cols() - first);
        std::vector<double> x(static_cast<std::size_t>(right.rows()) * width, 0.0);
        for (Offset row = 0; row < right.rows(); ++row)
        {
          double* to = x.data() + Offset(m_places[row]) * width;
          for (Offset k = 0; k < count; ++k)
          {
            to[k] = right(row, first + k);
          }
        }
        this->solveGroup(x.data());
        for (Offset row = 0; row < right.rows(); ++row)
        {
          const double* from = x.data() + Offset(m_places[row]) * width;
          for (Offset k = 0; k < count; ++k)
          {
            solution(row, first + k) = from[k];
          }
        }
      });
  }

private:
  static constexpr Offset width = 4; ///< right-hand sides at a time

  void findPattern(const Matrix& upper);
  void solveGroup(double* x) const;

  std::vector<int> m_places;    ///< n, of each unknown in the order
  std::vector<int> m_parents;   ///< n, the elimination tree; -1: a root
  std::vector<Offset> m_begins; ///< n + 1, columns of L
  std::vector<int> m_rows;
  std::vector<double> m_values;
  std::vector<double> m_diagonal; ///< D
};
}

#endif
