/**
 * @file TensorAlgebra.h
 * @brief Functions of symmetric 2 x 2 matrices by their eigenvalues, and the intersection of two
 *        metrics.
 */
#ifndef remesh_TensorAlgebra_h
#define remesh_TensorAlgebra_h

#include "Metric/Tensor2.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
/** The two eigenvalues, first >= second, and the unit eigenvector (x, y) of the first. */
struct Spectrum2
{
  double first = 1.0;
  double second = 1.0;
  double x = 1.0;
  double y = 0.0;

  Tensor2 tensor() const
  {
    return { this->first * this->x * this->x + this->second * this->y * this->y,
      (this->first - this->second) * this->x * this->y,
      this->first * this->y * this->y + this->second * this->x * this->x };
  }
};

inline Spectrum2 spectrumOf(const Tensor2& tensor)
{
  const double mean = 0.5 * (tensor.xx + tensor.yy);
  const double half = 0.5 * (tensor.xx - tensor.yy);
  const double radius = std::hypot(half, tensor.xy);
  Spectrum2 spectrum{ mean + radius, mean - radius, 1.0, 0.0 };
  const double x = half >= 0.0 ? half + radius : tensor.xy;
  const double y = half >= 0.0 ? tensor.xy : radius - half;
  if (const double length = std::hypot(x, y); length > 0.0)
  {
    spectrum.x = x / length;
    spectrum.y = y / length;
  }
  return spectrum;
}

/** The tensor with `function` of each eigenvalue in its place. */
template <class Function>
Tensor2 mapEigenvalues(const Tensor2& tensor, const Function& function)
{
  Spectrum2 spectrum = spectrumOf(tensor);
  spectrum.first = function(spectrum.first);
  spectrum.second = function(spectrum.second);
  return spectrum.tensor();
}

/** The eigenvalues without their signs. */
inline Tensor2 absolute(const Tensor2& tensor)
{
  return mapEigenvalues(tensor, [](double value) { return std::abs(value); });
}

/**
 * The metric that asks for short edges wherever one of two does: both are diagonal in one basis
 * (simultaneous reduction), and each entry is the larger one. Both positive definite.
 */
inline Tensor2 intersection(const Tensor2& a, const Tensor2& b)
{
  // a = L L', and L^-1 b L^-T has the eigenvalues of b relative to a.
  const double l = std::sqrt(a.xx);
  const double m = a.xy / l;
  const double n = std::sqrt(std::max(a.determinant(), 0.0) / a.xx);
  const double u = b.xy / l - m * b.xx / (l * l);
  const Tensor2 relative{ b.xx / (l * l), u / n, (b.yy - m * b.xy / l - m * u) / (n * n) };
  const Tensor2 larger =
    mapEigenvalues(relative, [](double value) { return std::max(value, 1.0); });
  return { l * l * larger.xx, l * (m * larger.xx + n * larger.xy),
    m * m * larger.xx + 2.0 * m * n * larger.xy + n * n * larger.yy };
}
}

#endif
