// Support/SparseFactor: solutions against dense ones, signs, singular matrices, cancelling.

#include "Support/SparseFactor.h"
#include "TestSupport.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>

using namespace remesh;
using namespace remesh::test;

namespace
{
using Matrix = SparseFactor::Matrix;

/** The Laplacian of a grid of n x n points, less a shift. */
Matrix gridMatrix(int n, double shift)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      entries.emplace_back(n * i + j, n * i + j, 4.0 + 0.01 * i - shift);
      if (i > 0)
      {
        entries.emplace_back(n * i + j, n * i + j - n, -1.0);
      }
      if (j > 0)
      {
        entries.emplace_back(n * i + j, n * i + j - 1, -1.0);
      }
    }
  }
  Matrix lower(n * n, n * n);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

/** One column and several, in both layouts; as many negative signs as there are eigenvalues. */
void testSolutions()
{
  constexpr int n = 9;
  SparseFactor factor;
  factor.analyze(gridMatrix(n, 0.0));
  for (const double shift : { 0.0, 1.3, 3.77 })
  {
    const Matrix lower = gridMatrix(n, shift);
    const Eigen::MatrixXd dense = Matrix(lower.selfadjointView<Eigen::Lower>());
    CHECK(factor.factorize(lower, RunControl()) == FactorOutcome::Done);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(dense);
    CHECK_EQUAL(
      factor.negatives(), static_cast<Index>((solver.eigenvalues().array() < 0.0).count()));
    Eigen::MatrixXd right(n * n, 7);
    for (Eigen::Index k = 0; k < right.size(); ++k)
    {
      right.data()[k] = std::sin(1.0 + static_cast<double>(k * k));
    }
    const Eigen::MatrixXd expected = dense.fullPivLu().solve(right);
    Eigen::MatrixXd solution;
    CHECK(factor.solve(right, RunControl(), solution));
    CHECK((solution - expected).norm() < 1e-9 * expected.norm());
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Rows inPlace = right.leftCols(5);
    CHECK(factor.solve(inPlace, RunControl(), inPlace));
    CHECK(Eigen::MatrixXd(inPlace) == solution.leftCols(5)); // a column is what it is alone
  }
}

void testFailures()
{
  SparseFactor factor;
  Matrix lower = gridMatrix(5, 0.0);
  factor.analyze(lower);
  const RunControl stopped(nullptr, [] { return true; });
  CHECK(factor.factorize(lower, stopped) == FactorOutcome::Cancelled);
  CHECK(factor.factorize(lower * 0.0, RunControl()) == FactorOutcome::Singular);
  CHECK(factor.factorize(lower, RunControl()) == FactorOutcome::Done);
  Eigen::MatrixXd right = Eigen::MatrixXd::Ones(25, 2);
  CHECK(!factor.solve(right, stopped, right));
}
}

int TestSparseFactor(int, char*[])
{
  testSolutions();
  testFailures();
  return result();
}
