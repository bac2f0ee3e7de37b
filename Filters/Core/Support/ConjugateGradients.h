/**
 * @file ConjugateGradients.h
 * @brief Conjugate gradients for large sparse systems, the same on any threads.
 */
#ifndef remesh_ConjugateGradients_h
#define remesh_ConjugateGradients_h

#include "Support/Parallel.h"

namespace remesh
{
using VectorField = std::vector<Point3>;

struct ConjugateGradientsLimits
{
  int iterations = 400;
  double reduction = 1e-4; ///< of the residual's norm, in the metric of the preconditioner
};

/**
 * The steps of conjugate gradients, whatever the vectors are.
 *
 * @param blocks of the rows; sums are added up in them.
 * @param descent does what is to be done at row i, in double precision:
 * `double begin(i)` sets the first direction, the rest preconditioned; `double apply(i)` the
 * direction's image; `double move(i, length)` goes so far along the direction, and preconditions
 * the rest; `void turn(i, factor)` adds the direction, times a factor, to that as the next one.
 * What they return is added up: the rest times itself preconditioned, and direction times image.
 * @return false when cancelled.
 */
template <class Descent>
[[nodiscard]] bool descendConjugately(const Blocks& blocks, const ConjugateGradientsLimits& limits,
  const RunControl& control, Descent& descent)
{
  double product = 0.0; // of the residual with itself, in the metric of the preconditioner
  bool done = sumInBlocks(
    blocks, control, [&](std::size_t i) { return descent.begin(i); }, product);
  const double goal = limits.reduction * limits.reduction * product;
  for (int k = 0; done && k < limits.iterations && product > goal && product > 0.0; ++k)
  {
    double curvature = 0.0;
    done = sumInBlocks(
      blocks, control, [&](std::size_t i) { return descent.apply(i); }, curvature);
    if (!done || !(curvature > 0.0))
    {
      break; // rounding is all that is left
    }
    const double before = product;
    const double length = before / curvature;
    done = sumInBlocks(
      blocks, control, [&](std::size_t i) { return descent.move(i, length); }, product);
    const double factor = product / before;
    done = done &&
      forEachItem(
        blocks, control, [&](Offset i) { descent.turn(static_cast<std::size_t>(i), factor); });
  }
  return done;
}

/** The descent of `solveConjugateGradients`. */
template <class Matrix, class Vector>
class VectorDescent
{
public:
  VectorDescent(const Matrix& matrix, std::vector<Vector>& residual, VectorField& x)
    : m_matrix(matrix)
    , m_residual(residual)
    , m_x(x)
    , m_direction(x.size())
    , m_image(x.size())
  {
  }

  double begin(std::size_t i)
  {
    m_direction[i] = m_matrix.precondition(m_residual[i], i);
    return static_cast<double>(m_residual[i].dot(m_direction[i]));
  }
  double apply(std::size_t i)
  {
    m_image[i] = m_matrix.row(m_direction, i);
    return static_cast<double>(m_image[i].dot(m_direction[i]));
  }
  double move(std::size_t i, double length)
  {
    m_x[i] += length * m_direction[i].template head<3>().template cast<double>();
    m_residual[i] -= static_cast<Scalar>(length) * m_image[i];
    m_image[i] = m_matrix.precondition(m_residual[i], i); // the image itself has served
    return static_cast<double>(m_residual[i].dot(m_image[i]));
  }
  void turn(std::size_t i, double factor)
  {
    m_direction[i] = m_image[i] + static_cast<Scalar>(factor) * m_direction[i];
  }

private:
  using Scalar = typename Vector::Scalar;

  const Matrix& m_matrix;
  std::vector<Vector>& m_residual;
  VectorField& m_x;
  std::vector<Vector> m_direction;
  std::vector<Vector> m_image;
};

/**
 * Solves A x = b for a symmetric positive definite A, starting from x.
 *
 * The steps are worked out with `Vector`: that of doubles, or one of floats, whose fourth number is
 * 0. Floats halve the memory that is read, and do where a few digits of the way from the start are
 * wanted; x is kept in double precision all the same.
 *
 * @param matrix has `Vector row(const std::vector<Vector>& x, std::size_t i) const`, the i-th
 * vector of A x, and `Vector precondition(const Vector& r, std::size_t i) const`, symmetric
 * positive definite and local.
 * @param x the start, replaced by the solution.
 * @param residual b - A x at the start; used as work space.
 * @return false when cancelled; x is then not to be used.
 * Deterministic: the blocks of the sums depend on the size alone. Cost: O(nonzeros) per iteration.
 */
template <class Matrix, class Vector>
bool solveConjugateGradients(const Matrix& matrix, const ConjugateGradientsLimits& limits,
  const RunControl& control, std::vector<Vector>& residual, VectorField& x)
{
  const Blocks blocks = Blocks::cut(static_cast<Offset>(x.size()), 64, 1 << 15);
  VectorDescent<Matrix, Vector> descent(matrix, residual, x);
  return descendConjugately(blocks, limits, control.silent(), descent);
}
}

#endif
