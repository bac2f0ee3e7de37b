/**
 * @file ConjugateGradients.h
 * @brief Conjugate gradients for large sparse systems of vectors of R^3, the same on any threads.
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
  using Scalar = typename Vector::Scalar;
  const RunControl silent = control.silent();
  const Blocks blocks = Blocks::cut(static_cast<Offset>(x.size()), 64, 1 << 15);
  std::vector<Vector> direction(x.size()), image(x.size());
  double product = 0.0; // of the residual with itself, in the metric of the preconditioner
  const auto start = [&](std::size_t i)
  {
    direction[i] = matrix.precondition(residual[i], i);
    return static_cast<double>(residual[i].dot(direction[i]));
  };
  const auto curve = [&](std::size_t i)
  {
    image[i] = matrix.row(direction, i);
    return static_cast<double>(image[i].dot(direction[i]));
  };
  const auto move = [&](std::size_t i, double step)
  {
    x[i] += step * direction[i].template head<3>().template cast<double>();
    residual[i] -= static_cast<Scalar>(step) * image[i];
    image[i] = matrix.precondition(residual[i], i); // the image itself has served
    return static_cast<double>(residual[i].dot(image[i]));
  };
  bool done = sumInBlocks(blocks, silent, start, product);
  const double goal = limits.reduction * limits.reduction * product;
  for (int k = 0; done && k < limits.iterations && product > goal && product > 0.0; ++k)
  {
    double curvature = 0.0;
    done = sumInBlocks(blocks, silent, curve, curvature);
    if (!(curvature > 0.0))
    {
      break; // rounding is all that is left
    }
    const double before = product;
    const double step = before / curvature;
    done = done &&
      sumInBlocks(
        blocks, silent, [&](std::size_t i) { return move(i, step); }, product);
    const auto turn = static_cast<Scalar>(product / before);
    done = done &&
      forEachItem(blocks, silent, [&](Offset i) { direction[i] = image[i] + turn * direction[i]; });
  }
  return done;
}
}

#endif
