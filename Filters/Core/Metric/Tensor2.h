/**
 * @file Tensor2.h
 * @brief Symmetric 2 x 2 matrices: metrics of a plane, where they are positive definite.
 */
#ifndef remesh_Tensor2_h
#define remesh_Tensor2_h

#include <algorithm>
#include <cmath>

namespace remesh
{
/** [xx xy; xy yy]. */
struct Tensor2
{
  double xx = 1.0;
  double xy = 0.0;
  double yy = 1.0;

  double determinant() const { return this->xx * this->yy - this->xy * this->xy; }
  /** The squared length of (x, y). */
  double squared(double x, double y) const
  {
    return this->xx * x * x + 2.0 * this->xy * x * y + this->yy * y * y;
  }
  Tensor2 operator+(const Tensor2& other) const
  {
    return { this->xx + other.xx, this->xy + other.xy, this->yy + other.yy };
  }
  Tensor2 operator*(double factor) const
  {
    return { factor * this->xx, factor * this->xy, factor * this->yy };
  }
};

/** The tensor with the same eigenvectors and the eigenvalues `f` of those of `a`. */
template <class Function>
Tensor2 withEigenvalues(const Tensor2& a, const Function& f)
{
  const double mean = 0.5 * (a.xx + a.yy);
  const double half = 0.5 * (a.xx - a.yy);
  const double radius = std::sqrt(half * half + a.xy * a.xy);
  // Of two positive ones the smaller is what the determinant says, not a difference.
  const double large = mean + radius;
  const double small =
    large > 0.0 && a.determinant() > 0.0 ? a.determinant() / large : mean - radius;
  const double of[2] = { f(large), f(small) };
  const double middle = 0.5 * (of[0] + of[1]);
  const double slope = radius > 0.0 ? 0.5 * (of[0] - of[1]) / radius : 0.0;
  return { middle + slope * half, slope * a.xy, middle - slope * half };
}

inline Tensor2 logarithm(const Tensor2& a)
{
  return withEigenvalues(a, [](double value) { return std::log(value); });
}

inline Tensor2 exponential(const Tensor2& a)
{
  // Eigenvalues of any sign: no determinant.
  const double mean = 0.5 * (a.xx + a.yy);
  const double half = 0.5 * (a.xx - a.yy);
  const double radius = std::sqrt(half * half + a.xy * a.xy);
  const double large = std::exp(mean + radius);
  const double small = std::exp(mean - radius);
  const double middle = 0.5 * (large + small);
  const double slope = radius > 0.0 ? 0.5 * (large - small) / radius : 0.0;
  return { middle + slope * half, slope * a.xy, middle - slope * half };
}

inline Tensor2 squareRoot(const Tensor2& a)
{
  return withEigenvalues(a, [](double value) { return std::sqrt(std::max(value, 0.0)); });
}

inline Tensor2 inverse(const Tensor2& a)
{
  const double scale = 1.0 / a.determinant();
  return { scale * a.yy, -scale * a.xy, scale * a.xx };
}

/** a b a. */
inline Tensor2 sandwich(const Tensor2& a, const Tensor2& b)
{
  const double p = b.xx * a.xx + b.xy * a.xy; // b a
  const double q = b.xx * a.xy + b.xy * a.yy;
  const double r = b.xy * a.xx + b.yy * a.xy;
  const double s = b.xy * a.xy + b.yy * a.yy;
  return { a.xx * p + a.xy * r, a.xx * q + a.xy * s, a.xy * q + a.yy * s };
}

/** The eigenvalues of a^-1 b: squares of factors between lengths in b and in a. */
struct RelativeSizes
{
  double min;
  double max;
};

inline RelativeSizes relativeSizes(const Tensor2& a, const Tensor2& b)
{
  const double determinant = a.determinant();
  const double half = 0.5 * (a.yy * b.xx - 2.0 * a.xy * b.xy + a.xx * b.yy) / determinant;
  const double product = b.determinant() / determinant;
  const double large = half + std::sqrt(std::max(half * half - product, 0.0));
  return { product / large, large };
}

/**
 * The smallest metric in which nothing is shorter than in `a` or in `b`: both reduced at once, and
 * the larger taken of each pair of eigenvalues.
 */
inline Tensor2 intersection(const Tensor2& a, const Tensor2& b)
{
  const Tensor2 root = squareRoot(a);
  const Tensor2 other = sandwich(inverse(root), b);
  return sandwich(root, withEigenvalues(other, [](double value) { return std::max(value, 1.0); }));
}
}

#endif
