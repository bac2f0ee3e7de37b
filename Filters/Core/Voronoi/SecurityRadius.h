/**
 * @file SecurityRadius.h
 * @brief Conservative stopping tests: a neighbour is only skipped when rounding cannot matter.
 *
 * [Levy12] Theorem 1 stops at d(x_i, x_j) > 2 R. Distances are rounded and ties sit exactly at
 * equality, so these tests go on until the exact decision on rounded H values is certain, too:
 * with d > 2 R, |y - x_j|^2 - |y - x_i|^2 >= d (d - 2 R) for each y within R of x_i, which must
 * exceed the rounding of the H values.
 */
#ifndef remesh_SecurityRadius_h
#define remesh_SecurityRadius_h

#include <cmath>

namespace remesh
{
class SecurityRadius
{
public:
  explicit SecurityRadius(int dimension)
    : m_slack(0x1.0p-48 * (dimension + 16))
  {
  }

  /**
   * Whether no site at `distance` or more from x_i can win a point within `radius` of x_i, where
   * `reach` is the largest distance from x_i to a corner of the facet.
   */
  bool excludes(double distance, double radius, double reach) const
  {
    const double extent = distance + reach;
    return distance > 0.0 && distance * (distance - 2.0 * radius) > m_slack * extent * extent;
  }

  /** A radius not below the true one, from its rounded square. */
  double roundUp(double radius2, double reach2) const
  {
    return std::sqrt(radius2 + m_slack * reach2);
  }

private:
  double m_slack;
};
}

#endif
