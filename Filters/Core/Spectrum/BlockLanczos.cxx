#include "Spectrum/BlockLanczos.h"

#include "Support/Parallel.h"
#include "Support/Random.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace remesh
{
namespace
{
constexpr Index blockSize = 8;        // equal eigenvalues up to that many are found at once
constexpr double converged = 1e-9;    // residual of theta, relative to it
constexpr std::uint64_t drawing = 23; // a stream of random numbers of its own

/** Whether there is nothing but zeros beside the diagonal. */
bool isDiagonal(const SparseRows& matrix)
{
  for (Index row = 0; row < matrix.rows(); ++row)
  {
    for (SparseRows::InnerIterator entry(matrix, row); entry; ++entry)
    {
      if (entry.col() != row && entry.value() != 0.0)
      {
        return false;
      }
    }
  }
  return true;
}

/** Dense algebra on tall matrices, by rows in fixed blocks. */
class TallAlgebra
{
public:
  TallAlgebra(const SurfaceLaplacian& laplacian, const RunControl& control)
    : m_laplacian(laplacian)
    , m_control(control.silent())
    , m_blocks(Blocks::cut(laplacian.size, 64, 1 << 12))
    , m_isDiagonal(isDiagonal(laplacian.mass))
  {
    if (m_isDiagonal)
    {
      m_diagonal = laplacian.mass.diagonal();
    }
  }

  bool done() const { return m_done; }

  /** M x. */
  Eigen::MatrixXd weighted(const Eigen::MatrixXd& x)
  {
    Eigen::MatrixXd product(x.rows(), x.cols());
    this->overRows(
      [&](Offset begin, Offset length)
      {
        if (m_isDiagonal)
        {
          product.middleRows(begin, length) =
            m_diagonal.segment(begin, length).asDiagonal() * x.middleRows(begin, length);
          return;
        }
        for (Offset row = begin; row < begin + length; ++row)
        {
          product.row(row).setZero();
          for (SparseRows::InnerIterator entry(m_laplacian.mass, row); entry; ++entry)
          {
            product.row(row) += entry.value() * x.row(entry.col());
          }
        }
      });
    return product;
  }

  /** a' b. */
  Eigen::MatrixXd product(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::MatrixXd& b)
  {
    std::vector<Eigen::MatrixXd> parts(static_cast<std::size_t>(m_blocks.count()));
    m_done = m_done &&
      forEachBlock(m_blocks.count(), m_control,
        [&](Offset block)
        {
          const Offset begin = m_blocks.begin(block);
          const Offset length = m_blocks.end(block) - begin;
          parts[block].noalias() =
            a.middleRows(begin, length).transpose() * b.middleRows(begin, length);
        });
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(a.cols(), b.cols());
    for (std::size_t k = 0; k < parts.size() && m_done; ++k)
    {
      sum += parts[k];
    }
    return sum;
  }

  /** b -= a c. */
  void subtract(
    const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::MatrixXd& c, Eigen::MatrixXd& b)
  {
    this->overRows([&](Offset begin, Offset length)
      { b.middleRows(begin, length).noalias() -= a.middleRows(begin, length) * c; });
  }

  /** a c. */
  Eigen::MatrixXd combined(const Eigen::Ref<const Eigen::MatrixXd>& a, const Eigen::MatrixXd& c)
  {
    Eigen::MatrixXd result(a.rows(), c.cols());
    this->overRows([&](Offset begin, Offset length)
      { result.middleRows(begin, length).noalias() = a.middleRows(begin, length) * c; });
    return result;
  }

  /** Takes the means in M out of the columns, on each component where constants have no energy. */
  void takeMeansOut(Eigen::MatrixXd& x)
  {
    const Eigen::MatrixXd weights = this->weighted(x);
    if (m_masses.size() == 0)
    {
      const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(x.rows(), 1);
      m_masses = Eigen::VectorXd::Zero(m_laplacian.numberOfConstants);
      const Eigen::MatrixXd own = this->weighted(ones);
      this->forEachConstant([&](Index row, Index c) { m_masses[c] += own(row, 0); });
    }
    Eigen::MatrixXd means = Eigen::MatrixXd::Zero(m_masses.size(), x.cols());
    this->forEachConstant([&](Index row, Index c) { means.row(c) += weights.row(row); });
    means = m_masses.cwiseInverse().asDiagonal() * means;
    this->forEachConstant([&](Index row, Index c) { x.row(row) -= means.row(c); });
  }

private:
  template <class Body>
  void overRows(const Body& body)
  {
    m_done = m_done &&
      forEachRange(
        m_blocks, m_control, [&](Offset begin, Offset end) { body(begin, end - begin); });
  }

  template <class Body>
  void forEachConstant(const Body& body) const
  {
    for (Index row = 0; row < m_laplacian.size; ++row)
    {
      if (m_laplacian.constants[row] != noIndex)
      {
        body(row, m_laplacian.constants[row]);
      }
    }
  }

  const SurfaceLaplacian& m_laplacian;
  RunControl m_control;
  Blocks m_blocks;
  bool m_isDiagonal;          ///< the mass matrix
  Eigen::VectorXd m_diagonal; ///< then
  Eigen::VectorXd m_masses;   ///< of the components
  bool m_done = true;
};

class Lanczos
{
public:
  Lanczos(const ShiftedLaplacian& shifted, const Eigen::MatrixXd& known, const RunControl& control)
    : m_shifted(shifted)
    , m_known(known)
    , m_control(control)
    , m_algebra(shifted.laplacian(), control)
  {
  }

  bool run(Index most, FoundBand& band)
  {
    const SurfaceLaplacian& laplacian = m_shifted.laplacian();
    const Index rank =
      laplacian.size - laplacian.numberOfConstants - static_cast<Index>(m_known.cols());
    m_basis.resize(laplacian.size, std::min(rank, most) + blockSize);
    m_projected = Eigen::MatrixXd::Zero(m_basis.cols(), m_basis.cols());
    Eigen::MatrixXd next(laplacian.size, blockSize);
    // Another start where functions are known: of equal eigenvalues they are all that was in
    // theirs.
    const auto seed = static_cast<std::uint64_t>(m_known.cols());
    for (Eigen::Index k = 0; k < next.size(); ++k)
    {
      next.data()[k] = uniform01(seed, static_cast<std::uint64_t>(k), drawing) - 0.5;
    }
    Index begin = 0;
    Index added = this->append(next, 0);
    while (added > 0 && m_algebra.done() && m_size < std::min(rank, most))
    {
      m_control.report(static_cast<double>(m_size) / std::min(rank, most));
      const Eigen::MatrixXd last = m_basis.middleCols(begin, added);
      const Index from = begin;
      begin = m_size;
      if (!m_shifted.solve(m_algebra.weighted(last), m_control.silent(), next))
      {
        return false;
      }
      added = this->append(next, from);
    }
    return m_algebra.done() && (m_size == 0 || this->extract(begin, band));
  }

private:
  /**
   * Makes vectors orthonormal to the basis and to each other, and adds those that are not
   * dependent. `column`: of the projected operator, whose images they are.
   */
  Index append(Eigen::MatrixXd& next, Index column)
  {
    const bool isImage = m_size > 0;
    const Eigen::Index count = next.cols();
    m_algebra.takeMeansOut(next);
    if (m_known.cols() > 0)
    {
      m_algebra.subtract(m_known, m_algebra.product(m_known, m_algebra.weighted(next)), next);
    }
    double scale = 0.0; // of the squared norms of what comes
    if (isImage)
    {
      // Nearly all that is not new is in the last two blocks; one pass over the basis does then.
      scale = this->subtractFrom(m_previous, column, next);
      this->subtractFrom(0, column, next);
    }
    Eigen::MatrixXd toNext = Eigen::MatrixXd::Identity(count, count);
    if (!this->orthonormalize(scale, next, toNext))
    {
      return 0;
    }
    m_previous = column;
    const auto added = std::min<Eigen::Index>(next.cols(), m_basis.cols() - m_size);
    m_basis.middleCols(m_size, added) = next.leftCols(added);
    if (isImage)
    {
      m_projected.block(m_size, column, added, count) = toNext.topRows(added);
    }
    m_size += static_cast<Index>(added);
    return static_cast<Index>(added);
  }

  /**
   * Makes vectors orthonormal to each other, and leaves out those that are dependent.
   *
   * @param scale of the squared norms, before the basis was taken out of them.
   * @param toNext is multiplied by what makes the old vectors of the new ones.
   * @return false if none is left, or when cancelled.
   */
  bool orthonormalize(double scale, Eigen::MatrixXd& next, Eigen::MatrixXd& toNext)
  {
    constexpr double dependent = 1e-26; // squared: what rounding leaves
    constexpr double doubtful = 1e-8;   // squared: where rounding counts, another pass
    for (int pass = 0; pass < 2; ++pass)
    {
      const Eigen::MatrixXd gram = m_algebra.product(next, m_algebra.weighted(next));
      if (!m_algebra.done()) // what was not computed is anything
      {
        return false;
      }
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
      scale = std::max(scale, gram.diagonal().maxCoeff());
      const double least = pass == 0 ? dependent * scale : 0.5;
      const auto kept = (solver.eigenvalues().array() > least).count();
      if (kept == 0)
      {
        return false;
      }
      const Eigen::MatrixXd vectors = solver.eigenvectors().rightCols(kept);
      const Eigen::VectorXd roots = solver.eigenvalues().tail(kept).cwiseSqrt();
      next = m_algebra.combined(next, vectors * roots.cwiseInverse().asDiagonal());
      toNext = (roots.asDiagonal() * vectors.transpose() * toNext).eval();
      if (m_size > 0 && pass == 0 && roots[0] * roots[0] < doubtful * scale)
      {
        const auto basis = m_basis.leftCols(m_size);
        m_algebra.subtract(basis, m_algebra.product(basis, m_algebra.weighted(next)), next);
      }
    }
    return true;
  }

  /** Takes the part in the basis, from a column on, out; its largest squared norm. */
  double subtractFrom(Index first, Index column, Eigen::MatrixXd& next)
  {
    const auto basis = m_basis.middleCols(first, m_size - first);
    const Eigen::MatrixXd part = m_algebra.product(basis, m_algebra.weighted(next));
    m_algebra.subtract(basis, part, next);
    m_projected.block(first, column, m_size - first, next.cols()) += part;
    return part.colwise().squaredNorm().maxCoeff();
  }

  /** Ritz pairs of the basis but for its last block, whose part of the images is the residual. */
  bool extract(Index inner, FoundBand& band)
  {
    inner = inner == m_size || inner == 0 ? m_size : inner;
    const Eigen::MatrixXd own = m_projected.topLeftCorner(inner, inner);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (own + own.transpose()));
    const Eigen::VectorXd& thetas = solver.eigenvalues();
    const Eigen::MatrixXd rest =
      m_projected.block(inner, 0, m_size - inner, inner) * solver.eigenvectors();
    std::vector<Index> order(static_cast<std::size_t>(inner));
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
      [&](Index a, Index b) { return std::abs(thetas[a]) > std::abs(thetas[b]); });
    const auto end = std::find_if(order.begin(), order.end(),
      [&](Index k)
      { return m_size > inner && !(rest.col(k).norm() <= converged * std::abs(thetas[k])); });
    const bool all = end == order.end();
    const double reach =
      all ? std::numeric_limits<double>::infinity() : 1.0 / std::abs(thetas[*end]);
    band.low = m_shifted.shift() - reach;
    band.high = m_shifted.shift() + reach;
    order.erase(end, order.end());
    const auto valueOf = [&](Index k) { return m_shifted.shift() + 1.0 / thetas[k]; };
    std::sort(
      order.begin(), order.end(), [&](Index a, Index b) { return valueOf(a) < valueOf(b); });
    Eigen::MatrixXd chosen(inner, static_cast<Eigen::Index>(order.size()));
    band.pairs.values.clear();
    for (std::size_t k = 0; k < order.size(); ++k)
    {
      band.pairs.values.push_back(valueOf(order[k]));
      chosen.col(static_cast<Eigen::Index>(k)) = solver.eigenvectors().col(order[k]);
    }
    band.pairs.functions = m_algebra.combined(m_basis.leftCols(inner), chosen);
    return m_algebra.done();
  }

  const ShiftedLaplacian& m_shifted;
  const Eigen::MatrixXd& m_known;
  RunControl m_control;
  TallAlgebra m_algebra;
  Eigen::MatrixXd m_basis;     ///< n x most, of which `m_size` are there
  Eigen::MatrixXd m_projected; ///< of the operator, in the basis
  Index m_size = 0;
  Index m_previous = 0; ///< the block before the last one begins there
};
}

ShiftedLaplacian::ShiftedLaplacian(const SurfaceLaplacian& laplacian)
  : m_laplacian(laplacian)
  , m_stiffness(laplacian.stiffness.triangularView<Eigen::Lower>())
  , m_mass(laplacian.mass.triangularView<Eigen::Lower>())
{
  m_factor.analyze(m_stiffness);
}

Status ShiftedLaplacian::factor(double shift, const RunControl& control)
{
  constexpr int tries = 5;
  constexpr double aside = 1e-5; // of the shift, where it hits an eigenvalue
  for (int k = 0; k < tries; ++k)
  {
    m_shift = shift * (1.0 + k * aside);
    switch (m_factor.factorize(m_stiffness - m_shift * m_mass, control))
    {
      case FactorOutcome::Done:
        m_below = m_factor.negatives();
        return Status::success();
      case FactorOutcome::Cancelled:
        return Status::cancelled();
      default:
        break;
    }
  }
  return Status::invalid("The Laplacian cannot be factored: the surface has triangles whose angles "
                         "are nothing but rounding. Remesh it first.");
}

bool ShiftedLaplacian::solve(
  const Eigen::MatrixXd& right, const RunControl& control, Eigen::MatrixXd& solution) const
{
  return m_factor.solve(right, control, solution);
}

bool findAround(const ShiftedLaplacian& shifted, const Eigen::MatrixXd& known, Index basis,
  const RunControl& control, FoundBand& band)
{
  return Lanczos(shifted, known, control).run(basis, band);
}
}
