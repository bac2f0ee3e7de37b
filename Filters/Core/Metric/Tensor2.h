/**
 * @file Tensor2.h
 * @brief Symmetric positive definite 2 x 2 matrices: metrics of a plane.
 */
#ifndef remesh_Tensor2_h
#define remesh_Tensor2_h

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
}

#endif
