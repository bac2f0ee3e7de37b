/**
 * @file Symmetric3.h
 * @brief Symmetric 3 x 3 matrices as six numbers.
 */
#ifndef remesh_Symmetric3_h
#define remesh_Symmetric3_h

#include "Support/Types.h"

#include <Eigen/Core>

namespace remesh
{
/** xx, xy, xz, yy, yz, zz. */
template <class Real>
using Symmetric3 = Eigen::Matrix<Real, 6, 1>;

template <class Real>
Point3 multiply(const Symmetric3<Real>& a, const Point3& x)
{
  return { a[0] * x[0] + a[1] * x[1] + a[2] * x[2], a[1] * x[0] + a[3] * x[1] + a[4] * x[2],
    a[2] * x[0] + a[4] * x[1] + a[5] * x[2] };
}

inline Eigen::Matrix3d matrixOf(const Symmetric3<double>& a)
{
  Eigen::Matrix3d matrix;
  matrix << a[0], a[1], a[2], a[1], a[3], a[4], a[2], a[4], a[5];
  return matrix;
}

/** The upper triangle alone: symmetric to the last bit. */
inline Symmetric3<double> symmetricOf(const Eigen::Matrix3d& a)
{
  Symmetric3<double> upper;
  upper << a(0, 0), a(0, 1), a(0, 2), a(1, 1), a(1, 2), a(2, 2);
  return upper;
}

/** a b^T + b a^T, halved. */
inline Symmetric3<double> symmetricProduct(const Point3& a, const Point3& b)
{
  Symmetric3<double> product;
  product << a[0] * b[0], 0.5 * (a[0] * b[1] + a[1] * b[0]), 0.5 * (a[0] * b[2] + a[2] * b[0]),
    a[1] * b[1], 0.5 * (a[1] * b[2] + a[2] * b[1]), a[2] * b[2];
  return product;
}
}

#endif
