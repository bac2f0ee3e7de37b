/**
 * @file TensorAlgebra.h
 * @brief The eigenvalues and eigenvectors of symmetric 2 x 2 matrices.
 */
#ifndef remesh_TensorAlgebra_h
#define remesh_TensorAlgebra_h

#include "Metric/Tensor2.h"

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

/** The eigenvalues without their signs. */
inline Tensor2 absolute(const Tensor2& tensor)
{
  return withEigenvalues(tensor, [](double value) { return std::abs(value); });
}
}

#endif
